// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace pixelexact::gmsh
{
/// From the tags of nodes or elements, which may be sparse, to their places.
class TagIndex
{
public:
  void Reserve(std::size_t tags) { Pairs.reserve(tags); }
  void Add(std::uint64_t tag, std::int32_t place) { Pairs.emplace_back(tag, place); }
  /// To be called once, when all have been added. The first tag that was added twice, if any.
  [[nodiscard]] const std::uint64_t* Finish();
  /// function(tag, place) for each; after Finish.
  template <class Function>
  void ForEach(Function&& function) const
  {
    for (const auto& [tag, place] : Pairs)
    {
      function(tag, place);
    }
    for (std::size_t i = 0; i < Dense.size(); ++i)
    {
      if (Dense[i] >= 0)
      {
        function(First + i, Dense[i]);
      }
    }
  }
  /// -1 where there is no such tag.
  [[nodiscard]] std::int32_t Find(std::uint64_t tag) const;

private:
  std::vector<std::pair<std::uint64_t, std::int32_t>> Pairs; ///< by tag
  std::vector<std::int32_t> Dense; ///< by tag - First, where few are missing
  std::uint64_t First = 0;
  std::uint64_t Twice = 0;
};
} // namespace pixelexact::gmsh
