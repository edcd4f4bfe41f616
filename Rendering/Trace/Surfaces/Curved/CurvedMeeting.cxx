// SPDX-License-Identifier: BSD-3-Clause
// How a bundle of rays meets the parts of a curved surface.
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
/// Pieces are halved this often for the rays of a bundle together, of faces and of volumes. A ray
/// that is open in such a piece is met alone.
constexpr int kShared[3] = { 12, 14, 14 };
/// Pieces are halved this often where rays are nearly tangent to them, then the referee decides: of
/// faces, and of volumes. It knows no magnitudes, which are halved until they are small.
constexpr int kMaxDepth[3] = { 16, 21, 30 };
/// Plateaus are halved this often, from the largest piece that is one: those of a field, so that
/// they are undecided for rays alone that pass next to them.
constexpr int kDeepestPlateau[3] = { 0, 12, 12 };
/// Pieces that bend are halved this often for a bundle as a whole.
constexpr int kTogether = 8;
/// Estimated, in nanoseconds: what a ray costs in the halves of a piece, beside the halves.
constexpr std::int64_t kCostOfLook = 1500;
/// Children are kept for the rays beside this one. A ray pays this part of them, kept or not.
constexpr std::int64_t kShareOfChildren = 4;
/// Rays and pieces, in lanes, that are solved before pieces further behind are looked at: of faces,
/// and of volumes.
constexpr int kAhead[3] = { 96, 40, 40 };

struct Scratch
{
  RayBundle bundle;
  SolverWork work;
};

/// Whether a piece lies behind another for a ray, whatever order they were found in.
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

/// A bundle of rays and the parts that they meet: by all rays together, as far as most of them
/// need, then by each of the others alone, which may spend RayLanes::work.
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

  /// What follows is of this part.
  void Enter(std::int32_t part, const PartTree& tree)
  {
    Part = part;
    Which = &Of.All[static_cast<std::size_t>(part)];
    Tree = &tree;
    IsBlurred = AreBlurred(Bundle, Of.equation_.mesh, *Which);
    Kept = Work.hits.size();
  }

  /// The surface's, or one for this bundle alone where no more may be kept.
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

  /// Solves for all that is listed; where one hit is enough, rays end at those that are found.
  void Solve(PieceSolver& solver)
  {
    solver.Solve();
    TakeHits();
  }

  /// The new hits. A hit that stands for a piece, and for no point of it, is not reviewed.
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
    // Further down each ray is asked: a bundle may meet far more pieces than its rays do.
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

  [[nodiscard]] bool IsLast(const CurvedPiece& piece) const
  {
    return IsBlurred ||
      (piece.plateau ? piece.subdivisions - piece.plateauFrom >= kDeepestPlateau[Kind]
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

  /// Rays that are open in pieces, one after the other.
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

  /// The nearest piece first: where the work is exhausted, what has not been decided lies behind
  /// what has. What a ray meets depends on no other ray, and on nothing that is kept.
  void MeetAlone(std::vector<OpenPiece>& open)
  {
    EdgeWork work(Rays.work);
    std::vector<std::int32_t> given; // parts in which the ray is given up
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
  bool IsBlurred = false; ///< what the part's pieces leave open is undecided
  std::size_t Kept = 0;   ///< hits that have been reviewed
  const CurvedPart* Which = nullptr;
  const PartTree* Tree = nullptr;
  // Where the trees keep no more.
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
