// SPDX-License-Identifier: BSD-3-Clause
// Intersection of a bundle of rays with the parts of a curved surface.
#include "Trace/Surfaces/Curved/CurvedSurface.h"

#include "Core/Base/CheckedOut.h"
#include "Core/Questions/EdgeWork.h"
#include "Trace/Scene.h"
#include "Trace/Surfaces/Curved/BundleHits.h"
#include "Trace/Surfaces/Curved/PieceFallback.h"

#include <algorithm>
#include <bit>
#include <memory>
#include <tuple>
#include <vector>

namespace pixelexact
{
namespace
{
/// Subdivisions of pieces for all rays of a bundle together, of faces and of volumes. A ray that is
/// open in such a piece is then processed alone.
constexpr int kShared[3] = { 12, 14, 14 };
/// Subdivisions of pieces where rays are nearly tangent, before the fallback (FindHits) decides: of
/// faces, of volumes, and of magnitudes, which the fallback does not support.
constexpr int kMaxDepth[3] = { 16, 21, 30 };
/// Subdivisions of plateaus, from the largest plateau piece on. A field's plateaus are subdivided
/// so that only rays that pass near them are undecided.
constexpr int kMaxPlateauDepth[3] = { 0, 12, 12 };
/// Subdivisions of pieces that bend for a bundle as a whole, without a test of each ray.
constexpr int kTogether = 8;
/// Estimated cost, in nanoseconds, of a ray's test of a piece's children, without the children.
constexpr std::int64_t kCostOfLook = 1500;
/// Children also serve neighbouring rays. A ray pays this fraction of their cost, kept or not.
constexpr std::int64_t kShareOfChildren = 4;
/// Count of pairs of rays and pieces that are solved before pieces behind them are tested: of
/// faces, and of volumes.
constexpr int kAhead[3] = { 96, 40, 40 };

struct Scratch
{
  RayBundle bundle;
  SolverWork work;
};

/// Piece a lies behind b for a ray. The order does not depend on the order in which pieces were
/// found.
bool IsBehind(const OpenPiece& a, const OpenPiece& b)
{
  const auto key = [](const OpenPiece& one)
  {
    const Vec3& lower = one.piece->box.lower;
    return std::tuple(one.depth, one.part, lower.x, lower.y, lower.z, one.piece->subdivisions);
  };
  return key(a) > key(b);
}
} // namespace

/// A bundle of rays and the parts that they meet. All rays are processed together while most of
/// them need it, then each remaining ray alone, within RayLanes::work.
class CurvedSurface::Meeting
{
public:
  Meeting(const CurvedSurface& surface, const RayLanes& rays, RayBundle& bundle, SolverWork& work)
    : Of(surface)
    , Rays(rays)
    , Bundle(bundle)
    , Work(work)
    , Kind(surface.equation_.field == nullptr         ? 0
          : surface.equation_.component != kMagnitude ? 1
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
    MeetOpen();
  }

private:
  void MeetPart(std::int32_t part, const Box3& box)
  {
    const RaySet rays = GetPieceKernels().meetBox(Bundle, box, All);
    if (rays.IsEmpty())
    {
      return;
    }
    Enter(part, TreeOf(part));
    PieceSolver solver(Of.equation_, *Which, *Tree, Bundle, Work);
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

  /// Makes a part the current one.
  void Enter(std::int32_t part, const PartTree& tree)
  {
    Part = part;
    Which = &Of.All[static_cast<std::size_t>(part)];
    Tree = &tree;
    IsBlurred = AreBlurred(Bundle, Of.equation_.mesh, *Which);
    Kept = Work.hits.size();
  }

  /// The surface's tree or, if the memory limit is reached, one for this bundle alone.
  [[nodiscard]] const PartTree& TreeOf(std::int32_t part)
  {
    if (Of.Trees.IfMade(static_cast<std::size_t>(part)) == nullptr && PartTree::AreFull())
    {
      OwnTrees.push_back(std::make_unique<const PartTree>(
        Of.equation_, Of.All[static_cast<std::size_t>(part)], Of.ModesOf(part)));
      return *OwnTrees.back();
    }
    return Of.TreeOf(part);
  }

  /// Solves all listed pairs. If one hit suffices, rays end at their hits.
  void Solve(PieceSolver& solver)
  {
    solver.Solve();
    TakeHits();
  }

  /// Takes over the new hits. Hits that stand for a piece, not for a point of it, are not reviewed.
  void TakeHits(bool arePoints = true)
  {
    if (Work.hits.size() == Kept)
    {
      return;
    }
    for (std::size_t k = Kept; k < Work.hits.size(); ++k)
    {
      Work.hits[k].part = Part;
    }
    if (arePoints)
    {
      Of.Review(*Which, Work.hits, Kept);
    }
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
    // At deeper levels each ray is tested: a bundle may meet far more pieces than its rays do.
    if (!piece.flat && piece.subdivisions < kTogether)
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
    // Pieces behind the hits of enough rays need no test.
    if (Rays.nearestOnly && Work.pairs.count >= kAhead[Kind])
    {
      Solve(solver);
    }
    if (!unclear.IsEmpty())
    {
      Deeper(solver, piece, unclear);
    }
  }

  [[nodiscard]] bool IsLast(const CurvedPiece& piece) const
  {
    return IsBlurred ||
      (piece.plateau ? piece.subdivisions - piece.plateauFrom >= kMaxPlateauDepth[Kind]
                     : piece.subdivisions >= kMaxDepth[Kind]);
  }

  void Deeper(PieceSolver& solver, const CurvedPiece& piece, const RaySet& rays)
  {
    if (piece.subdivisions >= kShared[Kind] || IsLast(piece))
    {
      rays.ForEach(
        [&](int ray) {
          Work.open.push_back(
            { &piece, Tree, Part, ray, Bundle.DepthOf(piece.bounds, ray), nullptr });
        });
      return;
    }
    const PieceChildren children = Tree->GetChildren(piece);
    if (children.own)
    {
      OwnPieces.push_back(children.own);
    }
    const auto& [lower, upper] = *children.pieces;
    const bool inOrder = Bundle.DepthOf(lower.bounds) <= Bundle.DepthOf(upper.bounds);
    Descend(solver, inOrder ? lower : upper, rays);
    Descend(solver, inOrder ? upper : lower, rays);
  }

  [[nodiscard]] bool MayMeet(const CurvedPiece& piece, const RaySet& ray) const
  {
    return !piece.IsEmpty() && !GetPieceKernels().meetBox(Bundle, piece.bounds, ray).IsEmpty();
  }

  /// Processes the rays that are open in pieces, one after the other.
  void MeetOpen()
  {
    std::ranges::stable_sort(Work.open, {}, &OpenPiece::ray);
    std::vector<OpenPiece> open;
    for (auto at = Work.open.begin(); at != Work.open.end();)
    {
      const auto end =
        std::find_if(at, Work.open.end(), [&](const OpenPiece& one) { return one.ray != at->ray; });
      open.assign(at, end);
      std::ranges::make_heap(open, IsBehind);
      MeetAlone(open);
      at = end;
    }
    Work.open.clear();
  }

  /// Processes the nearest piece first. If the work is exhausted, all undecided pieces lie behind
  /// the decided ones. The hits of a ray depend on no other ray, and not on kept pieces.
  void MeetAlone(std::vector<OpenPiece>& open)
  {
    EdgeWork work(Rays.work);
    std::vector<std::int32_t> given; // parts in which the ray ended undecided
    std::optional<PieceSolver> solver;
    RaySet ray;
    ray.Add(open.front().ray);
    while (!open.empty())
    {
      std::ranges::pop_heap(open, IsBehind);
      const OpenPiece one = std::move(open.back());
      open.pop_back();
      if (!MayMeet(*one.piece, ray) || std::ranges::find(given, one.part) != given.end())
      {
        continue;
      }
      if (!solver || one.part != Part)
      {
        Enter(one.part, *one.tree);
        solver.emplace(Of.equation_, *Which, *Tree, Bundle, Work);
      }
      if (IsLast(*one.piece))
      {
        FindHits({ Of.equation_, *Which, *Tree, Bundle, Rays }, *solver, one, work, Work.hits);
        TakeHits();
      }
      else if (!work.Affords(kCostOfLook + Tree->SplitCost() / kShareOfChildren))
      {
        AddUndecided(Bundle, Rays, *solver, one, Work.hits);
        TakeHits(false);
        given.push_back(one.part);
      }
      else
      {
        LookAtChildren(*solver, one, ray, open);
      }
    }
  }

  void LookAtChildren(
    PieceSolver& solver, const OpenPiece& one, const RaySet& ray, std::vector<OpenPiece>& open)
  {
    const PieceChildren children = Tree->GetChildren(*one.piece);
    const auto& own = children.own ? children.own : one.own;
    for (const CurvedPiece& half : *children.pieces)
    {
      if (!MayMeet(half, ray))
      {
        continue;
      }
      Work.unclear.clear();
      const RaySet unclear = half.flat ? solver.Look(half, ray) : ray;
      Solve(solver);
      if (!unclear.IsEmpty() || !Work.unclear.empty())
      {
        open.push_back({ &half, Tree, Part, one.ray, Bundle.DepthOf(half.bounds, one.ray), own });
        std::ranges::push_heap(open, IsBehind);
      }
    }
    Work.unclear.clear();
  }

  const CurvedSurface& Of;
  const RayLanes& Rays;
  RayBundle& Bundle;
  SolverWork& Work;
  std::size_t Kind;
  RaySet All;
  std::int32_t Part = -1;
  bool IsBlurred = false; ///< rays that the part's pieces leave open are undecided
  std::size_t Kept = 0;   ///< hits that have been reviewed
  const CurvedPart* Which = nullptr;
  const PartTree* Tree = nullptr;
  // Trees and pieces above the memory limit.
  std::vector<std::unique_ptr<const PartTree>> OwnTrees;
  std::vector<std::shared_ptr<const std::array<CurvedPiece, 2>>> OwnPieces;
};

void CurvedSurface::MeetSome(const RayLanes& rays, int first, int count, HitSlots& hits) const
{
  const CheckedOut<Scratch> scratch;
  auto& [bundle, work] = *scratch;
  work.hits.clear();
  work.unclear.clear();
  work.open.clear();
  for (unsigned ways = GetBundleKernels().ways(rays, first, count); ways != 0; ways &= ways - 1)
  {
    bundle.Begin(rays, first, count, std::countr_zero(ways), Hierarchy->Bounds());
    Meeting(*this, rays, bundle, work).Run();
  }
  WriteHits(rays, first, count, { All, equation_.mesh, TellsElements() }, work.hits, hits);
}
} // namespace pixelexact
