// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/SolverModel.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
class Hdf5File;
}
namespace pixelexact::flexi
{
/// A text of a file without the blanks that pad it. FLEXI and HOPR write ASCII; other characters,
/// as in damaged files, become question marks.
std::string PlainText(const std::string& text);

/// Whether the file has the solution of a state.
bool IsState(const Hdf5File& file);

/// The positions of nodes along a direction.
enum class Nodes : std::uint8_t
{
  Gauss,
  GaussLobatto
};

/// The description of a state of FLEXI (x_State_0000000.000000000.h5).
struct StateHead
{
  Nodes nodes = Nodes::Gauss;
  int count = 0;  ///< of nodes along xi1 and xi2
  int across = 0; ///< along xi3; 1 in runs in the plane
  std::int64_t elements = 0;
  double time = 0.0;
  std::string mesh; ///< as the file names it; may be empty
  std::vector<std::string> variables;
};

/// Throws InvalidData or Unsupported, with the file's name and the remedy.
StateHead ReadHead(const Hdf5File& state, const std::string& name);

/// Adds the solution, FieldData and ElemData. Notes state what is left out. Throws as ReadHead.
void ReadFields(
  const Hdf5File& state, const StateHead& head, const std::string& name, SolverModel& model);
} // namespace pixelexact::flexi
