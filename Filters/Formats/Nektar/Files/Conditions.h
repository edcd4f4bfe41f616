// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Nektar/Files/Document.h"

#include <map>
#include <optional>
#include <span>

namespace pixelexact::nektar
{
/// A session's parameters (CONDITIONS, PARAMETERS). As in Nektar++ the last file with conditions
/// replaces those of earlier files. Each parameter is an expression of those above it; one that
/// cannot be evaluated has no value.
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

/// The homogeneous (quasi-3-D) expansions that a session declares, such as "1D"; nothing without.
std::optional<std::string> HomogeneousType(std::span<const Document* const> session);

/// The end of messages on homogeneous expansions: reason and remedy.
std::string HomogeneousRemedy();
} // namespace pixelexact::nektar
