// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pixelexact
{
/// What Exodus' own library tells of a file, checked, because VTK's reader believes all numbers.
/// Throws Error, naming the file, for damaged ones.
class ExodusFile
{
public:
  explicit ExodusFile(const std::string& path);
  ~ExodusFile();
  ExodusFile(const ExodusFile&) = delete;
  ExodusFile& operator=(const ExodusFile&) = delete;

  /// An element block with elements.
  struct Block
  {
    std::string type;       ///< "HEX27"
    int nodes = 0;          ///< of an element
    std::string name;       ///< may be empty
    std::int64_t first = 1; ///< the number of its first element, in the file's order
  };
  /// By their numbers.
  [[nodiscard]] std::map<std::int64_t, Block> Blocks() const;

  /// Faces of solids, or edges of plane elements.
  struct SideSet
  {
    std::int64_t id = 0;
    std::string name;                   ///< may be empty
    std::vector<std::int64_t> elements; ///< in the file's order, from 1
    std::vector<std::int64_t> sides;    ///< of each, from 1
  };
  [[nodiscard]] std::vector<SideSet> SideSets() const;

  [[nodiscard]] std::int64_t NodeSets() const;
  [[nodiscard]] std::int64_t Elements() const;
  [[nodiscard]] std::vector<double> Times() const;

private:
  void Require(bool sound) const;
  void RequireConnectivity(std::int64_t block, std::int64_t count, std::int64_t points) const;

  std::string Path;
  int Id = -1;
};
} // namespace pixelexact
