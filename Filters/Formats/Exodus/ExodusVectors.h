// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pixelexact
{
/// Exodus stores components alone, "velocity_x" and "velocity_y": a field that several variables
/// are the components of.
struct ExodusField
{
  std::string name;
  std::size_t first = 0; ///< the first variable
  std::size_t count = 1; ///< of variables, which follow one another
};

/// The fields of variables, in their order. Names that are the same but for endings in a row, x and
/// y; x, y and z; r and z; or xx, yy, zz, xy, xz and yz, in upper or lower case, are one field with
/// the common beginning as its name, as in VTK's and ParaView's readers. A name that occurs again
/// gets a "_".
std::vector<ExodusField> JoinComponents(const std::vector<std::string>& variables);
} // namespace pixelexact
