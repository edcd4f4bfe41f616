// SPDX-License-Identifier: BSD-3-Clause
// Lagrange cells whose nodes are not where VTK has them: at Gauss-Lobatto-Legendre points, or in
// MFEM's order in wedges.
#include "OracleCheck.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkHigherOrderTetra.h"
#include "vtkHigherOrderWedge.h"
#include "vtkIntArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

using Filter = vtkUnstructuredGridToHighOrderGrid;

/// Gauss-Lobatto-Legendre points in [0,1], from their closed forms.
std::vector<double> Gll(int n)
{
  const double a = std::sqrt(1.0 / 3 - 2 * std::sqrt(7.0) / 21);
  const double b = std::sqrt(1.0 / 3 + 2 * std::sqrt(7.0) / 21);
  const std::vector<std::vector<double>> points{ { 0 }, { -1, 1 }, { -1, 0, 1 },
    { -1, -std::sqrt(0.2), std::sqrt(0.2), 1 },
    { -1, -std::sqrt(3.0 / 7), 0, std::sqrt(3.0 / 7), 1 }, { -1, -b, -a, a, b, 1 } };
  std::vector<double> unit;
  for (const double z : points.at(n))
  {
    unit.push_back((1 + z) / 2);
  }
  return unit;
}

double CubicValue(const Vec3& x)
{
  return 1.0 + x.x - 2.0 * x.y * x.z + x.x * x.y * x.y;
}

/// Nodes of a cell with straight edges, in VTK's order: `place` returns (r, s, t) for VTK's index.
struct Cell
{
  int type;
  std::array<int, 3> order;
  std::vector<Vec3> nodes;

  [[nodiscard]] vtkSmartPointer<vtkUnstructuredGrid> Grid() const
  {
    std::vector<double> xyz;
    std::vector<double> values;
    for (const Vec3& x : nodes)
    {
      xyz.insert(xyz.end(), { x.x, x.y, x.z });
      values.push_back(CubicValue(x));
    }
    auto grid = OneCell(type, xyz);
    AddPointField(grid, "u", values);
    vtkNew<vtkIntArray> degrees;
    degrees->SetName("HigherOrderDegrees");
    degrees->SetNumberOfComponents(3);
    degrees->InsertNextTypedTuple(order.data());
    grid->GetCellData()->SetHigherOrderDegrees(degrees);
    return grid;
  }
};

Cell Hexahedron(const std::array<int, 3>& n)
{
  Cell cell{ VTK_LAGRANGE_HEXAHEDRON, n, {} };
  cell.nodes.resize((n[0] + 1) * (n[1] + 1) * (n[2] + 1));
  if (n[0] > 5)
  {
    return cell; // the caller places the nodes
  }
  for (int i = 0; i <= n[0]; ++i)
  {
    for (int j = 0; j <= n[1]; ++j)
    {
      for (int k = 0; k <= n[2]; ++k)
      {
        cell.nodes.at(vtkHigherOrderHexahedron::PointIndexFromIJK(
          i, j, k, n.data())) = { Gll(n[0])[i], Gll(n[1])[j], Gll(n[2])[k] };
      }
    }
  }
  return cell;
}

/// The places of triangle order 3 by hand: Gauss-Lobatto-Legendre on edges, the centroid inside.
std::array<double, 2> CubicTriangle(int i, int j)
{
  const auto g = Gll(3);
  if (i == 1 && j == 1)
  {
    return { 1.0 / 3, 1.0 / 3 };
  }
  return i + j == 3 ? std::array{ g[i], 1 - g[i] } : std::array{ g[i], g[j] };
}

Cell Wedge(int line)
{
  Cell cell{ VTK_LAGRANGE_WEDGE, { 3, 3, line }, {} };
  const int order[4] = { 3, 3, line, 0 };
  cell.nodes.resize(10 * (line + 1));
  for (int i = 0; i <= 3; ++i)
  {
    for (int j = 0; j <= 3 - i; ++j)
    {
      for (int k = 0; k <= line; ++k)
      {
        const auto [r, s] = CubicTriangle(i, j);
        cell.nodes.at(
          vtkHigherOrderWedge::PointIndexFromIJK(i, j, k, order)) = { r, s, Gll(line)[k] };
      }
    }
  }
  return cell;
}

Cell Tetrahedron()
{
  Cell cell{ VTK_LAGRANGE_TETRAHEDRON, { 3, 3, 3 }, std::vector<Vec3>(20) };
  const auto g = Gll(3);
  for (vtkIdType i = 0; i <= 3; ++i)
  {
    for (vtkIdType j = 0; j <= 3 - i; ++j)
    {
      for (vtkIdType k = 0; k <= 3 - i - j; ++k)
      {
        const vtkIdType l = 3 - i - j - k;
        const vtkIdType index[4] = { i, j, k, l };
        const bool onEdge = (i == 0) + (j == 0) + (k == 0) + (l == 0) >= 2;
        const auto at = [&](vtkIdType m)
        {
          // At a face's centroid three coordinates are 1, a third each; otherwise the node is on an
          // edge or at a vertex.
          return onEdge ? g[static_cast<std::size_t>(m)] : static_cast<double>(m) / 3;
        };
        cell.nodes.at(vtkHigherOrderTetra::Index(index, 3)) = { at(i), at(j), at(k) };
      }
    }
  }
  return cell;
}

void ExpectSolversField(Filter& filter, Shape shape)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> eta(-1.0, 1.0);
  vtkNew<vtkDoubleArray> found;
  for (int trial = 0; trial < 20; ++trial)
  {
    const Vec3 at = TensorToReference(shape, { eta(random), eta(random), eta(random) });
    const double xi[3] = { at.x, at.y, at.z };
    double x[3];
    ASSERT_TRUE(filter.GetHighOrderOutput()->MapForward(0, xi, x));
    ASSERT_TRUE(filter.GetHighOrderOutput()->EvaluateField("u", 0, xi, found));
    // The nodes' places are those of the unit shape: the map is straight.
    const Vec3 expected = shape == Shape::Prism
      ? Vec3((1 + at.x) / 2, (1 + at.z) / 2, (1 - at.y) / 2)
      : Vec3((1 + at.x) / 2, (1 + at.y) / 2, (1 + at.z) / 2);
    EXPECT_NEAR(x[0], expected.x, 1e-15);
    EXPECT_NEAR(x[1], expected.y, 1e-15);
    EXPECT_NEAR(x[2], expected.z, 1e-15);
    EXPECT_NEAR(found->GetValue(0), CubicValue(expected), 1e-14);
  }
}

TEST(NodeConventions, GaussLobattoNodes)
{
  const std::vector<std::pair<Cell, Shape>> cells{ { Hexahedron({ 4, 3, 5 }), Shape::Hexahedron },
    { Hexahedron({ 3, 3, 3 }), Shape::Hexahedron }, { Wedge(5), Shape::Prism },
    { Wedge(3), Shape::Prism }, { Tetrahedron(), Shape::Tetrahedron } };
  for (const auto& [cell, shape] : cells)
  {
    Conversion conversion(cell.Grid());
    ASSERT_TRUE(conversion.done) << conversion.messages->errors;
    EXPECT_NE(conversion.messages->warnings.find("--nodes gll"), std::string::npos);
    // The converter must not take the last mesh for this one.
    conversion.filter->SetNodePlacementToGaussLobatto();
    conversion.messages->warnings.clear();
    conversion.Run();
    ASSERT_TRUE(conversion.done) << conversion.messages->errors;
    EXPECT_EQ(conversion.messages->warnings, "");
    ExpectSolversField(*conversion.filter, shape);
    // The map is found to be straight.
    int range[2];
    conversion.Output()->GetGeometryOrderRange(range);
    EXPECT_EQ(range[1], 1);
  }
}

TEST(NodeConventions, EquispacedNodesAreNotTakenForOthersSilently)
{
  const auto file = std::filesystem::path(PIXELEXACT_DATA_DIR) / "dolfinx_hex_g2_p4.vtu";
  Conversion conversion(ReadGrid(file));
  EXPECT_EQ(conversion.messages->warnings, "");
  conversion.filter->SetNodePlacementToGaussLobatto();
  conversion.Run();
  EXPECT_NE(conversion.messages->warnings.find("Leave out SetNodePlacement"), std::string::npos)
    << conversion.messages->warnings;
}

/// Chebyshev points in [0,1].
std::vector<double> Chebyshev(int n)
{
  std::vector<double> unit;
  for (int i = 0; i <= n; ++i)
  {
    unit.push_back((1 - std::cos(std::numbers::pi * i / n)) / 2);
  }
  return unit;
}

std::vector<double> Equispaced(int n)
{
  std::vector<double> unit;
  for (int i = 0; i <= n; ++i)
  {
    unit.push_back(static_cast<double>(i) / n);
  }
  return unit;
}

using NodeFamily = std::vector<double> (*)(int);
using Map = Vec3 (*)(const Vec3&);

/// A hexahedron of order n whose nodes are the images of these points.
vtkSmartPointer<vtkUnstructuredGrid> Bent(int n, NodeFamily points, Map map)
{
  Cell cell = Hexahedron({ n, n, n });
  const auto z = points(n);
  const int order[3] = { n, n, n };
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int k = 0; k <= n; ++k)
      {
        cell.nodes.at(vtkHigherOrderHexahedron::PointIndexFromIJK(i, j, k, order)) =
          map({ z[i], z[j], z[k] });
      }
    }
  }
  return cell.Grid();
}

Vec3 MapLinearly(const Vec3& x)
{
  return { 2 * x.x + x.y, x.y, x.z - x.x / 2 };
}
/// A map of order 2 that leaves no edge straight.
Vec3 Quadratic(const Vec3& x)
{
  return { x.x + 0.15 * x.y * x.y + 0.1 * x.z * x.z, x.y + 0.2 * x.x * x.x - 0.1 * x.z * x.z,
    x.z + 0.1 * x.x * x.x - 0.15 * x.y * x.y };
}
/// Part of a ring: of no order, 60 degrees of it.
Vec3 Ring(const Vec3& x)
{
  const double angle = std::numbers::pi / 3 * x.x;
  return { (1 + x.y) * std::cos(angle), (1 + x.y) * std::sin(angle),
    x.z + 0.3 * std::sin(x.x + x.y + 2 * x.z) };
}

TEST(NodeConventions, PlacesOfNodesAreFoundOnCurvedEdges)
{
  for (const Map map : { &MapLinearly, &Quadratic, &Ring })
  {
    for (const int n : { 3, 4, 5 })
    {
      Conversion sound(Bent(n, &Equispaced, map));
      EXPECT_EQ(sound.messages->warnings, "") << n;
      sound.filter->SetNodePlacementToGaussLobatto();
      sound.Run();
      EXPECT_NE(sound.messages->warnings.find("Leave out SetNodePlacement"), std::string::npos)
        << n;

      Conversion lobatto(Bent(n, &Gll, map));
      EXPECT_NE(lobatto.messages->warnings.find("--nodes gll"), std::string::npos) << n;
      lobatto.messages->warnings.clear();
      lobatto.filter->SetNodePlacementToGaussLobatto();
      lobatto.Run();
      EXPECT_EQ(lobatto.messages->warnings, "") << n;

      Conversion chebyshev(Bent(n, &Chebyshev, map));
      EXPECT_NE(chebyshev.messages->warnings.find("Chebyshev"), std::string::npos) << n;
    }
    // At high order the map also appears smooth with nodes at wrong places.
    for (const int n : { 8, 12 })
    {
      Conversion sound(Bent(n, &Equispaced, map));
      EXPECT_EQ(sound.messages->warnings, "") << n;
      Conversion chebyshev(Bent(n, &Chebyshev, map));
      EXPECT_NE(chebyshev.messages->warnings.find("Chebyshev"), std::string::npos) << n;
    }
  }
}

TEST(NodeConventions, NodesInsideTrianglesAreRefusedWhereTheyAreAChoice)
{
  for (const auto& [type, points] :
    { std::pair{ VTK_LAGRANGE_TETRAHEDRON, 35 }, std::pair{ VTK_LAGRANGE_WEDGE, 75 } })
  {
    Conversion conversion(OneCell(type, std::vector<double>(3 * points)));
    conversion.filter->SetNodePlacementToGaussLobatto();
    conversion.Run();
    for (const char* word : { "cell 0", "of order 4", "--nodes gll", "equispaced" })
    {
      EXPECT_NE(conversion.messages->errors.find(word), std::string::npos)
        << conversion.messages->errors;
    }
  }
}

/// A wedge of triangle order 4 and line order 3 with straight edges. With `mirrored` the nodes
/// inside its quadrilateral r = 0 are mirrored.
Cell EquispacedWedge(bool mirrored)
{
  Cell cell{ VTK_LAGRANGE_WEDGE, { 4, 4, 3 }, std::vector<Vec3>(60) };
  const int order[4] = { 4, 4, 3, 0 };
  for (int i = 0; i <= 4; ++i)
  {
    for (int j = 0; j <= 4 - i; ++j)
    {
      for (int k = 0; k <= 3; ++k)
      {
        const bool inside = i == 0 && j > 0 && j < 4 && k > 0 && k < 3;
        const int at = mirrored && inside ? 4 - j : j;
        cell.nodes.at(
          vtkHigherOrderWedge::PointIndexFromIJK(i, at, k, order)) = { i / 4.0, j / 4.0, k / 3.0 };
      }
    }
  }
  return cell;
}

TEST(NodeConventions, MirroredWedges)
{
  Conversion conversion(EquispacedWedge(true).Grid());
  EXPECT_NE(conversion.messages->warnings.find("--mirrored-wedges"), std::string::npos);
  conversion.filter->MirroredWedgesOn();
  conversion.messages->warnings.clear();
  conversion.Run();
  EXPECT_EQ(conversion.messages->warnings, "");
  ExpectSolversField(*conversion.filter, Shape::Prism);

  Conversion sound(EquispacedWedge(false).Grid());
  EXPECT_EQ(sound.messages->warnings, "");
  ExpectSolversField(*sound.filter, Shape::Prism);
  sound.filter->MirroredWedgesOn();
  sound.Run();
  EXPECT_NE(sound.messages->warnings.find("Leave out SetMirroredWedges"), std::string::npos);
}

TEST(NodeConventions, MfemsWedgesHaveMfemsValues)
{
  const auto folder = std::filesystem::path(PIXELEXACT_SHARED_DATA_DIR) / "mfem_toroid_prism_g3_p4";
  if (!std::filesystem::exists(folder))
  {
    GTEST_SKIP() << "no shared data on this machine";
  }
  Conversion conversion(ReadGrid(folder / "mfem_toroid_prism_g3_p4.vtu"));
  conversion.filter->MirroredWedgesOn();
  conversion.messages->warnings.clear();
  conversion.Run();
  EXPECT_EQ(conversion.messages->warnings, "");
  OracleErrors errors;
  MeasureValues(conversion.Output(), ReadOracle(folder / "oracle_u.csv"), "u", errors);
  EXPECT_EQ(errors.outside, 0);
  EXPECT_LT(errors.value, 1e-13);
}
} // namespace
