// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/CurvedSurface.h"

#include "Core/Base/CheckedOut.h"
#include "Trace/RunsByKey.h"
#include "Trace/Scene.h"
#include "Trace/Surfaces/Curved/BundleHits.h"
#include "Trace/Surfaces/Curved/FaceBox.h"
#include "Trace/Surfaces/Curved/FaceNormals.h"
#include "Trace/Surfaces/Curved/PieceReferee.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Pieces are halved this often where rays are nearly tangent to them, then the referee decides: of
/// faces, and of volumes. It knows no magnitudes, which are halved until they are small.
constexpr int kDeepest[3] = { 16, 21, 30 };
/// The same of plateaus. A field's are halved for a hit that is not far from the ray.
constexpr int kDeepestPlateau[3] = { 0, 12, 12 };
/// Pieces that bend are halved this often for a bundle as a whole.
constexpr int kTogether = 8;
/// Of the referee, for a ray in a part: where a ray lies in a surface, no number of them decides.
constexpr int kBoxes = 4000;
/// Rays and pieces, in lanes, that are solved before pieces further behind are looked at: of faces,
/// and of volumes.
constexpr int kAhead[3] = { 96, 40, 40 };

struct Scratch
{
  RayBundle bundle;
  SolverWork work;
};

struct NormalScratch
{
  std::vector<KeyRun> runs;
  std::vector<Vec3> xi;
  std::vector<Vec3> found;
};
} // namespace

/// A bundle of rays and the parts that they meet.
class CurvedSurface::Meeting
{
public:
  Meeting(const CurvedSurface& surface, const RayLanes& rays, RayBundle& bundle, SolverWork& work)
    : Of(surface)
    , Rays(rays)
    , Bundle(bundle)
    , Work(work)
    , Kind(surface.TheEquation.field == nullptr         ? 0
          : surface.TheEquation.component != kMagnitude ? 1
                                                        : 2)
    , All(RaySet::First(bundle.Count()))
  {
  }

  void Run()
  {
    // Nearest first, by boxes of the parts themselves.
    Work.parts.clear();
    Of.Hierarchy->ForEach(Bundle,
      [this](int part, const Box3& box)
      {
        const Box3& own = Of.BoxOf(part, box);
        if (Bundle.MayMeet(own))
        {
          Work.parts.push_back({ Bundle.DepthOf(own), part, &own });
        }
      });
    std::ranges::sort(Work.parts,
      [](const PartAhead& a, const PartAhead& b)
      { return a.depth != b.depth ? a.depth < b.depth : a.part < b.part; });
    for (const PartAhead& one : Work.parts)
    {
      if (one.depth <= Bundle.Farthest())
      {
        MeetPart(one.part, *one.box);
      }
    }
  }

private:
  /// Those of the rays that may meet what lies in a box.
  [[nodiscard]] RaySet ThoseThatMayMeet(const Box3& box, const RaySet& rays) const
  {
    return Bundle.MayMeet(box) ? GetPieceKernels().meetBox(Bundle, box, rays) : RaySet();
  }

  void MeetPart(std::int32_t part, const Box3& box)
  {
    const RaySet rays = GetPieceKernels().meetBox(Bundle, box, All);
    if (rays.IsEmpty())
    {
      return;
    }
    Which = &Of.All[static_cast<std::size_t>(part)];
    Tree = &Of.TreeOf(part);
    PieceSolver solver(Of.TheEquation, *Which, *Tree, Bundle, Work);
    Part = part;
    IsBlurred = AreBlurred(Bundle, Of.TheEquation.mesh, *Which);
    Kept = Work.hits.size();
    BoxesLeft.fill(kBoxes);
    Work.unclear.clear();
    for (const auto& root : Tree->Roots())
    {
      Descend(solver, *root, rays);
    }
    Solve(solver);
    while (!Work.unclear.empty())
    {
      const std::vector<PieceRay> unclear = std::move(Work.unclear);
      Work.unclear.clear();
      for (const PieceRay& one : unclear)
      {
        RaySet ray;
        ray.Add(one.ray);
        Deeper(solver, *one.piece, ray);
      }
      Solve(solver);
    }
  }

  /// Solves for all that is listed; where one hit is enough, rays end at those that are found.
  void Solve(PieceSolver& solver)
  {
    solver.Solve();
    TakeHits();
  }

  void TakeHits()
  {
    if (Work.hits.size() == Kept)
    {
      return;
    }
    for (std::size_t k = Kept; k < Work.hits.size(); ++k)
    {
      Work.hits[k].part = Part;
    }
    Of.Review(*Which, Work.hits, Kept);
    for (std::size_t k = Kept; k < Work.hits.size() && Rays.nearestOnly; ++k)
    {
      const CurvedHit& hit = Work.hits[k];
      if (hit.t >= Rays.tNear[Bundle.First() + hit.ray])
      {
        Bundle.EndAt(hit.ray, Bundle.DepthAt(hit.ray, hit.t));
      }
    }
    if (Rays.nearestOnly && Work.hits.size() > Kept)
    {
      Bundle.FindFarthest();
    }
    Kept = Work.hits.size();
  }

  void Descend(PieceSolver& solver, const CurvedPiece& piece, const RaySet& rays)
  {
    if (piece.IsEmpty() || !Bundle.MayMeet(piece.bounds) ||
      Bundle.DepthOf(piece.bounds) > Bundle.Farthest())
    {
      return;
    }
    // Further down each ray is asked: a bundle may meet far more pieces than its rays do.
    if (!piece.flat && piece.halvings < kTogether)
    {
      Deeper(solver, piece, rays);
      return;
    }
    const RaySet near = GetPieceKernels().meetBox(Bundle, piece.bounds, rays);
    if (near.IsEmpty())
    {
      return;
    }
    const RaySet unclear = piece.flat ? solver.Look(piece, near) : near;
    // What lies behind the hits of enough rays need not be looked at.
    if (Rays.nearestOnly && Work.pairs.count >= kAhead[Kind])
    {
      Solve(solver);
    }
    if (!unclear.IsEmpty())
    {
      Deeper(solver, piece, unclear);
    }
  }

  void Deeper(PieceSolver& solver, const CurvedPiece& piece, const RaySet& rays)
  {
    if (IsBlurred || piece.halvings >= (piece.plateau ? kDeepestPlateau : kDeepest)[Kind])
    {
      Solve(solver);
      FindHits(Of.TheEquation, *Which, *Tree, Bundle, solver, piece,
        ThoseThatMayMeet(piece.bounds, rays), BoxesLeft, Work.hits);
      TakeHits();
      return;
    }
    const std::array<CurvedPiece, 2>& halves = Tree->Split(piece);
    const std::size_t first =
      Bundle.DepthOf(halves[0].bounds) <= Bundle.DepthOf(halves[1].bounds) ? 0 : 1;
    Descend(solver, halves[first], rays);
    Descend(solver, halves[1 - first], rays);
  }

  const CurvedSurface& Of;
  const RayLanes& Rays;
  RayBundle& Bundle;
  SolverWork& Work;
  std::size_t Kind;
  RaySet All;
  std::array<int, RayBundle::kMost> BoxesLeft{};
  std::int32_t Part = -1;
  bool IsBlurred = false; ///< what the part's pieces leave open is undecided
  std::size_t Kept = 0;   ///< hits that have been reviewed
  const CurvedPart* Which = nullptr;
  const PartTree* Tree = nullptr;
};

CurvedSurface::CurvedSurface(
  const CurvedEquation& equation, std::vector<CurvedPart> parts, std::span<const Box3> boxes)
  : TheEquation(equation)
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
    [&] { return std::make_unique<const PartTree>(TheEquation, PartOf(part), ModesOf(part)); });
}

const FaceModes* CurvedSurface::ModesOf(std::int32_t part) const
{
  if (TheEquation.field != nullptr)
  {
    return nullptr;
  }
  const std::optional<FaceModes>& modes = Modes.Get(static_cast<std::size_t>(part),
    [&]
    {
      return std::make_unique<const std::optional<FaceModes>>(
        Restriction.Of(TheEquation.mesh, PartOf(part)));
    });
  return modes ? &*modes : nullptr;
}

const Box3& CurvedSurface::BoxOf(std::int32_t part, const Box3& around) const
{
  return TheEquation.field != nullptr ? around
                                      : Boxes.Get(static_cast<std::size_t>(part),
                                          [&] {
                                            return std::make_unique<const Box3>(FaceBox(
                                              TheEquation.mesh, PartOf(part), ModesOf(part)));
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
  FaceNormals(FaceMap(TheEquation.mesh, PartOf(part), ModesOf(part)), xi, normals);
}

void CurvedSurface::Meet(const RayLanes& rays, HitSlots& hits) const
{
  for (int first = 0; Hierarchy && first < rays.count; first += RayBundle::kMost)
  {
    MeetSome(rays, first, std::min(RayBundle::kMost, rays.count - first), hits);
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

void CurvedSurface::MeetSome(const RayLanes& rays, int first, int count, HitSlots& hits) const
{
  const CheckedOut<Scratch> scratch;
  auto& [bundle, work] = *scratch;
  work.hits.clear();
  work.unclear.clear();
  for (unsigned ways = GetBundleKernels().ways(rays, first, count); ways != 0; ways &= ways - 1)
  {
    bundle.Begin(rays, first, count, std::countr_zero(ways), Hierarchy->Bounds());
    Meeting(*this, rays, bundle, work).Run();
  }
  WriteHits(rays, first, count, { All, TheEquation.mesh, TellsElements() }, work.hits, hits);
}
} // namespace pixelexact
