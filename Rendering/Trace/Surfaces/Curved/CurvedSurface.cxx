// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/CurvedSurface.h"

#include "Core/Base/CheckedOut.h"
#include "Trace/RunsByKey.h"
#include "Trace/Scene.h"
#include "Trace/Surfaces/Curved/FaceNormals.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
struct NormalScratch
{
  std::vector<KeyRun> runs;
  std::vector<Vec3> xi;
  std::vector<Vec3> found;
};
} // namespace

CurvedSurface::CurvedSurface(
  const CurvedEquation& equation, std::vector<CurvedPart> parts, std::span<const Box3> boxes)
  : equation_(equation)
  , All(std::move(parts))
  , Trees(All.size())
  , Boxes(equation.field == nullptr ? All.size() : 0)
  , Modes(Boxes.Size())
{
  if (!All.empty())
  {
    Hierarchy = std::make_unique<BundleHierarchy>(boxes);
  }
}

const PartTree& CurvedSurface::TreeOf(std::int32_t part) const
{
  return Trees.Get(static_cast<std::size_t>(part),
    [&] { return std::make_unique<const PartTree>(equation_, PartOf(part), ModesOf(part)); });
}

const FaceModes* CurvedSurface::ModesOf(std::int32_t part) const
{
  if (equation_.field != nullptr)
  {
    return nullptr;
  }
  const std::optional<FaceModes>& modes = Modes.Get(static_cast<std::size_t>(part),
    [&]
    {
      return std::make_unique<const std::optional<FaceModes>>(
        Restriction.Of(equation_.mesh, PartOf(part)));
    });
  return modes ? &*modes : nullptr;
}

const Box3& CurvedSurface::BoxOf(std::int32_t part, const Box3& around) const
{
  return equation_.field != nullptr
    ? around
    : Boxes.Get(static_cast<std::size_t>(part),
        [&] {
          return std::make_unique<const Box3>(FaceBox(equation_.mesh, PartOf(part), ModesOf(part)));
        });
}

std::int64_t CurvedSurface::PiecesMade() const
{
  std::int64_t pieces = 0;
  for (std::size_t k = 0; k < All.size(); ++k)
  {
    const PartTree* tree = Trees.IfMade(k);
    pieces += tree ? tree->Pieces() : 0;
  }
  return pieces;
}

void CurvedSurface::Review(
  const CurvedPart& /*part*/, std::vector<CurvedHit>& /*hits*/, std::size_t /*first*/) const
{
}

void CurvedSurface::NormalsOf(
  std::int32_t part, std::span<const Vec3> xi, std::span<Vec3> normals) const
{
  FaceNormals(FaceMap(equation_.mesh, PartOf(part), ModesOf(part)), xi, normals);
}

void CurvedSurface::Meet(const RayLanes& rays, HitSlots& hits) const
{
  for (int first = 0; Hierarchy && first < rays.count; first += RayBundle::kMax)
  {
    MeetSome(rays, first, std::min(RayBundle::kMax, rays.count - first), hits);
  }
}

Vec3 CurvedSurface::Normal(const SurfacePoint& point) const
{
  Vec3 normal;
  Normals(std::span(&point, 1), std::span(&normal, 1));
  return normal;
}

void CurvedSurface::Normals(std::span<const SurfacePoint> points, std::span<Vec3> normals) const
{
  const CheckedOut<NormalScratch> checkedOut;
  NormalScratch& scratch = *checkedOut;
  std::vector<Vec3>& xi = scratch.xi;
  std::vector<Vec3>& found = scratch.found;
  ForEachKey(
    points.size(), [&](std::size_t i) { return points[i].piece; }, scratch.runs,
    [&](std::int32_t piece, std::span<const KeyRun> of)
    {
      xi.clear();
      for (const KeyRun& run : of)
      {
        for (std::size_t i = run.begin; i < run.end; ++i)
        {
          const SurfacePoint& point = points[i];
          xi.push_back(
            TellsElements() ? point.xi : Vec3(point.parameters[0], point.parameters[1], -1.0));
        }
      }
      found.resize(xi.size());
      NormalsOf(piece, xi, found);
      auto from = found.cbegin();
      for (const KeyRun& run : of)
      {
        const auto count = static_cast<std::ptrdiff_t>(run.end - run.begin);
        std::copy_n(from, count, normals.begin() + static_cast<std::ptrdiff_t>(run.begin));
        from += count;
      }
    });
}
} // namespace pixelexact
