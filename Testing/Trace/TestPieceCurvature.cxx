// SPDX-License-Identifier: BSD-3-Clause
// What pieces say of slopes, against derivatives in 113 bits.
#include "Core/MeshBuilder.h"
#include "Core/QuadReference.h"

#include "Trace/Scene.h"
#include "Trace/Surfaces/Curved/PartTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace pixelexact::testing
{
namespace
{
/// visit(piece) for all pieces that rays look at.
template <class Visit>
void ForEachCurved(const CurvedPiece& piece, const Visit& visit)
{
  if (piece.curves && !piece.IsEmpty())
  {
    visit(piece);
  }
  if (const auto* const children = piece.children.load())
  {
    ForEachCurved((*children)[0], visit);
    ForEachCurved((*children)[1], visit);
  }
}

/// Second derivatives of function c times a way in xi.
Vec3 ApplyCurvature(const CurvedPiece& piece, std::size_t c, const Vec3& by)
{
  const float* const s = piece.curve[c];
  return { s[0] * by.x + s[3] * by.y + s[5] * by.z, s[3] * by.x + s[1] * by.y + s[4] * by.z,
    s[5] * by.x + s[4] * by.y + s[2] * by.z };
}
} // namespace

TEST(PieceCurvature, HoldsSlopesOfAllShapes)
{
  for (const Shape shape : kShapes)
  {
    MeshBuilder mesh;
    mesh.Add(UniformSpace(shape, 3), Curved);
    const Space space = UniformSpace(shape, 5);
    ExpansionBuilder values(1);
    values.Spaces = { space };
    values.SpaceOf = { 0 };
    values.Offset = { 0 };
    Random random(11);
    values.Coefficients.resize(static_cast<std::size_t>(space.Modes()));
    std::ranges::generate(values.Coefficients, [&random] { return random(); });
    const Field field{ "f", values.View() };
    const CurvedEquation equation{ mesh.View(), &field, 0, 0.1 };
    const PartTree tree(equation, { 0, -1 });
    const double scale = std::ldexp(1.0, -tree.FieldModes().exponent);
    int pieces = 0;
    double farthest = 0.0;
    double nearest = 0.0; // by the largest slope's range
    const auto check = [&](const CurvedPiece& piece)
    {
      ++pieces;
      for (int k = 0; k < 8; ++k)
      {
        Vec3 eta;
        for (int d = 0; d < 3; ++d)
        {
          eta[d] = random(piece.box.lower[d], piece.box.upper[d]);
        }
        const Vec3 xi = TensorToReference(shape, eta);
        const auto map = EvaluateQuad(equation.mesh.map, 0, { xi.x, xi.y, xi.z });
        const auto f = EvaluateQuad(values.View(), 0, { xi.x, xi.y, xi.z });
        for (std::size_t c = 0; c < 4; ++c)
        {
          const QuadVec3& slope = c < 3 ? map[c].gradient : f[0].gradient;
          const Vec3 told = ApplyCurvature(piece, c, xi - piece.centre);
          for (std::size_t d = 0; d < 3; ++d)
          {
            const double is = static_cast<double>(slope[d]) * (c < 3 ? 1.0 : scale);
            const double off =
              std::fabs(is - piece.slope[c][d] - piece.shift[c][d] - told[static_cast<int>(d)]);
            ASSERT_LE(off, piece.rest[c][d]) << Name(shape) << ", function " << c;
            farthest = std::max(farthest, off / piece.rest[c][d]);
            nearest = std::max(nearest, c < 3 ? 0.0 : piece.rest[c][d] / piece.radius[c][d]);
          }
        }
      }
    };
    for (const auto& root : tree.Roots())
    {
      ForEachCurved(*root, check);
    }
    EXPECT_GT(pieces, 50) << Name(shape);
    // Neither does the rest hold far more than it has to.
    EXPECT_GT(farthest, 0.5) << Name(shape);
    std::cout << Name(shape) << ": " << pieces << " pieces, rest at most " << nearest
              << " of the slopes' ranges\n";
  }
}
} // namespace pixelexact::testing
