// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

namespace pixelexact::nektar
{
/// A map by a file's numbers, which are nearly always 0, 1, 2, ...: values side by side, found
/// through a list; only numbers far beyond the others need a hash. Insertion moves values.
template <class Value>
class IdMap
{
public:
  using Entry = std::pair<std::int64_t, Value>;

  [[nodiscard]] std::size_t size() const { return Entries.size(); }
  [[nodiscard]] bool contains(std::int64_t id) const { return IndexOf(id) >= 0; }

  auto begin() const { return Entries.begin(); }
  auto end() const { return Entries.end(); }
  auto end() { return Entries.end(); }
  auto find(std::int64_t id) const { return Found(Entries, id); }
  auto find(std::int64_t id) { return Found(Entries, id); }

  [[nodiscard]] const Value& at(std::int64_t id) const
  {
    const std::int32_t index = IndexOf(id);
    if (index < 0)
    {
      throw std::out_of_range("there is no such number");
    }
    return Entries[static_cast<std::size_t>(index)].second;
  }

  /// The entry, and whether it is new.
  auto try_emplace(std::int64_t id, const Value& value)
  {
    const std::int32_t known = IndexOf(id);
    if (known >= 0)
    {
      return std::pair(Entries.begin() + known, false);
    }
    const auto index = static_cast<std::int32_t>(Entries.size());
    const auto place = static_cast<std::size_t>(id);
    if (id >= 0 && place < kSpread * (Entries.size() + kFirst))
    {
      if (place >= Dense.size())
      {
        Dense.resize(place + 1, -1);
      }
      Dense[place] = index;
    }
    else
    {
      Far[id] = index;
    }
    Entries.emplace_back(id, value);
    return std::pair(Entries.begin() + index, true);
  }

private:
  static constexpr std::size_t kFirst = 1024;
  static constexpr std::size_t kSpread = 4; ///< numbers for each value, at most

  template <class List>
  auto Found(List& entries, std::int64_t id) const
  {
    const std::int32_t index = IndexOf(id);
    return index < 0 ? entries.end() : entries.begin() + index;
  }

  [[nodiscard]] std::int32_t IndexOf(std::int64_t id) const
  {
    if (id >= 0 && static_cast<std::size_t>(id) < Dense.size() &&
      Dense[static_cast<std::size_t>(id)] >= 0)
    {
      return Dense[static_cast<std::size_t>(id)];
    }
    if (Far.empty())
    {
      return -1;
    }
    const auto far = Far.find(id);
    return far == Far.end() ? -1 : far->second;
  }

  std::vector<Entry> Entries;
  std::vector<std::int32_t> Dense; ///< index in Entries by number; -1: none
  std::unordered_map<std::int64_t, std::int32_t> Far;
};
} // namespace pixelexact::nektar
