// SPDX-License-Identifier: BSD-3-Clause
// What looks at pieces of iso-surfaces prove, against all roots along rays in 113 bits: none
// missed, none counted twice.
#include "CurvedCheck.h"
#include "RootReference.h"

#include "Core/Tree/EtaBox.h"
#include "Trace/Surfaces/Curved/LookKernels.h"
#include "Trace/Surfaces/Curved/PieceSolver.h"

#include <bit>
#include <map>

namespace pixelexact::testing
{
namespace
{
/// Distance of xi from a piece's ends within which roots may be found in either of two pieces.
constexpr double kAtEnd = 1e-9;
/// Slope of f along a ray below which two roots are equivalent to one.
constexpr double kGrazing = 1e-6;
/// Factors of b^2 and c^2 that a map adds to the first coordinate, which has a closed inverse.
using Bending = std::array<double, 2>;
constexpr Bending kBent{ 0.15, -0.1 };
constexpr Bending kStraight{ 0.0, 0.0 };

template <class T>
T FirstOf(const Point128<T>& x, const Bending& bend, double sign)
{
  return x[0] + T(sign) * (T(bend[0]) * x[1] * x[1] + T(bend[1]) * x[2] * x[2]);
}

/// A quadratic polynomial of xi.
struct XiQuadratic
{
  double constant = 0.0;
  std::array<double, 3> linear{};
  std::array<double, 6> square{}; ///< aa, bb, cc, ab, bc, ca

  template <class T>
  [[nodiscard]] T At(const Point128<T>& xi) const
  {
    T sum = T(constant);
    for (std::size_t d = 0; d < 3; ++d)
    {
      const std::size_t e = (d + 1) % 3;
      sum = sum + T(linear[d]) * xi[d] + T(square[d]) * xi[d] * xi[d] +
        T(square[3 + d]) * xi[d] * xi[e];
    }
    return sum;
  }
  [[nodiscard]] Vec3 Slope(const Vec3& xi) const
  {
    Vec3 slope;
    for (int d = 0; d < 3; ++d)
    {
      const int e = (d + 1) % 3;
      const int p = (d + 2) % 3;
      slope[d] = linear[static_cast<std::size_t>(d)] +
        2.0 * square[static_cast<std::size_t>(d)] * xi[d] +
        square[static_cast<std::size_t>(3 + d)] * xi[e] +
        square[static_cast<std::size_t>(3 + p)] * xi[p];
    }
    return slope;
  }
};

/// (n . (xi - at))^2 - less.
XiQuadratic SheetsAbout(const Vec3& at, const Vec3& n, double less)
{
  XiQuadratic f;
  const double c = glm::dot(n, at);
  f.constant = c * c - less;
  for (int d = 0; d < 3; ++d)
  {
    const auto k = static_cast<std::size_t>(d);
    f.linear[k] = -2.0 * c * n[d];
    f.square[k] = n[d] * n[d];
    f.square[3 + k] = 2.0 * n[d] * n[(d + 1) % 3];
  }
  return f;
}

XiQuadratic BallAbout(const Vec3& at, double radius)
{
  XiQuadratic f;
  f.constant = glm::dot(at, at) - radius * radius;
  for (int d = 0; d < 3; ++d)
  {
    f.linear[static_cast<std::size_t>(d)] = -2.0 * at[d];
    f.square[static_cast<std::size_t>(d)] = 1.0;
  }
  return f;
}

XiQuadratic AnyOf(Random& random, const Vec3& through, double bends)
{
  XiQuadratic f;
  for (std::size_t k = 0; k < 4; ++k)
  {
    f.square[k] = bends * random();
    f.linear[k % 3] = random();
  }
  f.constant = -f.At(Point128<double>{ through.x, through.y, through.z });
  return f;
}

/// A factor of a polynomial of degree 4 along a ray: one where the map is bent, two where it is
/// straight.
struct Product
{
  XiQuadratic one;
  XiQuadratic other;
  Bending bend;

  template <class T>
  [[nodiscard]] T At(const Point128<T>& xi) const
  {
    return one.At(xi) * other.At(xi);
  }
  [[nodiscard]] double At(const Vec3& xi) const { return At(Point128<double>{ xi.x, xi.y, xi.z }); }
  [[nodiscard]] Vec3 Slope(const Vec3& xi) const
  {
    const Point128<double> at{ xi.x, xi.y, xi.z };
    return one.At(at) * other.Slope(xi) + other.At(at) * one.Slope(xi);
  }
};

Product Bent(const XiQuadratic& f)
{
  XiQuadratic one;
  one.constant = 1.0;
  return { f, one, kBent };
}

struct Root
{
  double t = 0.0;
  Vec3 xi;
  double slope = 0.0; ///< of f along the ray
};

/// One element, its field, and its pieces.
class Made
{
public:
  Made(Shape shape, const Product& f)
    : F(f)
    , Values(1)
  {
    mesh_.Add(UniformSpace(shape, 2),
      [&f](const LongVec3& xi)
      {
        return LongVec3{ FirstOf(Point128<long double>{ xi[0], xi[1], xi[2] }, f.bend, 1.0), xi[1],
          xi[2] };
      });
    Values.Add(UniformSpace(shape, 4),
      [&f](const LongVec3& xi, long double* u) {
        u[0] = f.At(Point128<long double>{ xi[0], xi[1], xi[2] });
      });
    field_ = { "f", Values.View() };
    Equation = { mesh_.View(), &field_, 0, 0.0 };
    Tree = std::make_unique<PartTree>(Equation, Part);
    Frame.shape = shape;
    Frame.hasField = true;
    Frame.tolerance = 1e-14;
  }

  [[nodiscard]] Vec3 PointOf(const Vec3& xi) const
  {
    return { FirstOf(Point128<double>{ xi.x, xi.y, xi.z }, F.bend, 1.0), xi.y, xi.z };
  }

  [[nodiscard]] std::vector<Root> RootsAlong(const Ray& ray) const
  {
    Point128<Polynomial> x;
    for (int d = 0; d < 3; ++d)
    {
      x[static_cast<std::size_t>(d)].c[0] = ray.origin[d];
      x[static_cast<std::size_t>(d)].c[1] = ray.direction[d];
    }
    x[0] = FirstOf(x, F.bend, -1.0);
    const Polynomial f = F.At(x);
    std::vector<Root> roots;
    for (const Float128 t : RootsOf(f).roots)
    {
      roots.push_back({ static_cast<double>(t),
        { static_cast<double>(x[0].At(t)), static_cast<double>(x[1].At(t)),
          static_cast<double>(x[2].At(t)) },
        static_cast<double>(f.Derivative().At(t)) });
    }
    return roots;
  }

  /// Rays through the element, every other one nearly tangent to the surface.
  [[nodiscard]] std::vector<Ray> Rays(Random& random, int count) const
  {
    std::vector<Ray> rays;
    while (static_cast<int>(rays.size()) < count)
    {
      Vec3 xi = random.Inside(Frame.shape);
      Vec3 direction = RandomDirection(random);
      if (rays.size() % 2 == 0)
      {
        for (int step = 0; step < 30; ++step)
        {
          const Vec3 slope = F.Slope(xi);
          xi -= F.At(xi) / glm::dot(slope, slope) * slope;
        }
        // Converts the slope to x by the inverse of the map.
        Vec3 normal = F.Slope(xi);
        normal.y -= 2.0 * F.bend[0] * xi.y * normal.x;
        normal.z -= 2.0 * F.bend[1] * xi.z * normal.x;
        const double tilt = std::pow(10.0, random(-4.0, 0.0));
        direction =
          glm::normalize(glm::cross(normal, direction)) + tilt * random() * glm::normalize(normal);
        direction = glm::normalize(direction);
        if (!(glm::length(xi) < 2.0) || !(glm::length(direction) < 2.0))
        {
          continue;
        }
      }
      rays.push_back({ PointOf(xi) - 5.0 * direction, direction });
    }
    return rays;
  }

  /// The depth of a root inside a piece.
  [[nodiscard]] double DepthIn(const CurvedPiece& piece, const Vec3& xi) const
  {
    double depth = 2.0;
    for (int end = 0; end < 6; ++end)
    {
      depth = std::min(depth, DepthOf(Frame.shape, piece.box, end, xi));
    }
    return depth;
  }

  /// y, f and their slopes at points of open rays, as kernels make them.
  [[nodiscard]] std::vector<double> ValuesAt(OpenRays& open) const
  {
    const double scale = std::ldexp(1.0, -Tree->FieldModes().exponent);
    std::vector<double> values(16 * OpenRays::kStride, 0.0);
    for (std::size_t i = 0; i < static_cast<std::size_t>(open.count); ++i)
    {
      const auto row = [&](std::size_t n) -> double& { return values[n * OpenRays::kStride + i]; };
      Vec3 xi;
      for (int d = 0; d < 3; ++d)
      {
        xi[d] = open.Column(kOpenXiColumn + d)[i];
      }
      const Vec3 x = PointOf(xi);
      const Vec3 slope = F.Slope(xi);
      for (int d = 0; d < 3; ++d)
      {
        const auto k = static_cast<std::size_t>(d);
        row(k) = x[d];
        row(4 + 4 * k) = 1.0;
        row(13 + k) = scale * slope[d];
      }
      row(3) = scale * F.At(xi);
      row(5) = 2.0 * F.bend[0] * xi.y;
      row(6) = 2.0 * F.bend[1] * xi.z;
    }
    return values;
  }

  Product F;
  MeshBuilder mesh_;
  ExpansionBuilder Values;
  Field field_;
  CurvedEquation Equation;
  CurvedPart Part{ 0, -1 };
  std::unique_ptr<PartTree> Tree;
  ElementFrame Frame;
};

bool HasRay(const RaySet& rays, int ray)
{
  return (rays.bits[static_cast<std::size_t>(ray / 64)] >> (ray % 64) & 1U) != 0;
}

/// Calls look(piece, rays) for all flat pieces. It returns the unclear rays, for which the piece's
/// children are visited.
template <class Look>
void Descend(const Made& made, const RayBundle& bundle, const CurvedPiece& piece,
  const RaySet& rays, const Look& look)
{
  constexpr int kMaxDepth = 14;
  if (piece.IsEmpty())
  {
    return;
  }
  const RaySet near = GetPieceKernels().meetBox(bundle, piece.bounds, rays);
  const RaySet unclear = piece.flat && !near.IsEmpty() ? look(piece, near) : near;
  if (!unclear.IsEmpty() && piece.subdivisions < kMaxDepth)
  {
    const PieceChildren split = made.Tree->GetChildren(piece);
    const auto& children = *split.pieces;
    Descend(made, bundle, children[0], unclear, look);
    Descend(made, bundle, children[1], unclear, look);
  }
}

/// Some rays as bundles, one after the other: visit(bundle, rays, roots by ray).
template <class Visit>
void ForEachPieceBundle(const Made& made, const std::vector<Ray>& rays, const Visit& visit)
{
  std::vector<std::vector<Root>> roots;
  for (const Ray& ray : rays)
  {
    roots.push_back(made.RootsAlong(ray));
  }
  const RayBatch batch(rays, std::vector<double>(rays.size(), kNearest));
  const RayLanes lanes = batch.View();
  for (unsigned ways = GetBundleKernels().ways(lanes, 0, lanes.count); ways != 0; ways &= ways - 1)
  {
    const auto bundle = std::make_unique<RayBundle>();
    bundle->Begin(lanes, 0, lanes.count, std::countr_zero(ways), { Vec3(-1.2), Vec3(1.2) });
    visit(*bundle, roots);
  }
}

struct Ends
{
  std::array<int, 3> decided{}; ///< rays and pieces, by their number of roots
  int unclear = 0;
  int wrong = 0;
};

void ReportWrong(const std::string& what, int& wrong)
{
  if (++wrong <= 3)
  {
    ADD_FAILURE() << what;
  }
}

/// Looks, and solves for what they leave, in one piece.
RaySet Solve(const Made& made, const RayBundle& bundle, const CurvedPiece& piece,
  const RaySet& rays, const std::vector<std::vector<Root>>& roots, SolverWork& work, Ends& ends)
{
  work.hits.clear();
  work.unclear.clear();
  PieceSolver solver(made.Equation, made.Part, *made.Tree, bundle, work);
  RaySet unclear = solver.Look(piece, rays);
  solver.Solve();
  for (const PieceRay& one : work.unclear)
  {
    unclear.Add(one.ray);
  }
  std::map<int, std::vector<const CurvedHit*>> hits;
  for (const CurvedHit& hit : work.hits)
  {
    hits[hit.ray].push_back(&hit);
  }
  rays.ForEach(
    [&](int ray)
    {
      std::size_t taken = 0;
      std::size_t inside = 0;
      for (const Root& root : roots[static_cast<std::size_t>(ray)])
      {
        const double steep = std::fabs(root.slope);
        const double depth = made.DepthIn(piece, root.xi);
        std::size_t found = 0;
        for (const CurvedHit* hit : hits[ray])
        {
          found += std::fabs(hit->t - root.t) <= 1e-12 + 1e-14 / std::max(steep, 1e-7) ? 1 : 0;
        }
        taken += found;
        inside += depth > kAtEnd ? 1 : 0;
        const bool isGrazing = steep < kGrazing;
        if (!isGrazing &&
          (found > 1 || (found == 1 && depth < -kAtEnd) ||
            (found == 0 && depth > kAtEnd && !HasRay(unclear, ray))))
        {
          ReportWrong(std::to_string(found) + " hits of a root at depth " + std::to_string(depth) +
              ", slope " + std::to_string(root.slope),
            ends.wrong);
        }
      }
      if (taken < hits[ray].size())
      {
        ReportWrong("invented", ends.wrong);
      }
      if (HasRay(unclear, ray))
      {
        ++ends.unclear;
      }
      else
      {
        ++ends.decided[std::min<std::size_t>(inside, 2)];
      }
    });
  return unclear;
}

struct Looks
{
  int near = 0; ///< rays that the first look left
  int open = 0; ///< of these, along themselves
  int missed = 0;
  int started = 0;
  int twice = 0; ///< of these for two roots
  int stayed = 0;
  int unclear = 0;
  int wrong = 0;
};

/// Checks the state of rays after each look: for each ray that is not unclear, the roots in the
/// piece are at most the pairs and open places, and where there are only places, these contain
/// them.
void CheckLook(const Made& made, const CurvedPiece& piece,
  const std::vector<std::vector<Root>>& roots, const RaySet& asked, const RaySet& unclear,
  SolverWork& work, std::map<int, int>& started, Looks& looks)
{
  OpenRays& open = work.closer;
  const double* const of = work.pairs.Column(kRayColumn);
  asked.ForEach(
    [&](int ray)
    {
      const auto pairs = static_cast<int>(std::count(of, of + work.pairs.count, ray));
      started[ray] += pairs;
      looks.twice += pairs > 1 ? 1 : 0;
      int inside = 0;
      int held = 0;
      int places = 0;
      for (int k = 0; k < open.count; ++k)
      {
        places += static_cast<int>(open.Column(kOpenRayColumn)[k]) == ray ? 1 : 0;
      }
      for (const Root& root : roots[static_cast<std::size_t>(ray)])
      {
        if (made.DepthIn(piece, root.xi) <= kAtEnd || std::fabs(root.slope) < kGrazing)
        {
          continue;
        }
        ++inside;
        bool isHeld = false;
        for (int k = 0; k < open.count; ++k)
        {
          bool isHere = static_cast<int>(open.Column(kOpenRayColumn)[k]) == ray;
          for (int d = 0; d < 3; ++d)
          {
            const double off = root.xi[d] - piece.centre[d];
            isHere = isHere && off >= open.Column(kOpenLowerColumn + d)[k] - 1e-12 &&
              off <= open.Column(kOpenUpperColumn + d)[k] + 1e-12;
          }
          isHeld = isHeld || isHere;
        }
        held += isHeld ? 1 : 0;
      }
      looks.unclear += HasRay(unclear, ray) ? 1 : 0;
      looks.stayed += places > 0 ? 1 : 0;
      looks.started += pairs > 0 ? 1 : 0;
      if (HasRay(unclear, ray))
      {
        return;
      }
      looks.missed += started[ray] == 0 && places == 0 ? 1 : 0;
      if (inside > started[ray] + std::min(held, places))
      {
        ReportWrong(std::to_string(inside) + " roots, " + std::to_string(started[ray]) +
            " looked for, " + std::to_string(held) + " in " + std::to_string(places) + " places",
          looks.wrong);
      }
    });
}

RaySet RaysOf(OpenRays& open)
{
  RaySet rays;
  for (int k = 0; k < open.count; ++k)
  {
    rays.Add(static_cast<int>(open.Column(kOpenRayColumn)[k]));
  }
  return rays;
}

/// Looks at one piece that go on from the first one.
RaySet LookCloser(const Made& made, const RayBundle& bundle, const CurvedPiece& piece,
  const RaySet& rays, const std::vector<std::vector<Root>>& roots, SolverWork& work, Looks& looks)
{
  work.pairs.Clear();
  RaySet all = GetLookKernels().look(bundle, made.Frame, piece, rays, work.near);
  const RaySet near = RaysOf(work.near);
  looks.near += near.Count();
  std::map<int, int> started;
  RaySet unclear =
    GetAlongRayKernels().look(bundle, made.Frame, piece, work.near, work.closer, work.pairs);
  all.Add(unclear);
  CheckLook(made, piece, roots, near, unclear, work, started, looks);
  RaySet asked = RaysOf(work.closer);
  looks.open += asked.Count();
  for (int round = 0; work.closer.count > 0 && round < 3; ++round)
  {
    const std::vector<double> values = made.ValuesAt(work.closer);
    work.pairs.Clear();
    unclear = GetCloserLookKernels().look(
      bundle, made.Frame, piece, values.data(), OpenRays::kStride, work.closer, work.pairs);
    all.Add(unclear);
    CheckLook(made, piece, roots, asked, unclear, work, started, looks);
    asked = RaysOf(work.closer);
  }
  return all;
}

/// visit(made) for fields with none, one, two and nearly double roots along rays.
template <class Visit>
void ForEachField(Shape shape, Random& random, const Visit& visit)
{
  for (int k = 0; k < 4; ++k)
  {
    visit(Made(shape, Bent(AnyOf(random, random.Inside(shape), 0.1 * k))));
    const XiQuadratic one = AnyOf(random, random.Inside(shape), 0.2);
    visit(Made(shape, { one, AnyOf(random, random.Inside(shape), 0.2), kStraight }));
  }
  const Vec3 at = random.Inside(shape);
  visit(Made(shape, Bent(BallAbout(at, 0.4))));
  visit(Made(shape, Bent(BallAbout(at, 0.02))));
  for (const double apart : { 0.4, 1e-1, 1e-2, 1e-3 })
  {
    visit(Made(shape, Bent(SheetsAbout(at, RandomDirection(random), apart * apart))));
  }
}
} // namespace

TEST(PieceQueries, RootsInAPieceAreFoundOnce)
{
  SolverWork work;
  for (const Shape shape : kShapes)
  {
    Random random(301);
    Ends ends;
    ForEachField(shape, random,
      [&](const Made& made)
      {
        ForEachPieceBundle(made, made.Rays(random, 128),
          [&](const RayBundle& bundle, const std::vector<std::vector<Root>>& roots)
          {
            for (const auto& root : made.Tree->Roots())
            {
              Descend(made, bundle, *root, RaySet::First(bundle.Count()),
                [&](const CurvedPiece& piece, const RaySet& rays)
                { return Solve(made, bundle, piece, rays, roots, work, ends); });
            }
          });
      });
    std::cout << "[ measured ] " << Name(shape) << ": rays without a root in a piece "
              << ends.decided[0] << ", with one " << ends.decided[1] << ", with two "
              << ends.decided[2] << ", unclear " << ends.unclear << "; " << ends.wrong
              << " wrong\n";
    EXPECT_EQ(ends.wrong, 0) << Name(shape);
    EXPECT_GT(ends.decided[0], 1000) << Name(shape);
    EXPECT_GT(ends.decided[1], 200) << Name(shape);
  }
}

TEST(PieceQueries, CloserLooksLoseNoRoot)
{
  SolverWork work;
  for (const Shape shape : kShapes)
  {
    Random random(302);
    Looks looks;
    ForEachField(shape, random,
      [&](const Made& made)
      {
        ForEachPieceBundle(made, made.Rays(random, 128),
          [&](const RayBundle& bundle, const std::vector<std::vector<Root>>& roots)
          {
            for (const auto& root : made.Tree->Roots())
            {
              Descend(made, bundle, *root, RaySet::First(bundle.Count()),
                [&](const CurvedPiece& piece, const RaySet& rays)
                { return LookCloser(made, bundle, piece, rays, roots, work, looks); });
            }
          });
      });
    std::cout << "[ measured ] " << Name(shape) << ": " << looks.near << " rays near, "
              << looks.open << " open, then " << looks.missed << " missed, " << looks.started
              << " started, " << looks.twice << " of them twice, " << looks.stayed
              << " times open, " << looks.unclear << " unclear; " << looks.wrong << " wrong\n";
    EXPECT_EQ(looks.wrong, 0) << Name(shape);
    EXPECT_GT(looks.missed, 100) << Name(shape);
    EXPECT_GT(looks.started, 10) << Name(shape);
  }
}
} // namespace pixelexact::testing
