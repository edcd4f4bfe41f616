// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Nektar/Reader.h"

namespace pixelexact::nektar
{
/// Adds the fields of a field file's parts, and their time, to a model whose mesh is complete.
/// Throws InvalidData where the parts do not give every element its coefficients once.
void AddFields(
  const std::vector<NamedText>& parts, const std::string& meshName, SolverModel& model);
} // namespace pixelexact::nektar
