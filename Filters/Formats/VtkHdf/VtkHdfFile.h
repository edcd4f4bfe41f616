// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Hdf5/Hdf5File.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
/// The rows of one part of an unstructured grid at a time step in the file's data sets.
struct VtkHdfPart
{
  Hdf5Rows points;
  Hdf5Rows cells;
  Hdf5Rows connectivity;
  Hdf5Rows offsets; ///< one more than there are cells
};

/// An array of PointData, CellData or FieldData.
struct VtkHdfArray
{
  std::string name;
  std::string path;
  Hdf5Kind kind = Hdf5Kind::Reals;
  std::size_t bytes = 8;      ///< of a number
  std::size_t components = 1; ///< of a row
  std::string attribute;      ///< its purpose: "Scalars", "RationalWeights", ...; may be empty
};

/// A file of VTK's HDF format with unstructured grids: versions 1 and 2, static or with time steps,
/// in parts, and collections of such grids ("blocks"). No number of the file is believed: all
/// functions throw InvalidData or Unsupported, with the remedy and without the file's name, for
/// files that are damaged or hold data of other types.
class VtkHdfFile
{
public:
  explicit VtkHdfFile(const std::string& path);

  /// The times of the steps, in the order of the file; empty: the file has no steps.
  [[nodiscard]] const std::vector<double>& Times() const { return TimeOf; }

  /// Unstructured grids; one, or those of a collection.
  [[nodiscard]] std::size_t BlockCount() const { return Blocks.size(); }
  /// States, one line each, which blocks of a collection are left out.
  [[nodiscard]] const std::vector<std::string>& Notes() const { return Noted; }

  /// The parts of a block at a step; `step` is 0 for a file without steps.
  [[nodiscard]] std::vector<VtkHdfPart> Parts(std::size_t block, std::size_t step) const;

  [[nodiscard]] std::vector<double> Points(std::size_t block, const VtkHdfPart& part) const;
  [[nodiscard]] bool HasSinglePoints(std::size_t block) const;
  [[nodiscard]] std::vector<std::uint64_t> Types(std::size_t block, const Hdf5Rows& cells) const;
  /// Cells' first points in the connectivity, and its length: ascending from 0.
  [[nodiscard]] std::vector<std::int64_t> Offsets(std::size_t block, const VtkHdfPart& part) const;
  /// Points, counted from 0 in the part.
  [[nodiscard]] std::vector<std::int64_t> Connectivity(
    std::size_t block, const VtkHdfPart& part) const;

  /// The arrays of a group, "PointData", "CellData" or "FieldData". Notes state what has no numbers
  /// and is left out.
  [[nodiscard]] std::vector<VtkHdfArray> Arrays(
    std::size_t block, const std::string& group, std::vector<std::string>& notes) const;
  /// The row of the part's first entity in an array of PointData or CellData.
  [[nodiscard]] std::size_t FirstRow(std::size_t block, const std::string& group,
    const VtkHdfArray& array, std::size_t step, std::size_t first) const;
  /// The rows of an array of FieldData at a step.
  [[nodiscard]] Hdf5Rows FieldRows(
    std::size_t block, const VtkHdfArray& array, std::size_t step) const;

  [[nodiscard]] const Hdf5File& File() const { return *Opened; }

private:
  struct Block
  {
    std::string root;      ///< the path of its group
    std::size_t steps = 0; ///< 0: it is static
  };

  void AddBlocks();
  void AddBlock(const std::string& root);
  [[nodiscard]] std::string TypeOf(const std::string& root) const;
  [[nodiscard]] std::vector<double> TimesOf(const std::string& root) const;
  [[nodiscard]] std::vector<std::uint64_t> Counts(const std::string& path) const;
  [[nodiscard]] std::optional<std::uint64_t> AtStep(
    const std::string& path, std::size_t step) const;
  [[nodiscard]] std::vector<std::int64_t> Numbers(
    const std::string& path, const Hdf5Rows& rows) const;

  std::unique_ptr<Hdf5File> Opened;
  std::vector<Block> Blocks;
  std::vector<double> TimeOf;
  std::vector<std::string> Noted;
};
} // namespace pixelexact
