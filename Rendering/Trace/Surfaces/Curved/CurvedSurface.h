// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/MadeOnDemand.h"
#include "Trace/Surfaces/Curved/BundleHierarchy.h"
#include "Trace/Surfaces/Curved/FaceModes.h"
#include "Trace/Surfaces/Curved/PartTree.h"
#include "Trace/Surfaces/Curved/PieceSolver.h"
#include "Trace/Surfaces/Surface.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace pixelexact
{
/// Base of element faces, patches and iso-surfaces. Their parts in elements are divided into pieces
/// when rays come near them, and a hierarchy holds the parts' boxes.
///
/// Every hit that is not Undecided exists, and no others do, for the surface moved by at most the
/// mesh's uncertainty and rounding (some 1e-14 of the element's size). Hits of one ray within 1e-11
/// of the element's size are one hit, so that a point shared by two pieces or elements is met once.
/// A ray that touches the surface meets it once, or Undecided. Where a function is not finite there
/// is no surface.
class CurvedSurface : public Surface
{
public:
  void Meet(const RayLanes& rays, HitSlots& hits) const override;
  [[nodiscard]] bool HasCostlyNormals() const override { return true; }
  [[nodiscard]] Vec3 Normal(const SurfacePoint& point) const final;
  void Normals(std::span<const SurfacePoint> points, std::span<Vec3> normals) const final;

  /// Count of parts whose pieces have been computed, and of their pieces.
  [[nodiscard]] std::int64_t PartsMade() const
  {
    return static_cast<std::int64_t>(Trees.MadeCount());
  }
  [[nodiscard]] std::int64_t PiecesMade() const;
  [[nodiscard]] int Parts() const { return static_cast<int>(All.size()); }

protected:
  /// `boxes` contain the parts. The arrays of the equation must outlive the surface.
  CurvedSurface(
    const CurvedEquation& equation, std::vector<CurvedPart> parts, std::span<const Box3> boxes);

  [[nodiscard]] const CurvedEquation& Equation() const { return equation_; }
  [[nodiscard]] std::span<const CurvedPart> AllParts() const { return All; }
  [[nodiscard]] const CurvedPart& PartOf(std::int32_t part) const
  {
    return All[static_cast<std::size_t>(part)];
  }
  /// Reviews the hits of one part from number `first` on: removes those that do not count, and
  /// makes those that it cannot decide Undecided. The default keeps all.
  virtual void Review(
    const CurvedPart& part, std::vector<CurvedHit>& hits, std::size_t first) const;
  /// Unit normals at points of one part; zero where there is none. The default is the face's
  /// normals.
  virtual void NormalsOf(
    std::int32_t part, std::span<const Vec3> xi, std::span<Vec3> normals) const;
  /// Hits store element and xi. Otherwise, pieces have the first two xi as parameters; the third is
  /// -1.
  [[nodiscard]] virtual bool TellsElements() const { return true; }

private:
  class Meeting;
  [[nodiscard]] const PartTree& TreeOf(std::int32_t part) const;
  /// Null if there are none, and for iso-surfaces.
  [[nodiscard]] const FaceModes* ModesOf(std::int32_t part) const;
  /// A box of the part itself; for an iso-surface that of the element, which is `around`.
  [[nodiscard]] const Box3& BoxOf(std::int32_t part, const Box3& around) const;
  void MeetSome(const RayLanes& rays, int first, int count, HitSlots& hits) const;

  CurvedEquation equation_;
  std::vector<CurvedPart> All;
  std::unique_ptr<BundleHierarchy> Hierarchy;
  MadeOnDemand<PartTree> Trees;
  // Only for faces.
  MadeOnDemand<Box3> Boxes;
  FaceRestriction Restriction;
  MadeOnDemand<std::optional<FaceModes>> Modes;
};
} // namespace pixelexact
