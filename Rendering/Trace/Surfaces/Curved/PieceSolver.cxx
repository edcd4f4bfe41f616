// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/PieceSolver.h"

#include "Core/Element/Kernels.h"
#include "Core/Math/Rounding.h"
#include "Trace/Scene.h"
#include "Trace/Surfaces/Curved/LookKernels.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Rounding of the map, in the element's units, and of f, in those of the field.
constexpr double kFrameRounding = 1e-14;
/// Count of closer looks at a piece before it is subdivided.
constexpr int kCloser = 3;

/// Pads the last pack with the last point.
void Pad(double* const xi[3], int count)
{
  for (int d = 0; d < 3; ++d)
  {
    std::fill_n(xi[d] + count, kLanePadding, xi[d][count - 1]);
  }
}
} // namespace

PieceSolver::PieceSolver(const CurvedEquation& equation, const CurvedPart& part,
  const PartTree& tree, const RayBundle& bundle, SolverWork& work)
  : Equation(equation)
  , Part(part)
  , Tree(tree)
  , Bundle(bundle)
  , Work(work)
{
  const auto e = static_cast<std::size_t>(part.element);
  Frame.shape = equation.mesh.ShapeOf(part.element);
  Frame.hasField = equation.field != nullptr;
  if (!Frame.hasField)
  {
    OnFace.emplace(equation.mesh, part, tree.OnFace());
    Frame.chart = OnFace->Chart();
  }
  Frame.centre = Vec3(
    equation.mesh.centre[3 * e], equation.mesh.centre[3 * e + 1], equation.mesh.centre[3 * e + 2]);
  Frame.size = equation.mesh.size[e];
  Frame.inverseSize = 1.0 / Frame.size;
  Frame.rounding = kFrameRounding;
  Frame.tolerance = 4.0 * equation.mesh.uncertainty[e] * Frame.inverseSize + kFrameRounding;
  Work.pairs.Clear();
}

std::array<double, 2> PieceSolver::Across(int ray) const
{
  const auto i = static_cast<std::size_t>(ray);
  const double along = (Bundle.z0 - Frame.centre[Bundle.axes[2]]) * Frame.inverseSize;
  std::array<double, 2> q;
  for (std::size_t a = 0; a < 2; ++a)
  {
    q[a] = (Bundle.place[a][i] - Frame.centre[Bundle.axes[a]]) * Frame.inverseSize -
      Bundle.slope[a][i] * along;
  }
  return q;
}

RaySet PieceSolver::Look(const CurvedPiece& piece, const RaySet& rays)
{
  if (Work.pairs.count + 2 * RayBundle::kMax > PiecePairs::kMax)
  {
    Solve();
  }
  if (!Frame.hasField)
  {
    return GetFacePieceKernels().look(Bundle, Frame, piece, rays, Work.pairs);
  }
  OpenRays& open = Work.closer;
  RaySet unclear = GetLookKernels().look(Bundle, Frame, piece, rays, Work.near);
  unclear.Add(GetAlongRayKernels().look(Bundle, Frame, piece, Work.near, open, Work.pairs));
  for (int round = 0; open.count > 0 && round < kCloser; ++round)
  {
    double* const xi[3] = { open.Column(kOpenXiColumn), open.Column(kOpenXiColumn + 1),
      open.Column(kOpenXiColumn + 2) };
    Evaluate(xi, open.count);
    unclear.Add(GetCloserLookKernels().look(
      Bundle, Frame, piece, Work.values.data(), PiecePairs::kStride, open, Work.pairs));
  }
  for (int i = 0; i < open.count; ++i)
  {
    unclear.Add(static_cast<int>(open.Column(kOpenRayColumn)[i]));
  }
  return unclear;
}

void PieceSolver::Evaluate(double* const xi[3], int count)
{
  Pad(xi, count);
  const auto row = [this](std::size_t k) { return &Work.values[k * PiecePairs::kStride]; };
  double* const value[3] = { row(0), row(1), row(2) };
  double* slope[12];
  for (std::size_t k = 0; k < 12; ++k)
  {
    slope[k] = row(4 + k);
  }
  const LanePoints points{ { xi[0], xi[1], xi[2] }, count };
  const Space& space = Equation.mesh.map.SpaceOf(Part.element);
  KernelsFor(space).gradient(
    space, Equation.mesh.map.Coefficients(Part.element), 3, points, value, slope);
  EvaluateField(points, row(3), slope + 9);
}

void PieceSolver::EvaluateOnFace(double* const xi[3], int count)
{
  Pad(xi, count);
  const auto row = [this](std::size_t k) { return &Work.values[k * PiecePairs::kStride]; };
  double* const value[3] = { row(0), row(1), row(2) };
  double* slope[7];
  for (std::size_t k = 0; k < 7; ++k)
  {
    slope[k] = row(4 + k);
  }
  OnFace->Evaluate({ { xi[0], xi[1], xi[2] }, count }, value, slope);
}

void PieceSolver::Step(double* const position[3], double* result)
{
  PiecePairs& pairs = Work.pairs;
  double* const xi[3] = { pairs.Column(kXiColumn), pairs.Column(kXiColumn + 1),
    pairs.Column(kXiColumn + 2) };
  if (Frame.hasField)
  {
    Evaluate(xi, pairs.count);
    GetPieceKernels().step(
      Bundle, Frame, Work.values.data(), PiecePairs::kStride, pairs, position, result);
  }
  else
  {
    EvaluateOnFace(xi, pairs.count);
    GetFacePieceKernels().step(
      Bundle, Frame, Work.values.data(), PiecePairs::kStride, pairs, position, result);
  }
}

void PieceSolver::EvaluateField(const LanePoints& xi, double* const out, double* const slope[3])
{
  const ScaledModes& modes = Tree.FieldModes();
  const Space& space = modes.space;
  const auto count = static_cast<std::size_t>(PaddedCount(xi.count));
  const double sought = Tree.Value();
  if (Equation.component != kMagnitude)
  {
    KernelsFor(space).gradient(space, modes.values.data(), 1, xi, &out, slope);
    std::for_each_n(out, count, [sought](double& value) { value -= sought; });
    return;
  }
  std::vector<double> one(4 * count);
  double* const u = one.data();
  double* const by[3] = { u + count, u + 2 * count, u + 3 * count };
  std::fill_n(out, count, -sought * sought);
  for (int d = 0; d < 3; ++d)
  {
    std::fill_n(slope[d], count, 0.0);
  }
  for (std::size_t first = 0; first < modes.values.size(); first += modes.width)
  {
    KernelsFor(space).gradient(space, modes.values.data() + first, 1, xi, &u, by);
    for (std::size_t i = 0; i < count; ++i)
    {
      out[i] += u[i] * u[i];
      for (std::size_t d = 0; d < 3; ++d)
      {
        slope[d][i] += 2.0 * u[i] * by[d][i];
      }
    }
  }
}

void PieceSolver::Solve()
{
  PiecePairs& pairs = Work.pairs;
  double* const position[3] = { Work.ends[0].data(), Work.ends[1].data(), Work.ends[2].data() };
  double* const result = Work.ends[3].data();
  double* isOpen = pairs.Column(kOpenColumn);
  int left = static_cast<int>(std::count(isOpen, isOpen + pairs.count, 1.0));
  while (left > 0)
  {
    Step(position, result);
    for (std::size_t i = 0; i < static_cast<std::size_t>(pairs.count); ++i)
    {
      const auto end = static_cast<PairResult>(static_cast<int>(result[i]));
      if (isOpen[i] == 0.0 || end == PairResult::Again)
      {
        continue;
      }
      isOpen[i] = 0.0;
      --left;
      const auto ray = static_cast<int>(pairs.Column(kRayColumn)[i]);
      if (end == PairResult::Hit)
      {
        // Written in place: a hit that is assembled elsewhere would be read back before its stores
        // complete.
        CurvedHit& hit = Work.hits.emplace_back();
        hit.ray = ray;
        for (int d = 0; d < 3; ++d)
        {
          hit.position[d] = position[d][i];
          hit.xi[d] = pairs.Column(kXiColumn + d)[i];
        }
        hit.t = Bundle.TimeAt(ray, hit.position);
      }
      else if (end == PairResult::Unclear)
      {
        const auto piece = static_cast<std::size_t>(pairs.Column(kPieceColumn)[i]);
        Work.unclear.push_back({ pairs.pieces[piece], ray });
      }
    }
    pairs.DropEnded();
  }
  pairs.Clear();
}

CurvedHit PieceSolver::HitAt(const CurvedPiece& piece, int ray, const Vec3& xi, int steps)
{
  // A pair without clamping by a piece's matrix; the other columns are not used.
  PiecePairs& pairs = Work.pairs;
  double* const position[3] = { Work.ends[0].data(), Work.ends[1].data(), Work.ends[2].data() };
  pairs.Clear();
  for (int column = 0; column < kPairColumns; ++column)
  {
    pairs.Column(column)[0] = 0.0;
  }
  const auto q = Across(ray);
  const int unknowns = Frame.hasField ? 3 : 2;
  for (int n = 0; n < unknowns; ++n)
  {
    const int d = Frame.hasField ? n : Frame.chart.free[static_cast<std::size_t>(n)];
    pairs.Column(kLowerColumn + n)[0] = piece.box.lower[d];
    pairs.Column(kUpperColumn + n)[0] = piece.box.upper[d];
  }
  for (int a = 0; a < 2; ++a)
  {
    const auto at = static_cast<std::size_t>(a);
    pairs.Column(kSlopeColumn + a)[0] = Bundle.slope[at][static_cast<std::size_t>(ray)];
    pairs.Column(kPlaceColumn + a)[0] = q[at];
  }
  CurvedHit hit{ ray, kNoHit, Vec3(0.0), xi };
  for (int n = 0; n <= steps; ++n)
  {
    pairs.count = 1;
    for (int d = 0; d < 3; ++d)
    {
      pairs.Column(kXiColumn + d)[0] = hit.xi[d];
    }
    Step(position, Work.ends[3].data());
    for (int c = 0; c < 3; ++c)
    {
      hit.position[c] = Frame.centre[c] +
        Frame.size * Work.values[static_cast<std::size_t>(c) * PiecePairs::kStride];
    }
    const Vec3 next(
      pairs.Column(kXiColumn)[0], pairs.Column(kXiColumn + 1)[0], pairs.Column(kXiColumn + 2)[0]);
    // A singular matrix leaves the point unchanged.
    if (n < steps && std::isfinite(next.x) && std::isfinite(next.y) && std::isfinite(next.z))
    {
      hit.xi = next;
    }
  }
  hit.t = Bundle.TimeAt(ray, hit.position);
  pairs.Clear();
  return hit;
}
} // namespace pixelexact
