// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

#include <cstdint>

// The four shapes, their reference space xi and tensor space eta (paper, section 3; Karniadakis and
// Sherwin, Spectral/hp Element Methods for CFD, 2005, section 3.2).
//
//   hexahedron   [-1,1]^3
//   prism        triangle in (xi1, xi3), line in xi2:  xi1 + xi3 <= 0
//   tetrahedron  xi1 + xi2 + xi3 <= -1
//   pyramid      apex at xi3 = 1:  xi1 + xi3 <= 0, xi2 + xi3 <= 0
//
// each with xi_i >= -1. The tensor space is the cube; its collapsed coordinates are singular where
// an edge or a face shrinks to a vertex, xi is not: the inverse map works in xi.
namespace pixelexact
{
enum class Shape : std::uint8_t
{
  Hexahedron = 0,
  Prism = 1,
  Tetrahedron = 2,
  Pyramid = 3
};
inline constexpr int kShapeCount = 4;

const char* Name(Shape shape);

/// The image of eta in [-1,1]^3; polynomial, so exact up to rounding everywhere.
Vec3 TensorToReference(Shape shape, const Vec3& eta);

/// The inverse of TensorToReference. On a collapsed edge or vertex, where every value of the
/// collapsed coordinate maps to the same xi, that coordinate is -1.
Vec3 ReferenceToTensor(Shape shape, const Vec3& xi);

/// The smallest signed distance, along the xi axes, of xi to the planes of the faces: >= 0 inside
/// and on the boundary, < 0 outside. NaN in, NaN out.
double Margin(Shape shape, const Vec3& xi);

/// A point well inside the shape: the centroid of its vertices.
Vec3 Centre(Shape shape);

/// Whether `value` names a shape.
constexpr bool IsShape(int value)
{
  return value >= 0 && value < kShapeCount;
}
} // namespace pixelexact
