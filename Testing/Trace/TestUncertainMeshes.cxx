// SPDX-License-Identifier: BSD-3-Clause
// Hits on elements whose coordinates are known to a few digits, as of files in floats: what is
// unknown of the map is no reason to leave hits off the ray, or iso-surfaces off their value.
#include "CurvedCheck.h"

#include "Core/Tree/EtaBox.h"

namespace pixelexact::testing
{
namespace
{
constexpr double kUncertainty = 1e-6;
constexpr double kSought = 0.05;
/// Distance in xi from the element's end within which a point may be outside, up to the
/// uncertainty.
constexpr double kRim = 1e-4;

struct UncertainElement
{
  explicit UncertainElement(Shape shape)
    : values(1)
  {
    Random random(7);
    mesh.Add(UniformSpace(shape, 3), Curved);
    mesh.Uncertainty[0] = kUncertainty;
    const Space space = UniformSpace(shape, 5);
    values.Spaces = { space };
    values.SpaceOf = { 0 };
    values.Offset = { 0 };
    ForEachMode(space,
      [&](int p, int q, int r, int)
      { values.Coefficients.push_back(random() * std::pow(0.8, p + q + r)); });
    index = std::make_unique<ElementIndex>(mesh.View());
    field = { "f", values.View() };
  }

  [[nodiscard]] std::vector<Ray> Rays(int count) const
  {
    Random random(11);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i)
    {
      const Vec3 xi = random.Inside(mesh.View().ShapeOf(0));
      const auto phi = EvaluateQuad(mesh.View().map, 0, { xi.x, xi.y, xi.z });
      const Vec3 x(static_cast<double>(phi[0].value), static_cast<double>(phi[1].value),
        static_cast<double>(phi[2].value));
      rays.push_back(RayThroughPoint(random, x, random(2.0, 9.0)));
    }
    return rays;
  }

  MeshBuilder mesh;
  ExpansionBuilder values;
  std::unique_ptr<ElementIndex> index;
  Field field;
};

/// The number of faces of its shape that are near a point of the reference element.
int NearFaces(Shape shape, const Vec3& xi)
{
  int count = 0;
  for (const ShapeFace& face : FacesOf(shape))
  {
    count += DepthOf(shape, {}, 2 * face.direction + (face.upper ? 1 : 0), xi) < kRim ? 1 : 0;
  }
  return count;
}
} // namespace

TEST(UncertainMeshes, HitsAreOnTheirRays)
{
  for (const Shape shape : kShapes)
  {
    SCOPED_TRACE(Name(shape));
    const UncertainElement one(shape);
    std::vector<ElementFace> all;
    for (int f = 0; f < static_cast<int>(FacesOf(shape).size()); ++f)
    {
      all.push_back({ 0, f });
    }
    const ElementFaces faces(*one.index, all);
    const IsoSurface iso(*one.index, one.field, 0, kSought);
    int checked[2] = {};
    for (const Ray& ray : one.Rays(200))
    {
      const auto onFaces = MeetPoints(faces, { ray })[0];
      for (const PointHit& hit : onFaces)
      {
        if (hit.status == HitStatus::Certain && NearFaces(shape, hit.point.xi) == 1)
        {
          ++checked[0];
          EXPECT_LE(ResidualQuad(one.mesh.View(), ray, hit.t, 0, hit.point.xi), 1e-13);
        }
      }
      const auto onIso = MeetPoints(iso, { ray })[0];
      for (const PointHit& hit : onIso)
      {
        if (hit.status == HitStatus::Certain && NearFaces(shape, hit.point.xi) == 0)
        {
          const Vec3& xi = hit.point.xi;
          const auto f = EvaluateQuad(one.values.View(), 0, { xi.x, xi.y, xi.z });
          ++checked[1];
          EXPECT_LE(std::fabs(static_cast<double>(f[0].value) - kSought), 1e-13);
          EXPECT_LE(ResidualQuad(one.mesh.View(), ray, hit.t, 0, hit.point.xi), 1e-13);
        }
      }
    }
    EXPECT_GT(checked[0], 100);
    EXPECT_GT(checked[1], 30);
  }
}
} // namespace pixelexact::testing
