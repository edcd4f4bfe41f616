// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Shape/Shape.h"
#include "Formats/Nektar/Files/Document.h"
#include "Formats/Nektar/Homogeneous/Homogeneous.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace pixelexact::nektar
{
/// The numbers of a field file. They are released as they are taken, so that they do not use memory
/// at the same time as the coefficients.
class FieldValues
{
public:
  void Append(std::span<const double> values);
  [[nodiscard]] std::size_t Size() const { return Count; }

  /// Numbers begin to go when all parts that were expected have been taken, each once.
  void Expect(std::size_t begin, std::size_t count);
  /// Copies a range and releases pages that no other range needs. Thread-safe.
  void Take(std::size_t begin, std::span<double> out);

private:
  static constexpr std::size_t kChunk = std::size_t{ 1 } << 16U;
  /// Pages of their own: those that go are the system's at once, not the heap's.
  struct Unmap
  {
    void operator()(double* pages) const;
  };
  struct Chunk
  {
    std::unique_ptr<double[], Unmap> values;
    std::unique_ptr<std::atomic<std::size_t>> expected;
  };
  std::vector<Chunk> Chunks;
  std::size_t Count = 0;
};

/// The families of functions along each direction, and their numbers. For plane elements, on the
/// solids of a slab, one function without a family across; for segments also along y.
struct Expansion3
{
  Shape shape = Shape::Hexahedron;
  std::array<std::string, 3> families; ///< "Modified_A", ...
  std::array<int, 3> count{};

  auto operator<=>(const Expansion3&) const = default;
  [[nodiscard]] bool IsPlane() const { return families[1].empty() || families[2].empty(); }
  [[nodiscard]] bool IsLine() const { return families[1].empty() && families[2].empty(); }
};

/// An element's coefficients in a block. Of homogeneous blocks, those of the first function of y
/// and z; the others' follow.
struct ElementData
{
  std::int64_t id = 0;
  int expansion = 0;      ///< index in FieldBlock::expansions
  std::size_t offset = 0; ///< of its first coefficient among those of one field
  std::size_t count = 0;
};

/// The contents of one ELEMENTS block.
struct FieldBlock
{
  std::vector<std::string> fields;
  std::vector<Expansion3> expansions;
  std::vector<ElementData> elements;
  std::optional<Homogeneous> homogeneous;
  int strip = 0; ///< its number, where there are strips
  std::size_t perField = 0;
  FieldValues values; ///< field by field
};

struct FieldFile
{
  std::optional<double> time;
  std::vector<FieldBlock> blocks;
  std::vector<std::string> notes; ///< as SolverModel::notes
};

/// Reads a part of a field file. Throws InvalidData and Unsupported.
FieldFile ReadFieldFile(const NamedText& file);

/// "prism", "triangle", "segment".
std::string NameOf(const Expansion3& expansion);

/// "Modified_A x Modified_A x Modified_B".
std::string Describe(const Expansion3& expansion);
} // namespace pixelexact::nektar
