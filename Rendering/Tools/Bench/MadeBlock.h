// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Mesh.h"

#include <vector>

namespace pixelexact
{
/// What a made mesh is like.
struct BlockKind
{
  Shape shape = Shape::Hexahedron;
  /// False: the corners of a lattice moved by up to a tenth, maps of order 1. True: the lattice
  /// bent by a polynomial of degree 3, maps of order 3.
  bool curved = false;
  int order = 3;       ///< of the field
  int elements = 1000; ///< about as many
  /// Of hexahedra: each eighth column of cells is made of prisms instead.
  bool mixed = false;
};

/// A cube of about side 2 around the origin, made of elements of one shape: a lattice of
/// hexahedra, each cut in 2 prisms, 6 tetrahedra or 6 pyramids. Its field's modes are random, of
/// magnitudes that fall with their degree: it costs what any field does.
class MadeBlock
{
public:
  explicit MadeBlock(const BlockKind& kind);

  /// Views of this object's arrays.
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
