// SPDX-License-Identifier: BSD-3-Clause
// Faces' maps in two variables, against the elements' own in 113 bits.
#include "CurvedCheck.h"

#include "Core/Element/LaneBuffer.h"
#include "Core/Faces/FacePlane.h"
#include "Trace/Surfaces/Curved/FaceModes.h"
#include "Trace/Surfaces/Curved/FaceNormals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace pixelexact::testing
{
namespace
{
constexpr int kPoints = 21;

/// Of every shape and form, orders that are alike, that are not, and some that have no face modes.
std::vector<Space> AllSpaces()
{
  std::vector<Space> spaces;
  for (const Shape shape : kShapes)
  {
    for (const int order : { 1, 2, 3, 4, 5, 8, FaceRestriction::kHighestOrder + 1 })
    {
      spaces.push_back(UniformSpace(shape, order));
    }
  }
  spaces.push_back({ Shape::Hexahedron, Form::Collapsed, { 1, 3, 5 } });
  spaces.push_back({ Shape::Hexahedron, Form::Collapsed, { 3, 3, 0 } });
  spaces.push_back({ Shape::Prism, Form::Collapsed, { 2, 5, 4 } });
  spaces.push_back({ Shape::Tetrahedron, Form::Collapsed, { 2, 3, 5 } });
  spaces.push_back({ Shape::Pyramid, Form::Collapsed, { 2, 3, 4 } });
  spaces.push_back({ Shape::Pyramid, Form::Tensor, { 2, 3, 4 } });
  return spaces;
}

/// An element of random coefficients that fall with the order.
MeshBuilder RandomElement(const Space& space, Random& random)
{
  MeshBuilder mesh;
  mesh.Add(space, [](const LongVec3&) { return LongVec3{}; });
  const auto modes = static_cast<std::size_t>(space.Modes());
  ForEachMode(space,
    [&](int p, int q, int r, int mode)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        mesh.Phi.Coefficients[c * modes + static_cast<std::size_t>(mode)] =
          random() * std::exp2(-p - q - r);
      }
    });
  return mesh;
}

/// Points of a face inside, on its sides and in its corners.
std::vector<Vec3> PointsOf(Shape shape, int face, Random& random)
{
  const ShapeFace& end = FacesOf(shape)[static_cast<std::size_t>(face)];
  std::vector<Vec3> xi;
  for (int k = 0; k < kPoints; ++k)
  {
    Vec3 eta(random(), random(), random());
    if (k < 4)
    {
      eta = Vec3(k % 2 == 0 ? -1.0 : 1.0);
      eta[(end.direction + 1) % 3] = k < 2 ? -1.0 : 1.0;
    }
    eta[end.direction] = end.upper ? 1.0 : -1.0;
    xi.push_back(TensorToReference(shape, eta));
  }
  return xi;
}

struct Evaluated
{
  explicit Evaluated(const FaceMap& map, std::span<const Vec3> xi)
  {
    const LaneBuffer points(xi);
    double* value[3];
    double* slope[7];
    for (std::size_t k = 0; k < 10; ++k)
    {
      rows[k].resize(static_cast<std::size_t>(PaddedCount(kPoints)));
      (k < 3 ? value[k] : slope[k - 3]) = rows[k].data();
    }
    map.Evaluate(points.View(), value, slope);
  }

  std::array<std::vector<double>, 10> rows; ///< values, slopes, room
};

double SizeOf(const MeshBuilder& mesh)
{
  double sum = 0.0;
  for (const double c : mesh.Phi.Coefficients)
  {
    sum += std::fabs(c);
  }
  return sum;
}
} // namespace

TEST(FaceModes, AreTheElementsMapOnEachFace)
{
  Random random(11);
  const FaceRestriction restriction;
  for (const Space& space : AllSpaces())
  {
    const MeshBuilder builder = RandomElement(space, random);
    const Mesh mesh = builder.View();
    const double n = space.MaxOrder();
    for (int face = 0; face < static_cast<int>(FacesOf(space.shape).size()); ++face)
    {
      SCOPED_TRACE(std::string(Name(space.shape)) + " " + std::to_string(space.MaxOrder()) +
        ", face " + std::to_string(face));
      const CurvedPart part{ 0, face };
      const FaceChart chart = ChartOf(space.shape, face);
      const auto modes = restriction.Of(mesh, part);
      EXPECT_EQ(modes.has_value(),
        space.MaxOrder() <= FaceRestriction::kHighestOrder &&
          !(space.form == Form::Tensor && chart.collapses));
      const std::vector<Vec3> xi = PointsOf(space.shape, face, random);
      for (const FaceModes* of : { modes ? &*modes : nullptr, static_cast<FaceModes*>(nullptr) })
      {
        const Evaluated found(FaceMap(mesh, part, of), xi);
        for (std::size_t i = 0; i < xi.size(); ++i)
        {
          // Slopes of a pyramid in tensor form are not bounded at its apex.
          if (space.form == Form::Tensor && xi[i].z > 0.9)
          {
            continue;
          }
          const auto truth = EvaluateQuad(mesh.map, 0, { xi[i].x, xi[i].y, xi[i].z });
          for (std::size_t c = 0; c < 3; ++c)
          {
            const double value = static_cast<double>(truth[c].value - Quad(found.rows[c][i]));
            EXPECT_LT(std::fabs(value), 4e-15 * n * SizeOf(builder));
            for (std::size_t j = 0; j < 2; ++j)
            {
              const auto& by = truth[c].gradient;
              const Quad slope = by[static_cast<std::size_t>(chart.free[j])] +
                Quad(chart.along[j]) * by[static_cast<std::size_t>(chart.across)];
              const double off = static_cast<double>(slope - Quad(found.rows[3 + 2 * c + j][i]));
              EXPECT_LT(std::fabs(off), 4e-15 * n * n * n * SizeOf(builder)) << "slope " << j;
            }
          }
        }
      }
    }
  }
}

TEST(FaceNormals, PointOutOfTheShapes)
{
  Random random(12);
  for (const Shape shape : kShapes)
  {
    MeshBuilder builder;
    builder.Add(UniformSpace(shape, 1), [](const LongVec3& xi) { return xi; });
    const Mesh mesh = builder.View();
    for (int face = 0; face < static_cast<int>(FacesOf(shape).size()); ++face)
    {
      const Vec3 inwards = FacePlanesOf(shape)[static_cast<std::size_t>(face)].gradient;
      const std::vector<Vec3> xi = PointsOf(shape, face, random);
      std::vector<Vec3> normals(xi.size());
      const auto modes = FaceRestriction().Of(mesh, { 0, face });
      for (const FaceModes* of : { modes ? &*modes : nullptr, static_cast<FaceModes*>(nullptr) })
      {
        FaceNormals(FaceMap(mesh, { 0, face }, of), xi, normals);
        for (const Vec3& normal : normals)
        {
          EXPECT_LT(glm::distance(normal, -glm::normalize(inwards)), 1e-14)
            << Name(shape) << ", face " << face;
        }
      }
    }
  }
}
} // namespace pixelexact::testing
