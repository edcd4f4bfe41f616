// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Exodus/NetcdfFile.h"

#include <string>
#include <vector>

namespace pixelexact
{
/// An Exodus II file. Numbers start at 1, as in the file, unless stated otherwise. Throws
/// InvalidData with a reason for damaged files; returned numbers are in their range.
class ExodusFile
{
public:
  explicit ExodusFile(const std::string& path);

  /// An element block with elements.
  struct Block
  {
    std::int64_t id = 0;
    std::string type;          ///< upper case: "HEX27"
    std::string name;          ///< may be empty
    int nodes = 0;             ///< of an element
    std::int64_t elements = 0; ///< in the block
    std::int64_t first = 1;    ///< the number of its first element
    std::string suffix;        ///< of its variables' names: its place in the file, from 1
  };
  /// The blocks in the file's order.
  [[nodiscard]] const std::vector<Block>& Blocks() const { return Contents; }

  /// Faces of solids, or edges of plane elements.
  struct SideSet
  {
    std::int64_t id = 0;
    std::string name;                   ///< may be empty
    std::vector<std::int64_t> elements; ///< numbers
    std::vector<std::int64_t> sides;    ///< of each
  };
  [[nodiscard]] std::vector<SideSet> SideSets() const;

  [[nodiscard]] std::int64_t Nodes() const { return NodeCount; }
  [[nodiscard]] std::int64_t Elements() const { return ElementCount; }
  [[nodiscard]] int Dimensions() const { return Directions; }
  [[nodiscard]] std::int64_t NodeSets() const;
  [[nodiscard]] std::vector<double> Times() const;

  /// Coordinates of all nodes along a direction, counted from 0; empty along one that the file does
  /// not have.
  [[nodiscard]] std::vector<double> Coordinates(int direction) const;
  [[nodiscard]] bool HasSingleCoordinates() const;
  /// The nodes of a block's elements, counted from 0, in the file's order.
  [[nodiscard]] std::vector<std::int64_t> Connectivity(const Block& block) const;

  /// Names of the variables at nodes, and of elements.
  [[nodiscard]] std::vector<std::string> NodalNames() const { return NamesOf("name_nod_var"); }
  [[nodiscard]] std::vector<std::string> ElementNames() const { return NamesOf("name_elem_var"); }
  /// Values of a variable, counted from 0, at a time step, counted from 0.
  [[nodiscard]] std::vector<double> AtNodes(std::size_t variable, std::size_t step) const;
  /// The values of a block's elements; none where the block has no values of this variable.
  [[nodiscard]] std::optional<std::vector<double>> OfElements(
    std::size_t variable, const Block& block, std::size_t step) const;

private:
  [[nodiscard]] std::int64_t Count(const std::string& dimension, std::int64_t largest) const;
  [[nodiscard]] std::vector<std::string> NamesOf(const std::string& variable) const;
  [[nodiscard]] std::vector<std::int64_t> NumbersOf(
    const std::string& variable, std::int64_t count) const;
  void AddBlock(std::int64_t place, std::int64_t id, const std::string& name);

  std::unique_ptr<NetcdfFile> File;
  std::vector<Block> Contents;
  std::int64_t NodeCount = 0;
  std::int64_t ElementCount = 0;
  int Directions = 3;
};

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
