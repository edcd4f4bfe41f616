// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Mesh.h"

#include <vector>

namespace pixelexact
{
/// Properties of a generated mesh.
struct BlockKind
{
  Shape shape = Shape::Hexahedron;
  /// False: the corners of a lattice are moved by up to a tenth, maps of order 1. True: the lattice
  /// is bent by a polynomial of degree 3, maps of order 3.
  bool curved = false;
  int order = 3;       ///< of the field
  int elements = 1000; ///< approximate number
  /// Whether every eighth column of hexahedra consists of prisms.
  bool mixed = false;
};

/// A cube of side about 2 around the origin, of elements of one shape: a lattice of hexahedra, each
/// divided into 2 prisms, 6 tetrahedra or 6 pyramids. Its field's modes are random, with magnitudes
/// that decrease with their degree, so that it costs as much as a solver's field.
class MadeBlock
{
public:
  explicit MadeBlock(const BlockKind& kind);

  /// The returned mesh views this object's arrays.
  [[nodiscard]] Mesh GetMesh() const;
  [[nodiscard]] const Field& GetField() const { return field_; }

private:
  std::vector<Space> MapSpace;
  std::vector<Space> FieldSpace;
  std::vector<std::int32_t> SpaceOf;
  std::vector<std::int64_t> MapOffset;
  std::vector<std::int64_t> FieldOffset;
  std::vector<double> MapCoefficients;
  std::vector<double> FieldCoefficients;
  std::vector<double> Centre;
  std::vector<double> Size;
  std::vector<double> Uncertainty;
  Field field_;
};
} // namespace pixelexact
