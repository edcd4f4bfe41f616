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

/// Spaces of every shape and form, with equal and different orders, and some without face modes.
std::vector<Space> AllSpaces()
{
  std::vector<Space> spaces;
  for (const Shape shape : kShapes)
  {
    for (const int order : { 1, 2, 3, 4, 6 })
    {
      spaces.push_back(UniformSpace(shape, order));
    }
  }
  spaces.push_back({ Shape::Hexahedron, Form::Collapsed, { 1, 3, 5 } });
  spaces.push_back({ Shape::Hexahedron, Form::Collapsed, { 3, 3, 0 } });
  spaces.push_back(
    { Shape::Hexahedron, Form::Collapsed, { FaceRestriction::kHighestOrder + 1, 1, 1 } });
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

/// xi of a face's chart, of which the third is not rounded.
QuadVec3 OnPlane(const FaceChart& chart, const Vec3& xi)
{
  QuadVec3 at{ xi.x, xi.y, xi.z };
  at[static_cast<std::size_t>(chart.across)] = Quad(chart.constant) +
    Quad(chart.along[0]) * Quad(xi[chart.free[0]]) + Quad(chart.along[1]) * Quad(xi[chart.free[1]]);
  return at;
}

/// A derivative by the chart's u or v.
Quad AlongChart(const FaceChart& chart, const QuadValue& of, std::size_t j)
{
  return of.gradient[static_cast<std::size_t>(chart.free[j])] +
    Quad(chart.along[j]) * of.gradient[static_cast<std::size_t>(chart.across)];
}

/// The sum of the modes of a face at a xi, without rounding: value and slopes by u and v.
std::array<QuadValue, 3> WithoutRounding(
  const FaceModes& modes, const FaceChart& chart, const Vec3& xi)
{
  using namespace HWY_NAMESPACE;
  const QuadVec3 at{ xi[chart.free[0]], 0, xi[chart.free[1]] };
  std::array<QuadValue, 3> out;
  const auto evaluate = [&]<template <class, class, bool> class Modes>()
  { EvaluateQuad<Modes>(modes.space, modes.coefficients.data(), 3, at, out.data()); };
  if (modes.space.shape == Shape::Prism)
  {
    evaluate.operator()<PrismModes>();
  }
  else
  {
    evaluate.operator()<HexahedronModes>();
  }
  for (QuadValue& one : out)
  {
    one.gradient = { one.gradient[0], one.gradient[2], 0 };
  }
  return out;
}

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
      for (const bool inElement : { false, true })
      {
        const Evaluated found(FaceMap(mesh, part, modes && !inElement ? &*modes : nullptr), xi);
        for (std::size_t i = 0; i < xi.size(); ++i)
        {
          // At a pyramid's apex the reference divides by zero, and in tensor form slopes are
          // unbounded near it.
          const double last = space.form == Form::Tensor ? 0.9 : 1.0;
          if (space.shape == Shape::Pyramid && xi[i].z >= last)
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
              const Quad slope = AlongChart(chart, truth[c], j);
              const double off = static_cast<double>(slope - Quad(found.rows[3 + 2 * c + j][i]));
              EXPECT_LT(std::fabs(off), 4e-15 * n * n * n * SizeOf(builder)) << "slope " << j;
            }
          }
        }
      }
    }
  }
}

TEST(FaceModes, AreNoFartherOffThanTold)
{
  Random random(13);
  const FaceRestriction restriction;
  for (const Space& space : AllSpaces())
  {
    const MeshBuilder builder = RandomElement(space, random);
    const Mesh mesh = builder.View();
    for (int face = 0; face < static_cast<int>(FacesOf(space.shape).size()); ++face)
    {
      const auto modes = restriction.Of(mesh, { 0, face });
      if (!modes)
      {
        continue;
      }
      SCOPED_TRACE(std::string(Name(space.shape)) + " " + std::to_string(space.MaxOrder()) +
        ", face " + std::to_string(face));
      const FaceChart chart = ChartOf(space.shape, face);
      EXPECT_LT(modes->error, 1e-15 * SizeOf(builder) * space.MaxOrder());
      for (const Vec3& xi : PointsOf(space.shape, face, random))
      {
        if (space.shape == Shape::Pyramid && xi.z == 1.0)
        {
          continue;
        }
        const QuadVec3 at = OnPlane(chart, xi);
        const auto truth = EvaluateQuad(mesh.map, 0, at);
        const auto found = WithoutRounding(*modes, chart, xi);
        for (std::size_t c = 0; c < 3; ++c)
        {
          const auto off = [](const Quad& a, const Quad& b)
          { return std::fabs(static_cast<double>(a - b)); };
          EXPECT_LE(off(truth[c].value, found[c].value), modes->error);
          for (std::size_t j = 0; j < 2; ++j)
          {
            EXPECT_LE(
              off(AlongChart(chart, truth[c], j), found[c].gradient[j]), modes->SlopeError())
              << "slope " << j;
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
      for (const bool inElement : { false, true })
      {
        FaceNormals(
          FaceMap(mesh, { 0, face }, modes && !inElement ? &*modes : nullptr), xi, normals);
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
