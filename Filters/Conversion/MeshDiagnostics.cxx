// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/MeshDiagnostics.h"

#include "Core/Basis/LineFunctions.h"

#include "vtkCellType.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>

namespace pixelexact
{
namespace
{
constexpr double kMuchSmoother = 10.0;
/// Nodes are this near, relative to the edge, to a straight line or to the places in question.
constexpr double kNear = 1e-5;

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

/// Gauss-Lobatto-Legendre points of order n in [0,1].
std::vector<double> GaussLobatto(int n)
{
  std::vector<double> points;
  std::ranges::transform(GaussLobattoPoints(n + 1), std::back_inserter(points),
    [](long double z) { return static_cast<double>((1 + z) / 2); });
  return points;
}

enum class EdgeNodes
{
  NotStraight,
  Equispaced,
  GaussLobatto,
  Other
};

EdgeNodes Classify(
  const SourceMesh& mesh, int element, const std::vector<int>& edge, const std::vector<double>& gll)
{
  const auto xyz = mesh.Coordinates();
  const auto points = mesh.Points(element);
  const auto at = [&](std::size_t i, int d) { return xyz[3 * points[edge[i]] + d]; };
  const std::size_t n = edge.size() - 1;
  std::array<double, 3> chord{};
  double square = 0.0;
  for (int d = 0; d < 3; ++d)
  {
    chord[d] = at(n, d) - at(0, d);
    square += chord[d] * chord[d];
  }
  bool equispaced = true;
  bool lobatto = true;
  for (std::size_t i = 1; i < n; ++i)
  {
    double along = 0.0;
    for (int d = 0; d < 3; ++d)
    {
      along += (at(i, d) - at(0, d)) * chord[d] / square;
    }
    double off = 0.0;
    for (int d = 0; d < 3; ++d)
    {
      off = std::max(off, std::fabs(at(i, d) - at(0, d) - along * chord[d]));
    }
    if (!(off <= kNear * std::sqrt(square))) // also where the edge has no length
    {
      return EdgeNodes::NotStraight;
    }
    equispaced = equispaced && std::fabs(along - static_cast<double>(i) / n) <= kNear;
    lobatto = lobatto && std::fabs(along - gll[i]) <= kNear;
  }
  return equispaced ? EdgeNodes::Equispaced
                    : (lobatto ? EdgeNodes::GaussLobatto : EdgeNodes::Other);
}

void DiagnoseWarpedNodes(const SourceMesh& mesh, std::vector<std::string>& lines)
{
  std::map<int, std::vector<double>> lobatto;
  int otherwise = 0; // than they are taken
  int straight = 0;
  bool taken = false; // for Gauss-Lobatto-Legendre points
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    const bool gaussLobatto = mesh.Basis(e).kind.nodes.gaussLobatto;
    const EdgeNodes wrong = gaussLobatto ? EdgeNodes::Equispaced : EdgeNodes::GaussLobatto;
    taken = taken || gaussLobatto;
    for (const auto& edge : mesh.Basis(e).edges)
    {
      const int order = static_cast<int>(edge.size()) - 1;
      if (order < 3)
      {
        continue;
      }
      auto& gll = lobatto[order];
      if (gll.empty())
      {
        gll = GaussLobatto(order);
      }
      const EdgeNodes nodes = Classify(mesh, e, edge, gll);
      straight += nodes == EdgeNodes::NotStraight ? 0 : 1;
      otherwise += nodes == wrong ? 1 : 0;
    }
  }
  if (2 * otherwise > straight)
  {
    lines.push_back(OutOf(otherwise, straight) + " straight edges looked at have their nodes " +
      (taken
          ? "equispaced, as VTK's Lagrange cells have them, but they are taken to be at "
            "Gauss-Lobatto-Legendre points: geometry and fields are not those of the file. Leave "
            "out SetNodePlacement (--nodes gll)."
          : "at Gauss-Lobatto-Legendre points, where VTK's Lagrange cells have them equispaced: "
            "geometry and fields of this file are not those of the solver. Have them taken as "
            "such by SetNodePlacement (--nodes gll; triangles to order 3), or write the file with "
            "equispaced nodes "
            "(DOLFINx: basix.LagrangeVariant.equispaced).") +
      " (Judged from samples.)");
  }
}
} // namespace

std::vector<std::string> DiagnoseNodes(const SourceMesh& source)
{
  std::vector<std::string> lines;
  DiagnoseMirroredWedges(source, lines);
  DiagnoseWarpedNodes(source, lines);
  return lines;
}
} // namespace pixelexact
