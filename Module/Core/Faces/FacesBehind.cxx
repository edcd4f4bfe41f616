// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Faces/FacesBehind.h"

#include "Core/Faces/FacePairs.h"
#include "Core/Faces/FacePlane.h"
#include "Core/Faces/FaceTable.h"
#include "Core/Location/Sample.h"
#include "Core/Shape/ShapeFace.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace pixelexact
{
namespace
{
/// Distance of xi up to which a point lies on a face.
constexpr double kOnThisFace = 1e-6;
} // namespace

FacesBehind::FacesBehind(
  const Locator& locator, const FaceTable& table, const PlacesByOrder& places, int order)
  : locator_(locator)
  , Table(table)
  , Places(places)
  , mesh_(locator.GetMesh())
  , Order(order)
  , Many(static_cast<std::size_t>(mesh_.Elements()))
{
}

void FacesBehind::Find(int element)
{
  const int count = static_cast<int>(FacesOf(mesh_.ShapeOf(element)).size());
  for (int f = 0; f < count; ++f)
  {
    const FaceKind kind = Table.KindOf(element, f);
    if (kind == FaceKind::Hanging || kind == FaceKind::Partly)
    {
      Many[static_cast<std::size_t>(element)].emplace(f, BehindAll({ element, f }));
    }
  }
}

const ManyBehind* FacesBehind::Of(const ElementFace& face) const
{
  if (face.element < 0)
  {
    return nullptr;
  }
  const auto& ofElement = Many[static_cast<std::size_t>(face.element)];
  const auto at = ofElement.find(face.face);
  return at == ofElement.end() ? nullptr : &at->second;
}

ElementFace FacesBehind::FaceAt(int element, const Vec3& xi) const
{
  const auto planes = FacePlanesOf(mesh_.ShapeOf(element));
  for (std::size_t f = 0; f < planes.size(); ++f)
  {
    if (std::fabs(planes[f].Distance(xi)) <= kOnThisFace)
    {
      return { element, static_cast<std::int32_t>(f) };
    }
  }
  return {};
}

ManyBehind FacesBehind::BehindAll(const ElementFace& face) const
{
  const int order = Order + mesh_.map.SpaceOf(face.element).MaxOrder();
  const ReferenceFace& reference = ReferenceFaceOf(mesh_.ShapeOf(face.element), face.face);
  const FacePlaces& places = Places.GaussOf(reference.corners, order);
  std::vector<Vec3> xi;
  std::ranges::transform(places.points, std::back_inserter(xi),
    [&](const FacePoint& point) { return reference.At(point); });
  std::vector<Vec3> x(xi.size());
  MapForward(mesh_, face.element, xi, x);
  ManyBehind many;
  many.behind.resize(xi.size());
  FindBehind(locator_, face, xi, x, many.behind);
  std::set<ElementFace> different;
  for (const BehindFace& at : many.behind)
  {
    many.faces.push_back(at.verdict == Verdict::Inside ? FaceAt(at.element, at.xi) : ElementFace{});
    different.insert(many.faces.back());
  }
  many.isNested = different.size() == 1 && different.begin()->element >= 0;
  return many;
}
} // namespace pixelexact
