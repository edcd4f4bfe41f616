// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/MeshDiagnostics.h"

#include "Core/Basis/LineFunctions.h"
#include "Core/Element/ElementUnits.h"
#include "Core/Math/Vec.h"

#include "vtkCellType.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>

namespace pixelexact
{
namespace
{
constexpr double kMuchSmoother = 10.0;
/// Relative to the edge: smaller modes of its map are ignored.
constexpr double kNear = 1e-5;
/// Edges with at most this number of nodes are the same in all placements.
constexpr std::size_t kNodesAlike = 3;

std::string OutOf(int some, int all)
{
  return std::to_string(some) + " of " + std::to_string(all);
}

/// Sum of |coefficients| of the modes of highest order, over the components; world units.
double Roughness(const SourceMesh& mesh, int element, const ChangeOfBasis& change)
{
  const Space& space = change.Target();
  std::vector<double> modes(space.Modes());
  std::vector<double> nodes;
  double sum = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    mesh.Gather(element, mesh.Coordinates(), 3, c, nodes);
    change.Apply(nodes, nodes[0], modes);
    ForEachMode(space,
      [&](int p, int q, int r, int mode)
      {
        if (p + r == space.order[2] || q == space.order[1])
        {
          sum += std::fabs(modes[mode]);
        }
      });
  }
  return sum;
}

/// Whether mirroring changes anything in a Lagrange wedge.
bool CanBeMirrored(const CellBasis& basis)
{
  const auto& order = basis.GetSpace().order;
  return basis.kind.type == VTK_LAGRANGE_WEDGE && !basis.edges[0].empty() && order[2] >= 3 &&
    order[1] >= 2;
}

void DiagnoseMirroredWedges(const SourceMesh& mesh, std::vector<std::string>& lines)
{
  std::map<CellKind, ChangeOfBasis> other;
  bool mirrored = false;
  int wedges = 0;
  int smoother = 0;
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    const CellBasis& basis = mesh.Basis(e);
    if (!CanBeMirrored(basis))
    {
      continue;
    }
    auto at = other.find(basis.kind);
    if (at == other.end())
    {
      at = other.emplace(basis.kind, MakeOtherWedge(basis.kind)).first;
    }
    ++wedges;
    const double asIs = Roughness(mesh, e, basis.change);
    mirrored = basis.kind.nodes.mirroredWedges;
    const double back = Roughness(mesh, e, at->second);
    smoother += asIs > kMuchSmoother * back ? 1 : 0;
  }
  if (2 * smoother > wedges)
  {
    lines.push_back(OutOf(smoother, wedges) + " Lagrange wedges become more than " +
      std::to_string(static_cast<int>(kMuchSmoother)) +
      " times smoother when the nodes inside their quadrilateral r = 0 are " +
      (mirrored ? "not mirrored: the file seems to have VTK's node order, not MFEM's, and values "
                  "near those faces are wrong. Leave out SetMirroredWedges (--mirrored-wedges)."
                : "mirrored: the file seems to have MFEM's node order, not VTK's, and values near "
                  "those faces are wrong. Have them mirrored back by SetMirroredWedges "
                  "(--mirrored-wedges), or read MFEM's own files.") +
      " (Judged from samples.)");
  }
}

/// The placements of nodes along an edge.
enum Placement
{
  kEquispaced,
  kGaussLobatto,
  kChebyshev,
  kPlacements
};

/// n + 1 points on [-1,1] with both ends.
std::vector<long double> PointsOf(Placement placement, int n)
{
  switch (placement)
  {
    case kEquispaced:
      return ClosedUniformPoints(n + 1);
    case kGaussLobatto:
      return GaussLobattoPoints(n + 1);
    default:
    {
      std::vector<long double> points;
      for (int i = 0; i <= n; ++i)
      {
        points.push_back(-std::cos(std::numbers::pi_v<long double> * i / n));
      }
      return points;
    }
  }
}

/// The Legendre modes of the polynomials that are 1 at one of the points and 0 at the others.
class LineModes
{
public:
  /// Gauss-Jordan elimination of the points' Legendre values, with the unit matrix appended.
  explicit LineModes(const std::vector<long double>& points)
    : Count(points.size())
    , Inverse(Count * Count)
  {
    const std::size_t width = 2 * Count;
    std::vector<long double> rows(Count * width);
    for (std::size_t i = 0; i < Count; ++i)
    {
      long double* row = &rows[i * width];
      row[0] = 1;
      row[1] = points[i];
      for (std::size_t k = 1; k + 1 < Count; ++k)
      {
        row[k + 1] = ((2 * k + 1) * points[i] * row[k] - k * row[k - 1]) / (k + 1);
      }
      row[Count + i] = 1;
    }
    const auto size = [&](std::size_t i, std::size_t c) { return std::fabs(rows[i * width + c]); };
    for (std::size_t c = 0; c < Count; ++c)
    {
      std::size_t pivot = c;
      for (std::size_t i = c; i < Count; ++i)
      {
        pivot = size(i, c) > size(pivot, c) ? i : pivot;
      }
      std::swap_ranges(&rows[c * width], &rows[c * width] + width, &rows[pivot * width]);
      for (std::size_t i = 0; i < Count; ++i)
      {
        const long double factor = rows[i * width + c] / rows[c * width + c];
        for (std::size_t j = c; j < width && i != c; ++j)
        {
          rows[i * width + j] -= factor * rows[c * width + j];
        }
      }
    }
    for (std::size_t k = 0; k < Count; ++k)
    {
      for (std::size_t i = 0; i < Count; ++i)
      {
        Inverse[k * Count + i] =
          static_cast<double>(rows[k * width + Count + i] / rows[k * width + k]);
      }
    }
  }

  /// `tail[k]` becomes the size of the modes from k on.
  void Tails(const std::vector<Vec3>& values, std::vector<double>& tail) const
  {
    tail.assign(Count + 1, 0.0);
    for (std::size_t k = Count; k-- > 0;)
    {
      Vec3 mode(0.0);
      for (std::size_t i = 0; i < Count; ++i)
      {
        mode += Inverse[k * Count + i] * values[i];
      }
      tail[k] = tail[k + 1] + glm::length(mode);
    }
  }
  /// The largest change of a tail when each value changes by at most 1.
  [[nodiscard]] double Noise(std::size_t k) const
  {
    return std::accumulate(Inverse.begin() + static_cast<std::ptrdiff_t>(k * Count), Inverse.end(),
      0.0, [](double sum, double entry) { return sum + std::fabs(entry); });
  }

private:
  std::size_t Count;
  std::vector<double> Inverse; ///< by mode and point
};

/// Modes by placement, for edges of one order.
using PlacedModes = std::vector<LineModes>;

/// Returns the placement for which the map of an edge is much smoother than for the assumed one, or
/// the assumed one where it is much smoother than another; none where no two placements differ
/// much. Two placements are compared by their modes from each degree above 2 on: for the true
/// placement the modes end at the order of the geometry, or decrease faster.
std::optional<Placement> ClassifyEdge(
  const PlacedModes& modes, const std::vector<Vec3>& nodes, Placement taken, double roundoff)
{
  double largest = 0.0;
  for (const Vec3& x : nodes)
  {
    largest = std::max({ largest, std::fabs(x.x), std::fabs(x.y), std::fabs(x.z) });
  }
  const double error = kCoordinateRoundings * roundoff * largest;
  const double least = kNear * glm::length(nodes.back() - nodes.front());
  std::array<std::vector<double>, kPlacements> tails;
  for (int p = 0; p < kPlacements; ++p)
  {
    modes[p].Tails(nodes, tails[p]);
  }
  const auto ratio = [&](Placement rough, Placement smooth)
  {
    double largestRatio = 0.0;
    for (std::size_t k = 3; k < nodes.size(); ++k)
    {
      const double size = tails[rough][k] - error * modes[rough].Noise(k);
      if (size > least)
      {
        largestRatio = std::max(
          largestRatio, size / (tails[smooth][k] + error * modes[smooth].Noise(k) + kNear * least));
      }
    }
    return largestRatio;
  };
  Placement best = taken;
  double most = kMuchSmoother;
  bool isDecided = false;
  for (const Placement other : { kEquispaced, kGaussLobatto, kChebyshev })
  {
    if (other == taken)
    {
      continue;
    }
    const double better = ratio(taken, other);
    const double worse = ratio(other, taken);
    isDecided = isDecided || std::max(better, worse) > kMuchSmoother;
    if (better > most && better > worse)
    {
      most = better;
      best = other;
    }
  }
  return isDecided ? std::optional(best) : std::nullopt;
}

std::string DescribePlacement(Placement found, Placement taken)
{
  const std::string than = taken == kGaussLobatto
    ? "than at Gauss-Lobatto-Legendre points, for which they are taken"
    : "than equispaced, as VTK's Lagrange cells have them";
  const std::string wrong = ": geometry and fields are not those of the solver. ";
  switch (found)
  {
    case kEquispaced:
      return "equispaced, as VTK's Lagrange cells have them, " + than + wrong +
        "Leave out SetNodePlacement (--nodes gll).";
    case kGaussLobatto:
      return "at Gauss-Lobatto-Legendre points " + than + wrong +
        "Have them taken as such by SetNodePlacement (--nodes gll; triangles to order 3), or write "
        "the file with equispaced nodes (DOLFINx: basix.LagrangeVariant.equispaced).";
    default:
      return "at Chebyshev points " + than + wrong + "Write the file with equispaced nodes.";
  }
}

/// Returns elements with edges of more nodes than kNodesAlike, at most some thousands of them,
/// evenly spread.
std::vector<int> EdgeSamples(const SourceMesh& mesh)
{
  constexpr std::size_t kMaxSamples = 4096;
  std::vector<int> elements;
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    if (std::ranges::any_of(
          mesh.Basis(e).edges, [](const auto& edge) { return edge.size() > kNodesAlike; }))
    {
      elements.push_back(e);
    }
  }
  const std::size_t step = elements.size() / kMaxSamples + 1;
  for (std::size_t i = 0; i * step < elements.size(); ++i)
  {
    elements[i] = elements[i * step];
  }
  elements.resize((elements.size() + step - 1) / step);
  return elements;
}

void DiagnoseWarpedNodes(const SourceMesh& mesh, std::vector<std::string>& lines)
{
  std::map<std::size_t, PlacedModes> modesOf; // by the number of nodes
  std::array<int, kPlacements> found{};
  Placement taken = kEquispaced;
  const auto xyz = mesh.Coordinates();
  std::vector<Vec3> nodes;
  for (const int e : EdgeSamples(mesh))
  {
    const CellBasis& basis = mesh.Basis(e);
    const auto points = mesh.Points(e);
    taken = basis.kind.nodes.gaussLobatto ? kGaussLobatto : kEquispaced;
    for (const auto& edge : basis.edges)
    {
      if (edge.size() <= kNodesAlike)
      {
        continue;
      }
      PlacedModes& modes = modesOf[edge.size()];
      for (int p = static_cast<int>(modes.size()); p < kPlacements; ++p)
      {
        modes.emplace_back(PointsOf(static_cast<Placement>(p), static_cast<int>(edge.size()) - 1));
      }
      nodes.clear();
      for (const int node : edge)
      {
        const double* x = &xyz[3 * static_cast<std::size_t>(points[node])];
        nodes.emplace_back(x[0], x[1], x[2]);
      }
      if (const auto classified = ClassifyEdge(modes, nodes, taken, mesh.CoordinateRoundoff()))
      {
        ++found[*classified];
      }
    }
  }
  const int decided = std::accumulate(found.begin(), found.end(), 0);
  for (int p = 0; p < kPlacements; ++p)
  {
    if (p != taken && 2 * found[p] > decided)
    {
      lines.push_back(OutOf(found[p], decided) +
        " edges have much smoother maps with their nodes " +
        DescribePlacement(static_cast<Placement>(p), taken) + " (Judged from samples.)");
    }
  }
}
} // namespace

std::vector<std::string> DiagnoseNodes(const SourceMesh& source)
{
  std::vector<std::string> lines;
  DiagnoseNodeOrder(source, lines);
  DiagnoseMirroredWedges(source, lines);
  DiagnoseWarpedNodes(source, lines);
  return lines;
}
} // namespace pixelexact
