// SPDX-License-Identifier: BSD-3-Clause
#include "MeshDiagnostics.h"

#include "vtkCellType.h"

#include <algorithm>
#include <array>
#include <cmath>
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
  std::map<CellKind, ChangeOfBasis> mirrored;
  int wedges = 0;
  int smoother = 0;
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    const CellBasis& basis = mesh.Basis(e);
    if (!CanBeMirrored(basis))
    {
      continue;
    }
    auto at = mirrored.find(basis.kind);
    if (at == mirrored.end())
    {
      at = mirrored.emplace(basis.kind, MakeMirroredWedge(basis.kind)).first;
    }
    ++wedges;
    const double asIs = Roughness(mesh, e, basis.change);
    const double back = Roughness(mesh, e, at->second);
    smoother += asIs > kMuchSmoother * back ? 1 : 0;
  }
  if (2 * smoother > wedges)
  {
    lines.push_back(OutOf(smoother, wedges) + " Lagrange wedges become more than " +
      std::to_string(static_cast<int>(kMuchSmoother)) +
      " times smoother when the nodes inside their quadrilateral r = 0 are mirrored: the file "
      "seems to have MFEM's node order, not VTK's, and values near those faces are wrong. Read "
      "MFEM's own files instead, or reorder the nodes. (Judged from samples.)");
  }
}

/// Gauss-Lobatto-Legendre points of order n in [0,1]: roots of (1 - z^2) P_n'(z).
std::vector<double> GaussLobatto(int n)
{
  std::vector<double> points(n + 1);
  for (int i = 0; i <= n; ++i)
  {
    double z = -std::cos(M_PI * i / n);
    // Newton's iteration for (1 - z^2) P_n'(z) = n (P_{n-1} - z P_n), whose derivative is
    // -n (n + 1) P_n.
    for (int step = 0; step < 50; ++step)
    {
      double previous = 1.0;
      double current = z;
      for (int k = 1; k < n; ++k)
      {
        const double next = ((2 * k + 1) * z * current - k * previous) / (k + 1);
        previous = current;
        current = next;
      }
      z -= (z * current - previous) / ((n + 1) * current);
    }
    points[i] = (1 + z) / 2;
  }
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
  int warped = 0;
  int straight = 0;
  for (int e = 0; e < mesh.Elements(); ++e)
  {
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
      warped += nodes == EdgeNodes::GaussLobatto ? 1 : 0;
    }
  }
  if (2 * warped > straight)
  {
    lines.push_back(OutOf(warped, straight) +
      " straight edges looked at have their nodes at Gauss-Lobatto-Legendre points, where VTK's "
      "Lagrange cells have them equispaced: geometry and fields of this file are not those of the "
      "solver. Write it with equispaced nodes (DOLFINx: basix.LagrangeVariant.equispaced). (Judged "
      "from samples.)");
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
