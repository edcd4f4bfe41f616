// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/PointSearch.h"

#include "Core/Location/ApexRoot.h"
#include "Core/Location/FoundRoots.h"
#include "Core/Location/GroupNewton.h"
#include "Core/Tree/Regularity.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pixelexact
{
namespace
{
/// The cost of testing a node against a group, in the units of kMaxWork (PointSearch.h).
constexpr std::int64_t kVisitCost = 50;

/// The work budget per point of a group, increased where one subdivision costs a large share of it.
std::int64_t MostWorkIn(const ElementTree& tree, std::span<const SoughtPoint> points)
{
  constexpr std::int64_t kFewSplits = 100;
  const std::int64_t least = std::ranges::min(points, {}, &SoughtPoint::mostWork).mostWork;
  const std::int64_t high =
    std::clamp(kFewSplits * tree.SplitCost(), kMaxWork, kMaxWorkOfHighOrders);
  return least * (high / 1000) / (kMaxWork / 1000);
}

/// The fraction of the element's volume in eta.
double PartOfElement(const EtaBox& box)
{
  const Vec3 sides = 0.5 * (box.upper - box.lower);
  return sides.x * sides.y * sides.z;
}

/// The search for a group.
class Search
{
public:
  Search(ElementTree& tree, std::span<const SoughtPoint> points, Wanted wanted)
    : Tree(tree)
    , Problem(tree.Problem())
    , shape_(Problem.space.shape)
    , Kernels(GetTreeKernels())
    , Reach(ReachOf(tree.Degree()))
    , MostWork(MostWorkIn(tree, points))
    , Checker(Problem)
    , Roots(wanted == Wanted::All)
  {
    Group.points = points;
    for (std::size_t i = 0; i < kGroupPoints; ++i)
    {
      const Vec3& x = points[std::min(i, points.size() - 1)].x;
      for (int c = 0; c < 3; ++c)
      {
        Group.y.x[c][i] = (x[c] - Problem.centre[c]) * Problem.inverseSize;
      }
    }
  }

  /// Returns false where the work budget of the group is exhausted.
  bool Run()
  {
    TakeKnownRoots();
    const Bits all = ~Bits{ 0 } >> (64U - Group.points.size());
    Work += Tree.BeginCost();
    if (Work <= MostWork)
    {
      for (const auto& piece : Tree.Pieces())
      {
        Visit(*piece, all, 0);
      }
    }
    return Work <= MostWork;
  }

  void Write(std::span<Preimages> answers) const
  {
    for (std::size_t i = 0; i < Group.points.size(); ++i)
    {
      Preimages& answer = answers[i];
      answer.roots.clear();
      std::ranges::copy_if(Roots.Of(i), std::back_inserter(answer.roots),
        [](const InverseRoot& root) { return root.inside; });
      const bool undecided = Work > MostWork || (Undecided & BitOf(i)) != 0;
      answer.complete = !undecided;
      answer.boxes = Boxes;
      answer.verdict = !answer.roots.empty() ? Verdict::Inside
        : undecided                          ? Verdict::Unknown
                                             : Verdict::Outside;
    }
  }

private:
  void TakeKnownRoots()
  {
    std::array<Vec3, kGroupPoints> xi;
    std::array<Vec3, kGroupPoints> y;
    std::array<std::size_t, kGroupPoints> which{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < Group.points.size(); ++i)
    {
      const Vec3& known = Group.points[i].known;
      if (std::isfinite(known.x + known.y + known.z))
      {
        which[count] = i;
        y[count] = Group.YOf(i);
        xi[count++] = known;
      }
    }
    if (count == 0)
    {
      return;
    }
    std::array<RootCheck, kGroupPoints> checks;
    Checker.Run(std::span(xi).first(count), std::span(y).first(count), checks);
    for (std::size_t k = 0; k < count; ++k)
    {
      Roots.Keep(which[k], { xi[k], 0.0, false, false }, checks[k]);
      Known |= BitOf(which[k]);
    }
  }

  /// `searched`: points for which the map is regular on a box around this one, and Newton's
  /// iteration has found a root elsewhere.
  void Visit(ElementTree::Node& node, Bits points, Bits searched)
  {
    points &= ~Roots.Done();
    if (points == 0 || Work > MostWork)
    {
      return;
    }
    ++Boxes;
    Work += kVisitCost;
    const NodeFrame& frame = node.Frame();
    const double* const y[3] = { Group.y.x[0], Group.y.x[1], Group.y.x[2] };
    points = Kernels.classify(frame, y, points).near;
    if (points == 0)
    {
      return;
    }
    if (IsAtApex(shape_, frame))
    {
      ForEachBit(points, [&](std::size_t i) { TakeApex(frame, i); });
      return;
    }
    if (const Bits tried = points & Promising(frame, searched); tried != 0)
    {
      const Bits left = tried & ~Settled(node, tried);
      const Bits begun = left & WorthNewton(frame, Known);
      const Bits found = begun == 0 ? 0 : Newton(frame, begun);
      const Bits open = found & ~Roots.Done();
      const Bits settled = open == 0 ? 0 : Settled(node, open);
      points &= ~(tried & ~left) & ~Roots.Done() & ~settled;
      if (const Bits rest = open & ~settled; rest != 0)
      {
        searched = IsRegular(node) ? searched | rest : searched & ~rest;
      }
    }
    if (points == 0)
    {
      return;
    }
    if (Problem.affine && frame.IsAffine())
    {
      // The frame's root is the only one, and a smaller box would not improve it.
      ForEachBit(points & ~Known, [&](std::size_t i) { TakeStraight(frame, i); });
      points &= Known;
    }
    if (points == 0)
    {
      return;
    }
    // Smaller boxes would refine where a flat element ends, but no root in it.
    constexpr double kSmallBox = 1.0 / 4096.0;
    if (!frame.IsNearlyAffine(1.0) && PartOfElement(frame.box) <= kSmallBox && Tree.IsFlat(node))
    {
      Undecided |= points;
      return;
    }
    Work += Tree.SplitCost(node);
    if (Work > MostWork)
    {
      return;
    }
    if (!Tree.Split(node))
    {
      Undecided |= points;
      return;
    }
    Visit(node.Child(0), points, searched);
    Visit(node.Child(1), points, searched);
  }

  /// Returns the points for which the box may be settled.
  [[nodiscard]] Bits Promising(const NodeFrame& frame, Bits searched) const
  {
    // A root besides the known one is rare.
    constexpr double kWithKnown = 0.125;
    const Bits affine = frame.IsAffine() ? searched : 0;
    const Bits known = frame.IsNearlyAffine(kWithKnown) ? Known & ~searched : 0;
    const Bits others = frame.IsNearlyAffine(1.0) ? ~Known & ~searched : 0;
    return affine | known | others;
  }

  /// Returns the points for which Newton's iteration starts. Where a root is known, the iteration
  /// finds it again, and subdivision excludes the point in less time, except near a fold, which
  /// takes many boxes.
  [[nodiscard]] static Bits WorthNewton(const NodeFrame& frame, Bits known)
  {
    constexpr double kWithKnown = 0.015;
    constexpr double kSmallBox = 0.05;
    return PartOfElement(frame.box) <= kSmallBox || frame.IsNearlyAffine(kWithKnown) ||
        frame.IsAffine()
      ? ~Bits{ 0 }
      : ~known;
  }

  void TakeApex(const NodeFrame& frame, std::size_t point)
  {
    const auto [xi, moved, check] = RootAtApex(Problem, Checker, frame, Group.YOf(point));
    // The map is not proven to be injective around the root. At a fold, points that hold reach to
    // sixteen tolerances of its ends; two that are closer than twice that may be one root, or none.
    constexpr double kIsOne = 4.0;
    constexpr double kMayBeOne = 32.0;
    if (!check.holds ||
      (!Roots.IsKnown(point, xi, true, check, kIsOne) &&
        Roots.IsKnown(point, xi, true, check, kMayBeOne)))
    {
      Undecided |= BitOf(point);
    }
    if (check.holds)
    {
      Roots.Add(point, { xi, moved, true, check.IsOnFace(shape_, xi) }, check);
    }
  }

  /// Takes a root in an element that is straight up to its uncertainty. Newton's iteration leaves
  /// it open because it lies far outside a face, yet within the faces' tolerance: nodes in single
  /// precision far from the origin have no higher precision. The point counts as inside; its xi is
  /// moved towards the shape's centre, to where the map and the field are accepted.
  void TakeStraight(const NodeFrame& frame, std::size_t point)
  {
    constexpr double kTrusted = 1e-2;
    constexpr double kMaxTolerance = 0.25;
    const Vec3 y = Group.YOf(point);
    const Vec3 root = frame.Root(y);
    RootCheck check;
    Checker.Run(std::span(&root, 1), std::span(&y, 1), std::span(&check, 1));
    const Vec3& t = check.tolerance;
    const double beyond = -Margin(shape_, root);
    if (!(check.holds && beyond <= t.x + t.y + t.z && t.x + t.y + t.z <= kMaxTolerance))
    {
      Undecided |= BitOf(point);
      return;
    }
    const Vec3 centre = Centre(shape_);
    const double inner = Margin(shape_, centre);
    const double part = beyond > kTrusted ? (inner + kTrusted) / (inner + beyond) : 1.0;
    Roots.Add(point, { centre + part * (root - centre), 0.0, true, true }, check);
  }

  /// Returns the points for which the box holds no root except a known one.
  Bits Settled(ElementTree::Node& node, Bits points)
  {
    const EtaBox& box = node.Frame().box;
    Bits settled = 0;
    if (node.IsPoint())
    {
      const Box3 hull = HullInXi(shape_, box);
      ForEachBit(points, [&](std::size_t i) { settled |= Roots.IsAll(hull, i) ? BitOf(i) : 0; });
    }
    Bits reached = 0;
    for (const GroupRoots& roots : Roots.Lanes())
    {
      reached |= Kernels.reached(box, shape_, Reach, roots, points & ~settled & ~reached);
    }
    return reached != 0 && IsRegular(node) ? settled | reached : settled;
  }

  bool IsRegular(ElementTree::Node& node)
  {
    Work += Tree.RegularCost(node);
    return Tree.IsRegular(node);
  }

  Bits Newton(const NodeFrame& frame, Bits points)
  {
    Work += NewtonCost(Problem.space, std::popcount(points));
    return RunNewton(Problem, Checker, frame, Group, points, Roots);
  }

  ElementTree& Tree;
  const InverseProblem& Problem;
  Shape shape_;
  const TreeKernels& Kernels;
  double Reach;
  std::int64_t MostWork;
  RootChecker Checker;
  PointGroup Group;
  FoundRoots Roots;
  Bits Known = 0; ///< with a root from before
  Bits Undecided = 0;
  int Boxes = 0;
  std::int64_t Work = 0;
};

} // namespace

void FindPreimages(ElementTree& tree, std::span<const SoughtPoint> points, Wanted wanted,
  std::span<Preimages> answers)
{
  if (points.empty())
  {
    return;
  }
  Search search(tree, points, wanted);
  if (search.Run() || points.size() == 1)
  {
    search.Write(answers);
    return;
  }
  // A single point may be decided within its own budget.
  const std::size_t half = points.size() / 2;
  FindPreimages(tree, points.first(half), wanted, answers.first(half));
  FindPreimages(tree, points.subspan(half), wanted, answers.subspan(half));
}
} // namespace pixelexact
