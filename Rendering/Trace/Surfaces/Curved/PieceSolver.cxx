// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/PieceSolver.h"

#include "Core/Element/Kernels.h"
#include "Core/Math/Rounding.h"
#include "Trace/Room.h"
#include "Trace/Scene.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Beyond it a piece is halved: a clamped step then lets a residual fall to 3/4 at least.
constexpr double kMostKappa = 0.35;
constexpr int kMostRounds = 40;
/// After a step as small as this, Newton's iteration has arrived up to rounding.
constexpr double kArrived = 1e-8;
/// Of the map, in the element's units, and of f, in those of the field: what rounding leaves.
constexpr double kRounding = 1e-14;

/// The inverse of three rows; not finite where there is none.
std::array<double, 9> InverseOf(const double (&m)[3][3])
{
  const auto minor = [&](int r0, int c0, int r1, int c1)
  { return m[r0][c0] * m[r1][c1] - m[r0][c1] * m[r1][c0]; };
  std::array<double, 9> inverse{ minor(1, 1, 2, 2), -minor(0, 1, 2, 2), minor(0, 1, 1, 2),
    -minor(1, 0, 2, 2), minor(0, 0, 2, 2), -minor(0, 0, 1, 2), minor(1, 0, 2, 1),
    -minor(0, 0, 2, 1), minor(0, 0, 1, 1) };
  const double determinant = m[0][0] * inverse[0] + m[0][1] * inverse[3] + m[0][2] * inverse[6];
  for (double& v : inverse)
  {
    v /= determinant;
  }
  return inverse;
}

Vec3 Product(const std::array<double, 9>& m, const double (&v)[3])
{
  return { m[0] * v[0] + m[1] * v[1] + m[2] * v[2], m[3] * v[0] + m[4] * v[1] + m[5] * v[2],
    m[6] * v[0] + m[7] * v[1] + m[8] * v[2] };
}

double Largest(const Vec3& v, const Vec3& norm)
{
  const Vec3 weighted = glm::abs(v) * norm;
  return std::max({ weighted.x, weighted.y, weighted.z });
}
} // namespace

const Vec3& NormOf(Shape shape)
{
  // x = 1.618...: 1/x + 1/x^2 = 1.
  static const Vec3 kEqual(1.0);
  static const Vec3 kGolden(1.0, 1.6180339887498949, 2.6180339887498949);
  return shape == Shape::Tetrahedron ? kGolden : kEqual;
}

Vec3 ClampTo(Shape shape, const EtaBox& box, const Vec3& xi)
{
  Vec3 x;
  x.z = std::clamp(xi.z, box.lower.z, box.upper.z);
  const double narrow = 0.5 * (1.0 - x.z);
  const auto clampTo = [&](int d, double extent)
  {
    const double lower = (1.0 + box.lower[d]) * extent - 1.0;
    const double upper = (1.0 + box.upper[d]) * extent - 1.0;
    return std::max(std::min(xi[d], upper), lower);
  };
  x.y = clampTo(1, shape == Shape::Tetrahedron || shape == Shape::Pyramid ? narrow : 1.0);
  x.x = clampTo(0,
    shape == Shape::Hexahedron      ? 1.0
      : shape == Shape::Tetrahedron ? 0.5 * (-x.y - x.z)
                                    : narrow);
  return x;
}

PieceSolver::PieceSolver(const CurvedEquation& equation, const CurvedPart& part,
  const PartTree& tree, const RayBundle& bundle)
  : Equation(equation)
  , Part(part)
  , Tree(tree)
  , Bundle(bundle)
  , TheShape(equation.mesh.ShapeOf(part.element))
{
  const auto e = static_cast<std::size_t>(part.element);
  Centre = Vec3(
    equation.mesh.centre[3 * e], equation.mesh.centre[3 * e + 1], equation.mesh.centre[3 * e + 2]);
  Size = equation.mesh.size[e];
  InverseSize = 1.0 / Size;
  Uncertainty = equation.mesh.uncertainty[e] * InverseSize;
  FieldScale = std::ldexp(1.0, -tree.Exponent());
}

std::array<double, 2> PieceSolver::Across(int ray) const
{
  const auto i = static_cast<std::size_t>(ray);
  const double along = (Bundle.z0 - Centre[Bundle.axes[2]]) * InverseSize;
  std::array<double, 2> q;
  for (std::size_t a = 0; a < 2; ++a)
  {
    q[a] = (Bundle.place[a][i] - Centre[Bundle.axes[a]]) * InverseSize - Bundle.slope[a][i] * along;
  }
  return q;
}

PieceSolver::Outlook PieceSolver::Look(const CurvedPiece& piece, int ray)
{
  const auto i = static_cast<std::size_t>(ray);
  const auto k = static_cast<std::size_t>(Bundle.axes[2]);
  const auto q = Across(ray);
  double m[3][3];
  double radius[3][3];
  double g[3];
  double error[3];
  for (std::size_t a = 0; a < 2; ++a)
  {
    const auto c = static_cast<std::size_t>(Bundle.axes[a]);
    const double s = Bundle.slope[a][i];
    for (std::size_t d = 0; d < 3; ++d)
    {
      m[a][d] = piece.slope[c][d] - s * piece.slope[k][d];
      radius[a][d] = piece.radius[c][d] + std::fabs(s) * piece.radius[k][d];
    }
    g[a] = piece.value[c] - s * piece.value[k] - q[a];
    error[a] =
      piece.error[c] + std::fabs(s) * piece.error[k] + 8.0 * kUnitRoundoff * std::fabs(q[a]);
  }
  for (std::size_t d = 0; d < 3; ++d)
  {
    m[2][d] = piece.slope[3][d];
    radius[2][d] = piece.radius[3][d];
  }
  g[2] = piece.value[3];
  error[2] = piece.error[3];
  const auto inverse = InverseOf(m);
  const Vec3 first = Product(inverse, g);
  const Vec3& norm = NormOf(TheShape);
  double kappa = 0.0;
  bool misses = false;
  bool decides = true;
  for (int r = 0; r < 3; ++r)
  {
    const double* row = &inverse[static_cast<std::size_t>(3 * r)];
    double off = 0.0;
    double sum = 0.0;
    for (std::size_t d = 0; d < 3; ++d)
    {
      const double change = std::fabs(row[0]) * radius[0][d] + std::fabs(row[1]) * radius[1][d] +
        std::fabs(row[2]) * radius[2][d];
      const auto at = static_cast<int>(d);
      off += change * piece.half[at];
      sum += change / norm[at];
    }
    for (std::size_t d = 0; d < 3; ++d)
    {
      off += std::fabs(row[d]) * error[d];
    }
    kappa = std::max(kappa, sum * norm[r]);
    // A NaN does not.
    decides = decides && sum * norm[r] <= kMostKappa;
    misses = misses || std::fabs(first[r]) > (piece.half[r] + off) * (1.0 + 1e-9) + 1e-14;
  }
  // A root in the piece lies in centre - first +- off, however large that is.
  if (misses)
  {
    return Outlook::Misses;
  }
  if (!decides)
  {
    return Outlook::Unclear;
  }
  Pair pair;
  pair.of = { &piece, ray };
  pair.inverse = inverse;
  pair.kappa = kappa;
  pair.xi = ClampTo(TheShape, piece.box, piece.centre - first);
  Pairs.push_back(pair);
  return Outlook::May;
}

void PieceSolver::Evaluate(std::span<const Vec3> xi)
{
  const auto count = static_cast<int>(xi.size());
  Stride = static_cast<std::size_t>(PaddedCount(count));
  const auto lanes = Room(Lanes, (3 + 4 + 12) * Stride);
  const auto lane = [&](std::size_t k) { return lanes.data() + k * Stride; };
  for (std::size_t i = 0; i < Stride; ++i)
  {
    const Vec3& x = xi[std::min(i, xi.size() - 1)];
    for (int d = 0; d < 3; ++d)
    {
      lane(static_cast<std::size_t>(d))[i] = x[d];
    }
  }
  const Space& space = Equation.mesh.map.SpaceOf(Part.element);
  double* out[3] = { lane(3), lane(4), lane(5) };
  double* gradient[9];
  for (std::size_t k = 0; k < 9; ++k)
  {
    gradient[k] = lane(7 + k);
  }
  KernelsFor(space).gradient(space, Equation.mesh.map.Coefficients(Part.element), 3,
    { { lane(0), lane(1), lane(2) }, count }, out, gradient);
  if (Equation.field == nullptr)
  {
    std::fill_n(lane(6), Stride, 0.0);
    return;
  }
  const double* const at[3] = { lane(0), lane(1), lane(2) };
  EvaluateField(at, count);
}

void PieceSolver::EvaluateField(const double* const xi[3], int count)
{
  const Expansion& values = Equation.field->values;
  const Space& space = values.SpaceOf(Part.element);
  const bool squares = Equation.component == kMagnitude;
  const int first = squares ? 0 : Equation.component;
  const int components = squares ? values.components : 1;
  double* value = Lanes.data() + 6 * Stride;
  double* const slope[3] = { Lanes.data() + 16 * Stride, Lanes.data() + 17 * Stride,
    Lanes.data() + 18 * Stride };
  const double* coefficients = values.Coefficients(Part.element) +
    static_cast<std::size_t>(first) * static_cast<std::size_t>(space.Modes());
  const double sought = Tree.Value();
  if (!squares)
  {
    double* const out[1] = { value };
    KernelsFor(space).gradient(
      space, coefficients, 1, { { xi[0], xi[1], xi[2] }, count }, out, slope);
    for (std::size_t i = 0; i < Stride; ++i)
    {
      value[i] = value[i] * FieldScale - sought;
      for (double* const by : slope)
      {
        by[i] *= FieldScale;
      }
    }
    return;
  }
  std::vector<double> one(4 * Stride);
  double* const out[1] = { one.data() };
  double* const by[3] = { &one[Stride], &one[2 * Stride], &one[3 * Stride] };
  std::fill_n(value, Stride, -sought * sought);
  for (double* const sum : slope)
  {
    std::fill_n(sum, Stride, 0.0);
  }
  for (int c = 0; c < components; ++c)
  {
    KernelsFor(space).gradient(space,
      coefficients + static_cast<std::size_t>(c) * static_cast<std::size_t>(space.Modes()), 1,
      { { xi[0], xi[1], xi[2] }, count }, out, by);
    for (std::size_t i = 0; i < Stride; ++i)
    {
      const double u = one[i] * FieldScale;
      value[i] += u * u;
      for (std::size_t d = 0; d < 3; ++d)
      {
        slope[d][i] += 2.0 * u * by[d][i] * FieldScale;
      }
    }
  }
}

PieceSolver::Values PieceSolver::At(std::size_t i) const
{
  Values at{};
  for (std::size_t c = 0; c < 4; ++c)
  {
    at.value[c] = Lanes[(3 + c) * Stride + i];
    for (std::size_t d = 0; d < 3; ++d)
    {
      at.slope[c][d] = Lanes[(7 + 3 * c + d) * Stride + i];
    }
  }
  return at;
}

Vec3 PieceSolver::World(const Values& at, const Vec3& step) const
{
  Vec3 x;
  for (int c = 0; c < 3; ++c)
  {
    const double* slope = at.slope[c];
    x[c] =
      Centre[c] + Size * (at.value[c] - slope[0] * step.x - slope[1] * step.y - slope[2] * step.z);
  }
  return x;
}

PieceSolver::Residual PieceSolver::ResidualOf(
  const CurvedPiece& piece, int ray, const Values& at) const
{
  const auto i = static_cast<std::size_t>(ray);
  const auto k = static_cast<std::size_t>(Bundle.axes[2]);
  const auto q = Across(ray);
  Residual result{};
  for (std::size_t a = 0; a < 2; ++a)
  {
    const auto c = static_cast<std::size_t>(Bundle.axes[a]);
    const double s = Bundle.slope[a][i];
    for (std::size_t d = 0; d < 3; ++d)
    {
      result.slope[a][d] = at.slope[c][d] - s * at.slope[k][d];
    }
    result.g[a] = at.value[c] - s * at.value[k] - q[a];
  }
  for (std::size_t d = 0; d < 3; ++d)
  {
    result.slope[2][d] = Equation.field != nullptr ? at.slope[3][d] : piece.slope[3][d];
  }
  result.g[2] = at.value[3];
  return result;
}

CurvedHit PieceSolver::HitAt(const CurvedPiece& piece, int ray, Vec3 xi, int steps)
{
  for (int n = 0; n < steps; ++n)
  {
    Evaluate(std::span(&xi, 1));
    const Residual now = ResidualOf(piece, ray, At(0));
    const Vec3 next = ClampTo(TheShape, piece.box, xi - Product(InverseOf(now.slope), now.g));
    // A singular matrix leaves it where it is.
    xi = Largest(next, Vec3(1.0)) < kNoHit ? next : xi;
  }
  Evaluate(std::span(&xi, 1));
  const Vec3 position = World(At(0), Vec3(0.0));
  return { ray, Bundle.TimeAt(ray, position), position, xi };
}

PieceSolver::Next PieceSolver::Step(Pair& pair, const Values& at, Vec3& position) const
{
  const CurvedPiece& piece = *pair.of.piece;
  const Vec3& norm = NormOf(TheShape);
  const Residual now = ResidualOf(piece, pair.of.ray, at);
  const auto& g = now.g;
  const Vec3 step = Product(InverseOf(now.slope), now.g);
  const Vec3 next = pair.xi - step;
  const Vec3 inside = ClampTo(TheShape, piece.box, next);
  const double beyond = Largest(next - inside, norm);
  if (Largest(step, norm) <= kArrived && beyond <= 1e-15)
  {
    position = World(at, step);
    pair.xi = inside;
    return Next::Hit;
  }
  const double tolerance = 4.0 * Uncertainty + kRounding;
  if (std::fabs(g[0]) <= tolerance && std::fabs(g[1]) <= tolerance && std::fabs(g[2]) <= tolerance)
  {
    position = World(at, Vec3(0.0));
    return Next::Hit;
  }
  const Vec3 frozen = Product(pair.inverse, g);
  const double residual = Largest(frozen, norm);
  // After a step with the piece's matrix, every root of the piece is nearer than kappa times what
  // it was before.
  const double falls = (1.0 + pair.kappa) * pair.kappa / (1.0 - pair.kappa);
  if (pair.last > 0.0 && residual > falls * pair.last * (1.0 + 1e-6) + 1e-15)
  {
    return Next::Miss;
  }
  if (!(residual < kNoHit) || ++pair.rounds > kMostRounds)
  {
    return Next::Unclear;
  }
  if (beyond == 0.0 && pair.rounds < kMostRounds / 2)
  {
    pair.last = 0.0;
    pair.xi = inside;
  }
  else
  {
    pair.last = residual;
    pair.xi = ClampTo(TheShape, piece.box, pair.xi - frozen);
  }
  return Next::Again;
}

void PieceSolver::Solve(std::vector<CurvedHit>& hits, std::vector<PieceRay>& unclear)
{
  std::vector<Vec3> xi;
  while (!Pairs.empty())
  {
    xi.clear();
    for (const Pair& pair : Pairs)
    {
      xi.push_back(pair.xi);
    }
    Evaluate(xi);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < Pairs.size(); ++i)
    {
      Pair& pair = Pairs[i];
      Vec3 position;
      const Next next = Step(pair, At(i), position);
      if (next == Next::Again)
      {
        Pairs[kept++] = pair;
      }
      else if (next == Next::Unclear)
      {
        unclear.push_back(pair.of);
      }
      else if (next == Next::Hit)
      {
        hits.push_back({ pair.of.ray, Bundle.TimeAt(pair.of.ray, position), position, pair.xi, 0 });
      }
    }
    Pairs.resize(kept);
  }
}
} // namespace pixelexact
