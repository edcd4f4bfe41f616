// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Nektar/Files/Document.h"

#include <map>
#include <optional>
#include <span>

namespace pixelexact::nektar
{
/// A session's parameters (CONDITIONS, PARAMETERS), of the last of its files that has conditions:
/// as in Nektar++ they replace those of the files before. Each is an expression of those above it;
/// one that cannot be evaluated has no value.
class Parameters
{
public:
  explicit Parameters(std::span<const Document* const> session);

  [[nodiscard]] std::optional<double> Find(std::string_view name) const;
  [[nodiscard]] std::map<std::string, double> All() const
  {
    return { Values.begin(), Values.end() };
  }

private:
  std::map<std::string, double, std::less<>> Values;
};

/// What a session says of homogeneous (quasi-3-D) expansions, such as "1D", or nothing.
std::optional<std::string> HomogeneousType(std::span<const Document* const> session);

/// The end of a message on homogeneous expansions: why, and what to do.
std::string HomogeneousRemedy();
} // namespace pixelexact::nektar
