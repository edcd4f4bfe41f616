// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/PointSearch.h"

#include "Core/Location/RootCheck.h"
#include "Core/Tree/Regularity.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>

namespace pixelexact
{
namespace
{
/// Roots nearer to each other than this, in a region where there can be but one, are one.
constexpr double kSameRoot = 1e-12;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Nanoseconds of work (PointSearch.h): a node against a group; Newton's iteration of a pack, and
/// of it per mode.
constexpr std::int64_t kVisitCost = 50;
constexpr std::int64_t kNewtonCost = 2000;
constexpr std::int64_t kNewtonCostOfMode = 20;
/// Where coefficients are more than the second cache holds.
constexpr std::int64_t kManyModes = 16384;
constexpr std::int64_t kNewtonCostOfManyModes = 50;

const Vec3 kApex(-1.0, -1.0, 1.0);
/// There no xi is better: kMostMiss for each of the elements that meet in it, and their rounding.
constexpr double kMostMissAtApex = 16.0;

using Bits = std::uint64_t;

Bits BitOf(int point)
{
  return Bits{ 1 } << static_cast<unsigned>(point);
}

/// visit(i) for each bit.
template <class Visit>
void ForEachPoint(Bits bits, Visit&& visit)
{
  for (; bits != 0; bits &= bits - 1)
  {
    visit(std::countr_zero(bits));
  }
}

double MaxAbs(const Vec3& x)
{
  return std::max({ std::fabs(x.x), std::fabs(x.y), std::fabs(x.z) });
}

/// What the points of a group may cost each, and more of it where a halving costs a good part.
std::int64_t MostWorkIn(const ElementTree& tree, std::span<const SoughtPoint> points)
{
  constexpr std::int64_t kFewSplits = 100;
  const std::int64_t least = std::ranges::min(points, {}, &SoughtPoint::mostWork).mostWork;
  const std::int64_t high =
    std::clamp(kFewSplits * tree.SplitCost(), kMostWork, kMostWorkOfHighOrders);
  return least * (high / 1000) / (kMostWork / 1000);
}

/// The search for a group.
class Search
{
public:
  Search(ElementTree& tree, std::span<const SoughtPoint> points, Wanted wanted)
    : Tree(tree)
    , Problem(tree.Problem())
    , TheShape(Problem.space.shape)
    , Kernels(GetTreeKernels())
    , Points(points)
    , Reach(ReachOf(tree.Degree()))
    , All(wanted == Wanted::All)
    , MostWork(MostWorkIn(tree, points))
    , Checker(Problem)
  {
    for (std::size_t i = 0; i < kGroupPoints; ++i)
    {
      const Vec3& x = points[std::min(i, points.size() - 1)].x;
      for (int c = 0; c < 3; ++c)
      {
        Y.x[c][i] = (x[c] - Problem.centre[c]) * Problem.inverseSize;
      }
    }
  }

  /// False where the work has become too much for the group.
  bool Run()
  {
    TakeKnownRoots();
    const auto count = static_cast<unsigned>(Points.size());
    const Bits all = ~Bits{ 0 } >> (64U - count);
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

  void Tell(std::span<Preimages> answers) const
  {
    for (std::size_t i = 0; i < Points.size(); ++i)
    {
      Preimages& answer = answers[i];
      answer.roots.clear();
      std::ranges::copy_if(Found[i], std::back_inserter(answer.roots),
        [](const InverseRoot& root) { return root.inside; });
      const bool undecided = Work > MostWork || (Undecided & BitOf(static_cast<int>(i))) != 0;
      answer.complete = !undecided;
      answer.boxes = Boxes;
      answer.verdict = !answer.roots.empty() ? Verdict::Inside
        : undecided                          ? Verdict::Unknown
                                             : Verdict::Outside;
    }
  }

private:
  [[nodiscard]] Vec3 YOf(int point) const
  {
    return { Y.x[0][point], Y.x[1][point], Y.x[2][point] };
  }

  void TakeKnownRoots()
  {
    std::array<Vec3, kGroupPoints> xi;
    std::array<Vec3, kGroupPoints> y;
    std::array<int, kGroupPoints> which{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < Points.size(); ++i)
    {
      const Vec3& known = Points[i].known;
      if (std::isfinite(known.x + known.y + known.z))
      {
        which[count] = static_cast<int>(i);
        y[count] = YOf(static_cast<int>(i));
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
      Keep(which[k], { xi[k], 0.0, false, false }, checks[k]);
      Known |= BitOf(which[k]);
    }
  }

  /// `searched`: points for which the map is regular on a box around this one, and Newton's
  /// iteration has found a root elsewhere.
  void Visit(ElementTree::Node& node, Bits points, Bits searched)
  {
    points &= ~Done;
    if (points == 0 || Work > MostWork)
    {
      return;
    }
    ++Boxes;
    Work += kVisitCost;
    const NodeFrame& frame = node.Frame();
    const double* const y[3] = { Y.x[0], Y.x[1], Y.x[2] };
    points = Kernels.judge(frame, y, points).near;
    if (points == 0)
    {
      return;
    }
    if (IsAtApex(frame))
    {
      ForEachPoint(points, [&](int i) { TakeApex(frame, i); });
      return;
    }
    if (const Bits tried = points & Promising(frame, searched); tried != 0)
    {
      const Bits left = tried & ~Settled(node, tried);
      const Bits begun = left & WorthNewton(frame, Known);
      const Bits found = begun == 0 ? 0 : RunNewton(frame, begun);
      const Bits open = found & ~Done;
      const Bits settled = open == 0 ? 0 : Settled(node, open);
      points &= ~(tried & ~left) & ~Done & ~settled;
      if (const Bits rest = open & ~settled; rest != 0)
      {
        searched = IsRegular(node) ? searched | rest : searched & ~rest;
      }
    }
    if (points == 0)
    {
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

  /// For which points a box may be settled.
  [[nodiscard]] Bits Promising(const NodeFrame& frame, Bits searched) const
  {
    // It is hardly ever that there is another root than the known one.
    constexpr double kWithKnown = 0.125;
    const Bits affine = frame.IsAffine() ? searched : 0;
    const Bits known = frame.IsNearlyAffine(kWithKnown) ? Known & ~searched : 0;
    const Bits others = frame.IsNearlyAffine(1.0) ? ~Known & ~searched : 0;
    return affine | known | others;
  }

  /// For which of them Newton's iteration is begun. Where a root is known it finds the same again,
  /// and halves exclude the point in less time; but for points by a fold, which take many.
  [[nodiscard]] static Bits WorthNewton(const NodeFrame& frame, Bits known)
  {
    constexpr double kWithKnown = 0.015;
    constexpr double kSmallBox = 0.05; // of the element
    double volume = 1.0;
    for (int d = 0; d < 3; ++d)
    {
      volume *= 0.5 * (frame.box.upper[d] - frame.box.lower[d]);
    }
    return volume <= kSmallBox || frame.IsNearlyAffine(kWithKnown) || frame.IsAffine() ? ~Bits{ 0 }
                                                                                       : ~known;
  }

  /// Next to a pyramid's apex there is no root beyond the faces to be held against the tolerance.
  /// Where it is all that keeps a box from excluding the point, the point is within it.
  [[nodiscard]] bool IsAtApex(const NodeFrame& frame) const
  {
    // Rounding may be as large as a box elsewhere, where the base is collapsed.
    constexpr double kLargest = 1e-3;
    const double rounding = std::max({ frame.slack[0], frame.slack[1], frame.slack[2] });
    const double depth = 1.0 - frame.box.lower.z;
    return TheShape == Shape::Pyramid && frame.IsAffine() &&
      (depth <= kApexRegion ||
        (frame.box.upper.z == 1.0 && depth <= std::min(4.0 * rounding, kLargest)));
  }

  /// The root, or the xi of the pyramid next to it. Newton's iteration with a Jacobian of its own:
  /// the box's, which is wide as seen from the apex, may lead away. What is found outside of the
  /// box's enclosure says nothing of the box.
  void TakeApex(const NodeFrame& frame, int point)
  {
    const Vec3 y = YOf(point);
    const Vec3 middle = frame.Root(y);
    Vec3 root = middle;
    Vec3 xi(0.0);
    constexpr int kSteps = 4;
    for (int step = 0; step < kSteps; ++step)
    {
      const double z = std::clamp(root.z, -1.0, 1.0);
      xi = { std::clamp(root.x, -1.0, -z), std::clamp(root.y, -1.0, -z), z };
      root = xi + StepOfMap(Problem.space, Problem.coefficients, xi, y);
    }
    RootCheck check;
    Checker.Run(std::span(&xi, 1), std::span(&y, 1), std::span(&check, 1));
    constexpr double kBeside = 4.0;
    for (int d = 0; d < 3; ++d)
    {
      check.holds = check.holds &&
        std::fabs(xi[d] - middle[d]) <= kBeside * frame.slack[static_cast<std::size_t>(d)];
    }
    // No Jacobian tells directions apart at the apex itself: there the box's is as good.
    const double atApex = kBeside * std::max({ frame.slack[0], frame.slack[1], frame.slack[2] });
    if (!check.holds && MaxAbs(middle - kApex) <= atApex)
    {
      xi = kApex;
      root = middle;
      Checker.Run(std::span(&xi, 1), std::span(&y, 1), std::span(&check, 1), kMostMissAtApex);
    }
    // Nothing proves that the map is injective around it. At a fold, what holds reaches to sixteen
    // tolerances of its ends: two that are nearer than twice that may be one, or none.
    constexpr double kMayBeOne = 32.0;
    if (!check.holds ||
      (!IsKnown(point, xi, true, SameWithin(check, 4.0)) &&
        IsKnown(point, xi, true, SameWithin(check, kMayBeOne))))
    {
      Undecided |= BitOf(point);
    }
    if (check.holds)
    {
      Add(point, { xi, MaxAbs(root - xi), true, check.IsOnFace(TheShape, xi) }, check);
    }
  }

  /// Whether every xi of the box is so near to a known root that no other could be told from it.
  [[nodiscard]] bool IsAtRoot(const EtaBox& box, int point) const
  {
    const Box3 hull = HullInXi(TheShape, box);
    return std::ranges::any_of(Found[static_cast<std::size_t>(point)],
      [&](const InverseRoot& root) {
        return std::max(MaxAbs(hull.lower - root.xi), MaxAbs(hull.upper - root.xi)) <= kSameRoot;
      });
  }

  /// Of which points the box can hold no root but a known one.
  Bits Settled(ElementTree::Node& node, Bits points)
  {
    const EtaBox& box = node.Frame().box;
    Bits settled = 0;
    if (node.IsPoint())
    {
      ForEachPoint(points, [&](int i) { settled |= IsAtRoot(box, i) ? BitOf(i) : 0; });
    }
    Bits reached = 0;
    for (const GroupRoots& roots : RootLanes)
    {
      reached |= Kernels.reached(box, TheShape, Reach, roots, points & ~settled & ~reached);
    }
    return reached != 0 && IsRegular(node) ? settled | reached : settled;
  }

  bool IsRegular(ElementTree::Node& node)
  {
    Work += Tree.RegularCost(node);
    return Tree.IsRegular(node);
  }

  /// Newton's iteration from the frame's guesses; of which points it found a root.
  Bits RunNewton(const NodeFrame& frame, Bits points);

  void Add(int point, const InverseRoot& root, const RootCheck& check)
  {
    if (!check.holds && root.inside)
    {
      return;
    }
    // Two runs of the iteration to one root differ by rounding.
    if (!IsKnown(point, root.xi, root.inside, SameWithin(check, 4.0)))
    {
      Keep(point, root, check);
    }
  }

  static Vec3 SameWithin(const RootCheck& check, double tolerances)
  {
    return tolerances * check.tolerance + Vec3(kSameRoot);
  }

  /// Whether a root of the point is within `distance` of xi.
  [[nodiscard]] bool IsKnown(int point, const Vec3& xi, bool inside, const Vec3& distance) const
  {
    return std::ranges::any_of(Found[static_cast<std::size_t>(point)],
      [&](const InverseRoot& known)
      {
        const Vec3 apart = glm::abs(known.xi - xi);
        return apart.x <= distance.x && apart.y <= distance.y && apart.z <= distance.z &&
          known.inside == inside;
      });
  }

  void Keep(int point, const InverseRoot& root, const RootCheck& check)
  {
    auto& found = Found[static_cast<std::size_t>(point)];
    const std::size_t slot = found.size();
    found.push_back(root);
    if (RootLanes.size() <= slot)
    {
      GroupRoots& none = RootLanes.emplace_back();
      std::fill_n(none.tolerance, kGroupPoints, kNan);
    }
    GroupRoots& lanes = RootLanes[slot];
    for (int d = 0; d < 3; ++d)
    {
      lanes.xi.x[d][point] = root.xi[d];
    }
    // Where the root really is, it must be in the reach; nobody knows where that is if its
    // Jacobian is singular, or the map does not take it to the point.
    const double error = MaxAbs(check.tolerance);
    lanes.tolerance[point] =
      error > 0.0 && check.holds ? kSameRoot - std::max(error - kSameRoot, 0.0) : kNan;
    if (root.inside && !All)
    {
      Done |= BitOf(point);
    }
  }

  ElementTree& Tree;
  const InverseProblem& Problem;
  Shape TheShape;
  const TreeKernels& Kernels;
  std::span<const SoughtPoint> Points;
  double Reach;
  bool All;
  std::int64_t MostWork;
  RootChecker Checker;
  GroupLanes Y;
  std::array<std::vector<InverseRoot>, kGroupPoints> Found; ///< of each point, inside or not
  std::vector<GroupRoots> RootLanes;                        ///< [n] the n-th of each
  Bits Known = 0;                                           ///< with a root from before
  Bits Done = 0;                                            ///< of which nothing more is wanted
  Bits Undecided = 0;
  int Boxes = 0;
  std::int64_t Work = 0;
};

Bits Search::RunNewton(const NodeFrame& frame, Bits points)
{
  std::array<std::array<double, kGroupPoints>, 12> lanes;
  std::array<int, kGroupPoints> which{};
  int count = 0;
  ForEachPoint(points,
    [&](int i)
    {
      const Vec3 guess = frame.Guess(YOf(i));
      for (int d = 0; d < 3; ++d)
      {
        lanes[static_cast<std::size_t>(d)][static_cast<std::size_t>(count)] =
          Points[static_cast<std::size_t>(i)].x[d];
        lanes[3 + static_cast<std::size_t>(d)][static_cast<std::size_t>(count)] = guess[d];
      }
      which[static_cast<std::size_t>(count++)] = i;
    });
  const auto padded = static_cast<std::size_t>(PaddedCount(count));
  for (auto k = static_cast<std::size_t>(count); k < padded; ++k)
  {
    for (std::size_t d = 0; d < 6; ++d)
    {
      lanes[d][k] = lanes[d][k - 1];
    }
  }
  const std::int64_t modes = Problem.space.Modes();
  Work +=
    (kNewtonCost + (modes > kManyModes ? kNewtonCostOfManyModes : kNewtonCostOfMode) * modes) *
    (PaddedCount(count) / kLanePadding);
  InverseProblem asked = Problem;
  asked.affine = false;
  asked.from = { lanes[3].data(), lanes[4].data(), lanes[5].data() };
  const InverseResult result{ { lanes[6].data(), lanes[7].data(), lanes[8].data() },
    lanes[9].data(), lanes[10].data(), lanes[11].data() };
  KernelsFor(Problem.space)
    .invert(asked, { { lanes[0].data(), lanes[1].data(), lanes[2].data() }, count }, result);
  Bits found = 0;
  std::array<Vec3, kGroupPoints> xi;
  std::array<Vec3, kGroupPoints> y;
  std::array<std::size_t, kGroupPoints> from{};
  std::size_t roots = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k)
  {
    const Vec3 root(result.xi[0][k], result.xi[1][k], result.xi[2][k]);
    const bool inside = result.status[k] == static_cast<double>(NewtonStatus::RootInside);
    // Beyond a pyramid's apex is another cone, whose roots say nothing of this one's.
    if (result.status[k] != static_cast<double>(NewtonStatus::NotConverged) &&
      (inside || TheShape != Shape::Pyramid || root.z <= 1.0))
    {
      found |= BitOf(which[k]);
      from[roots] = k;
      y[roots] = YOf(which[k]);
      xi[roots++] = root;
    }
  }
  if (roots == 0)
  {
    return 0;
  }
  std::array<RootCheck, kGroupPoints> checks;
  Checker.Run(std::span(xi).first(roots), std::span(y).first(roots), checks);
  for (std::size_t k = 0; k < roots; ++k)
  {
    const bool inside = result.status[from[k]] == static_cast<double>(NewtonStatus::RootInside);
    const bool onFace = inside && checks[k].IsOnFace(TheShape, xi[k]);
    Add(which[from[k]], { xi[k], result.residual[from[k]], inside, onFace }, checks[k]);
  }
  return found;
}
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
    search.Tell(answers);
    return;
  }
  // Alone, a point may be decided with the work that it is allowed.
  const std::size_t half = points.size() / 2;
  FindPreimages(tree, points.first(half), wanted, answers.first(half));
  FindPreimages(tree, points.subspan(half), wanted, answers.subspan(half));
}
} // namespace pixelexact
