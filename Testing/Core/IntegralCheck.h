// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurvedMeshes.h"

#include "Core/Integral/IntegralCut.h"

#include <gtest/gtest.h>

// Helpers of the tests of integrals.
namespace pixelexact::testing
{
inline ImplicitPolynomial PlaneForm(const Vec3& normal, double c)
{
  ImplicitPolynomial form;
  form.a.g = normal;
  form.a.c = c;
  return form;
}

/// Checks that an interval contains the value and is at most `width` wide.
inline void ExpectHolds(const Interval& found, double value, double width, const char* what)
{
  EXPECT_TRUE(found.Contains(value))
    << what << ": " << value << " is not in [" << found.lower << ", " << found.upper << "]";
  EXPECT_LE(found.Width(), width) << what;
}

/// [-1, 1]^3 as one straight hexahedron.
inline MeshBuilder Cube()
{
  MeshBuilder builder;
  builder.Add(UniformSpace(Shape::Hexahedron, 1), [](const LongVec3& xi) { return xi; });
  return builder;
}
} // namespace pixelexact::testing
