// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/BasisFactor.h"
#include "Formats/ElementBasis.h"
#include "Formats/Nektar/Fields/FieldFile.h"

namespace pixelexact::nektar
{
/// The basis of an expansion. Throws Unsupported for families that are not read, InvalidData for
/// orders that its shape does not allow.
ElementBasis MakeFieldBasis(const Expansion3& expansion);

/// The part of the modified basis that does not vanish on a solid's boundary, as functions of
/// values on its faces. Nektar++ constructs an element's map from its faces only: one after the
/// other, each sets the coefficients of the modes that do not vanish on it. Where neighbouring
/// faces differ by the rounding of the file, the last one determines their common modes. Therefore
/// every face has its own nodes here.
struct BoundaryBasis
{
  struct Node
  {
    int face = 0;                         ///< of the solid
    std::array<long double, 4> weights{}; ///< of that face's vertices, in the solid's order
  };
  std::vector<Node> nodes;
  ElementBasis basis;
};

/// Throws Unsupported above order 10.
BoundaryBasis MakeBoundaryBasis(Shape shape, int order);
} // namespace pixelexact::nektar
