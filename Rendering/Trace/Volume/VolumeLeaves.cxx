// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Volume/VolumeLeaves.h"

#include "Core/Math/Rounding.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace pixelexact
{
namespace
{
/// Faces of a shape beside xi_d >= -1 and xi_d <= 1: constant + slope . xi >= 0.
std::vector<LeafSide> SlantedFaces(Shape shape)
{
  switch (shape)
  {
    case Shape::Prism:
      return { { 0.0, { -1.0, 0.0, -1.0 } } };
    case Shape::Tetrahedron:
      return { { -1.0, { -1.0, -1.0, -1.0 } } };
    case Shape::Pyramid:
      return { { 0.0, { -1.0, 0.0, -1.0 } }, { 0.0, { 0.0, -1.0, -1.0 } } };
    default:
      return {};
  }
}

double SumOf(const Vec3& v)
{
  return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z);
}

/// The box's sides in s. False where the box is outside the shape.
bool MakeSides(Shape shape, const Box3& box, std::vector<LeafSide>& sides)
{
  const Vec3 centre = 0.5 * (box.lower + box.upper);
  const Vec3 halfWidth = 0.5 * (box.upper - box.lower);
  for (int d = 0; d < 3; ++d)
  {
    Vec3 slope(0.0);
    slope[d] = 1.0;
    sides.push_back({ 1.0, slope });
    sides.push_back({ 1.0, -slope });
  }
  for (const LeafSide& face : SlantedFaces(shape))
  {
    const LeafSide side{ face.constant + glm::dot(face.slope, centre), face.slope * halfWidth };
    const double reach = SumOf(side.slope);
    if (side.constant + reach <= 0.0)
    {
      return false;
    }
    if (side.constant - reach < 0.0)
    {
      sides.push_back(side);
    }
  }
  return true;
}

/// The direction along which a series is farthest from linear.
int BendingDirection(const BoxSeries& series)
{
  std::array<double, 3> bending{};
  for (std::size_t c = 0; c < series.coefficients.size(); ++c)
  {
    std::size_t index = 0;
    for (int i = 0; i <= series.degree[0]; ++i)
    {
      for (int j = 0; j <= series.degree[1]; ++j)
      {
        for (int k = 0; k <= series.degree[2]; ++k, ++index)
        {
          const double size = i + j + k > 1 ? std::fabs(series.coefficients[c][index]) : 0.0;
          bending[0] += i * size;
          bending[1] += j * size;
          bending[2] += k * size;
        }
      }
    }
  }
  return static_cast<int>(std::ranges::max_element(bending) - bending.begin());
}
} // namespace

VolumeLeaves::VolumeLeaves(
  const ElementIndex& index, const Field& field, int first, int count, const Tolerances& tolerances)
  : index_(index)
  , field_(field)
  , first_(first)
  , count_(count)
  , tolerances_(tolerances)
  , made_(static_cast<std::size_t>(index.GetMesh().Elements()))
{
}

const double* VolumeLeaves::FieldCoefficients(int element) const
{
  return field_.values.Coefficients(element) +
    static_cast<std::size_t>(first_) * static_cast<std::size_t>(FieldSpace(element).Modes());
}

VolumeLeaf VolumeLeaves::MakeLeaf(
  int element, const Box3& box, bool mayDivide, int& direction) const
{
  const Mesh& mesh = index_.GetMesh();
  VolumeLeaf leaf;
  const BoxSeries phi =
    MakeBoxSeries(mesh.map.SpaceOf(element), mesh.map.Coefficients(element), 3, box);
  leaf.inverse = MakeXiInverse(mesh, element, phi, box);
  const Vec3 half = Vec3(1.0) + leaf.inverse.deviation;
  const RayEllipses ellipses(leaf.inverse, Vec3(0.0), half);
  leaf.isProven =
    leaf.inverse.IsProven() && ellipses.Error(kDiscRadii, kPoints) <= tolerances_.place;
  if (!leaf.isProven && mayDivide)
  {
    // The map decides where its inverse is not proven; nobody needs the field.
    direction = BendingDirection(phi);
    return leaf;
  }
  const BoxSeries field =
    MakeBoxSeries(FieldSpace(element), FieldCoefficients(element), count_, box);
  direction = BendingDirection(field);
  bool isFinite = true;
  for (std::size_t c = 0; c < field.coefficients.size(); ++c)
  {
    leaf.fieldBounds.push_back(field.OverDiscs(c));
    leaf.fieldNoise.push_back(field.error[c] + field.noise[c]);
    isFinite = isFinite && std::isfinite(leaf.fieldBounds[c].front());
    leaf.isProven =
      leaf.isProven && ellipses.Error(leaf.fieldBounds[c], kPoints) <= tolerances_.value;
  }
  direction = isFinite ? direction : -1;
  return leaf;
}

void VolumeLeaves::Divide(int element, const Box3& box, std::vector<VolumeLeaf>& leaves) const
{
  const Shape shape = index_.GetMesh().ShapeOf(element);
  std::vector<LeafSide> sides;
  if (!MakeSides(shape, box, sides))
  {
    return;
  }
  const Vec3 width = box.upper - box.lower;
  const auto canDivide = [&width](int d) { return width[d] > 3.0 * kNarrowest; };
  const int widest = width.x >= width.y && width.x >= width.z ? 0 : (width.y >= width.z ? 1 : 2);
  const bool mayDivide = shape != Shape::Pyramid && canDivide(widest);
  int direction = 0;
  VolumeLeaf leaf = MakeLeaf(element, box, mayDivide, direction);
  leaf.sides = std::move(sides);
  if (!leaf.isProven && mayDivide && direction >= 0)
  {
    direction = canDivide(direction) ? direction : widest;
    const double middle = 0.5 * (box.lower[direction] + box.upper[direction]);
    Box3 part = box;
    part.upper[direction] = middle;
    Divide(element, part, leaves);
    part = box;
    part.lower[direction] = middle;
    Divide(element, part, leaves);
    return;
  }
  leaves.push_back(std::move(leaf));
}

const std::vector<VolumeLeaf>& VolumeLeaves::Of(int element) const
{
  return made_.Get(static_cast<std::size_t>(element),
    [&]
    {
      std::vector<VolumeLeaf> leaves;
      Divide(element, { Vec3(-1.0), Vec3(1.0) }, leaves);
      return std::make_unique<const std::vector<VolumeLeaf>>(std::move(leaves));
    });
}
} // namespace pixelexact
