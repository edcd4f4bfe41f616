// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Clipped.h"

#include "Core/Base/CheckedOut.h"
#include "Trace/Surfaces/Arguments.h"

#include <algorithm>
#include <utility>

namespace pixelexact
{
namespace
{
struct KeptHit
{
  double t;
  HitStatus status;
  SurfacePoint point;
};

struct ClippedScratch
{
  std::vector<HitSlots> ofParts;
  std::vector<KeptHit> found;
};
} // namespace

Clipped::Clipped(std::vector<std::shared_ptr<const Surface>> parts, std::vector<Side> clips)
  : Parts(std::move(parts))
  , Clips(std::move(clips))
{
  if (Parts.empty())
  {
    Refuse("clipped surface", "there are no parts");
  }
}

bool Clipped::IsKept(const Vec3& x) const
{
  return std::ranges::none_of(Clips, [&x](const Side& clip) { return clip(x) > 0.0; });
}

void Clipped::Meet(const RayLanes& rays, HitSlots& hits) const
{
  const CheckedOut<ClippedScratch> scratch;
  std::vector<HitSlots>& ofParts = (*scratch).ofParts;
  std::vector<KeptHit>& found = (*scratch).found;
  ofParts.resize(std::max(ofParts.size(), Parts.size()));
  RayLanes all = rays;
  all.nearestOnly = false; // the nearest hit may be clipped
  for (std::size_t p = 0; p < Parts.size(); ++p)
  {
    ofParts[p].Begin(rays.count);
    Parts[p]->Meet(all, ofParts[p]);
  }
  for (int i = 0; i < rays.count; ++i)
  {
    found.clear();
    for (std::size_t p = 0; p < Parts.size(); ++p)
    {
      const HitSlots& slots = ofParts[p];
      for (int k = 0; k < slots.Count() && slots.T(k)[i] < kNoHit; ++k)
      {
        SurfacePoint point = slots.PointOf(k, i);
        if (IsKept(point.position))
        {
          if (!IsSingle())
          {
            point.parameters[0] = point.piece;
            point.piece = static_cast<std::int32_t>(p);
          }
          found.push_back({ slots.T(k)[i], slots.StatusOf(k, i), point });
        }
      }
    }
    std::ranges::stable_sort(found, {}, &KeptHit::t);
    for (int k = 0; k < static_cast<int>(found.size()); ++k)
    {
      const auto& [t, status, point] = found[static_cast<std::size_t>(k)];
      const HitLanes slot = hits.Slot(k);
      slot.t[i] = t;
      for (int d = 0; d < 3; ++d)
      {
        slot.position[d][i] = point.position[d];
      }
      const PieceLanes pieces = hits.Pieces(k);
      pieces.piece[i] = point.piece;
      pieces.parameters[0][i] = point.parameters[0];
      pieces.parameters[1][i] = point.parameters[1];
      if (status != HitStatus::Certain)
      {
        hits.Status(k)[i] = status;
      }
      if (IsOfMesh())
      {
        const ElementLanes elements = hits.Elements(k);
        elements.element[i] = point.element;
        for (int d = 0; d < 3; ++d)
        {
          elements.xi[d][i] = point.xi[d];
        }
      }
    }
  }
}

Vec3 Clipped::Normal(const SurfacePoint& point) const
{
  if (IsSingle())
  {
    return Parts.front()->Normal(point);
  }
  SurfacePoint ofPart = point;
  ofPart.piece = static_cast<std::int32_t>(point.parameters[0]);
  return Parts[static_cast<std::size_t>(point.piece)]->Normal(ofPart);
}

void Clipped::Normals(std::span<const SurfacePoint> points, std::span<Vec3> normals) const
{
  if (IsSingle())
  {
    Parts.front()->Normals(points, normals);
    return;
  }
  Surface::Normals(points, normals);
}

bool Clipped::HasCostlyNormals() const
{
  return std::ranges::any_of(Parts, [](const auto& part) { return part->HasCostlyNormals(); });
}

bool Clipped::NeedsCallingThread() const
{
  return std::ranges::any_of(Parts, [](const auto& part) { return part->NeedsCallingThread(); });
}

bool Clipped::IsFlat() const
{
  return IsSingle() && Parts.front()->IsFlat();
}

bool Clipped::MayMeet(const Outline& part, double slack, EdgeWork* work) const
{
  return std::ranges::any_of(
    Parts, [&](const auto& one) { return one->MayMeet(part, slack, work); });
}

std::optional<double> Clipped::HeldValue(const Field& field, int component) const
{
  return IsSingle() ? Parts.front()->HeldValue(field, component) : std::nullopt;
}

bool Clipped::IsOfMesh() const
{
  return IsSingle() && Parts.front()->IsOfMesh();
}

int Clipped::FaceOf(std::int32_t piece) const
{
  return IsSingle() ? Parts.front()->FaceOf(piece) : -1;
}
} // namespace pixelexact
