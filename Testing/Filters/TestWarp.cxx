// SPDX-License-Identifier: BSD-3-Clause
// vtkHighOrderWarp: deformed meshes against the same meshes whose nodes were moved before they were
// converted, against closed forms, and against sums of map and displacement; wrong use.
#include "OracleCheck.h"

#include "Core/Location/Locator.h"

#include "vtkCellType.h"
#include "vtkDataObject.h"
#include "vtkHighOrderCalculator.h"
#include "vtkHighOrderPack.h"
#include "vtkHighOrderWarp.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkHigherOrderTetra.h"
#include "vtkHigherOrderWedge.h"
#include "vtkInformation.h"
#include "vtkMFEMReader.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNektarReader.h"
#include "vtkPoints.h"
#include "vtkThreshold.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

struct Warping
{
  vtkNew<vtkHighOrderWarp> filter;
  vtkNew<Messages> messages;

  Warping(
    vtkDataObject* input, const std::string& field, double scale, const Vec3& direction = Vec3(0.0))
  {
    messages->Watch(filter);
    filter->SetInputData(input);
    filter->SetFieldName(field);
    filter->SetScaleFactor(scale);
    filter->SetDirection(direction.x, direction.y, direction.z);
    filter->Update();
  }
  [[nodiscard]] vtkSmartPointer<vtkUnstructuredGrid> Grid() const
  {
    EXPECT_EQ(messages->errors, "");
    return vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
  }
};

/// Both models are the same map at points of each element, and have the same values and verdicts
/// there.
void ExpectSameShape(const HighOrderModel& a, const HighOrderModel& b, const std::string& field,
  double tolerance, const std::string& name)
{
  const int elements = a.GetMesh().Elements();
  ASSERT_EQ(elements, b.GetMesh().Elements()) << name;
  std::vector<Vec3> points;
  for (int e = 0; e < elements; ++e)
  {
    const std::vector<Vec3> xi = PlacesIn(a.GetMesh().ShapeOf(e));
    std::vector<Vec3> x(xi.size());
    std::vector<Vec3> y(xi.size());
    MapForward(a.GetMesh(), e, xi, x);
    MapForward(b.GetMesh(), e, xi, y);
    for (std::size_t k = 0; k < xi.size(); ++k)
    {
      const Vec3 apart = x[k] - y[k];
      ASSERT_LE(std::hypot(apart.x, apart.y, apart.z), tolerance) << name << " element " << e;
      points.push_back(x[k]);
    }
  }
  const auto sampled = [&](const HighOrderModel& model)
  {
    const Field& of = model.GetField(field);
    std::vector<double> values(points.size() * static_cast<std::size_t>(of.values.components));
    std::vector<Verdict> verdicts(points.size());
    SampleTarget target;
    target.value = values;
    target.verdict = verdicts;
    Sample(model.GetLocator(), &of, points, target);
    return std::pair(values, verdicts);
  };
  const auto [valuesA, verdictsA] = sampled(a);
  const auto [valuesB, verdictsB] = sampled(b);
  EXPECT_EQ(verdictsA, verdictsB) << name;
  double largest = 0.0;
  for (const double value : valuesB)
  {
    largest = std::isfinite(value) ? std::max(largest, std::fabs(value)) : largest;
  }
  for (std::size_t i = 0; i < valuesA.size(); ++i)
  {
    ASSERT_EQ(std::isfinite(valuesA[i]), std::isfinite(valuesB[i])) << name;
    if (std::isfinite(valuesA[i]))
    {
      ASSERT_NEAR(valuesA[i], valuesB[i], tolerance * std::max(1.0, largest)) << name;
    }
  }
}

/// A twist about z, a bend, a stretch.
Vec3 Twist(const Vec3& x)
{
  return { -x.y * x.z + 0.2 * x.z * x.z, x.x * x.z, 0.1 * x.x * x.y - 0.2 * x.z };
}

/// Adds nodal values of Twist, and returns the grid with nodes that were moved by them.
vtkSmartPointer<vtkUnstructuredGrid> WrittenDeformed(vtkUnstructuredGrid* grid, double scale)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("twist");
  values->SetNumberOfComponents(3);
  auto moved = vtkSmartPointer<vtkUnstructuredGrid>::New();
  moved->DeepCopy(grid);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    Vec3 x;
    grid->GetPoint(p, &x.x);
    const Vec3 u = Twist(x);
    values->InsertNextTuple3(u.x, u.y, u.z);
    const Vec3 y = x + scale * u;
    points->InsertNextPoint(&y.x);
  }
  moved->SetPoints(points);
  grid->GetPointData()->AddArray(values);
  return moved;
}

void CompareWithWritten(vtkUnstructuredGrid* grid, double scale, const std::string& name)
{
  // Nodes in single precision would be moved in double.
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(grid->GetPoints());
  grid->SetPoints(points);
  const auto moved = WrittenDeformed(grid, scale);
  const Warping warping(grid, "twist", scale);
  const auto warped = HighOrderModel::From(warping.Grid());
  const auto written = HighOrderModel::From(Converted(moved));
  ExpectSameShape(*warped, *written, "u", 1e-12 * grid->GetLength(), name);
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    Vec3 a;
    Vec3 b;
    warping.Grid()->GetPoint(p, &a.x);
    moved->GetPoint(p, &b.x);
    ASSERT_EQ(a, b) << name;
  }
}

TEST(Warp, FilesAreAsTheSameFilesWrittenDeformed)
{
  for (const char* name : { "toroid_hex_g3_p6", "toroid_prism_g3_p4", "escher_tet_g3_p3",
         "fichera_hex_g3_p4", "dolfinx_hex_g2_p4" })
  {
    CompareWithWritten(ReadGrid(kData / (std::string(name) + ".vtu")), 0.05, name);
  }
}

/// A bent cell with nodes at these places of VTK's reference cell, with a field u.
vtkSmartPointer<vtkUnstructuredGrid> BentCell(int type, const std::vector<Vec3>& nodes)
{
  std::vector<double> xyz;
  std::vector<double> u;
  for (const Vec3& r : nodes)
  {
    const Vec3 x = r + 0.1 * Vec3(r.y * r.z, r.x * r.x, -r.y * r.x);
    xyz.insert(xyz.end(), { x.x, x.y, x.z });
    u.push_back(x.x - 2.0 * x.y * x.z);
  }
  auto grid = OneCell(type, xyz);
  AddPointField(grid, "u", u);
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> BentHexahedron(int n)
{
  const std::array<int, 3> order{ n, n, n };
  std::vector<Vec3> nodes(static_cast<std::size_t>((n + 1) * (n + 1) * (n + 1)));
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int k = 0; k <= n; ++k)
      {
        const int at = vtkHigherOrderHexahedron::PointIndexFromIJK(i, j, k, order.data());
        nodes[static_cast<std::size_t>(at)] = Vec3(i, j, k) / static_cast<double>(n);
      }
    }
  }
  return BentCell(VTK_LAGRANGE_HEXAHEDRON, nodes);
}

vtkSmartPointer<vtkUnstructuredGrid> BentWedge(int n)
{
  const std::array<int, 4> order{ n, n, n, (n + 1) * (n + 1) * (n + 2) / 2 };
  std::vector<Vec3> nodes(static_cast<std::size_t>(order[3]));
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; i + j <= n; ++j)
    {
      for (int k = 0; k <= n; ++k)
      {
        const int at = vtkHigherOrderWedge::PointIndexFromIJK(i, j, k, order.data());
        nodes[static_cast<std::size_t>(at)] = Vec3(i, j, k) / static_cast<double>(n);
      }
    }
  }
  return BentCell(VTK_LAGRANGE_WEDGE, nodes);
}

vtkSmartPointer<vtkUnstructuredGrid> BentTetrahedron(int n)
{
  std::vector<Vec3> nodes;
  for (vtkIdType k = 0; k < (n + 1) * (n + 2) * (n + 3) / 6; ++k)
  {
    std::array<vtkIdType, 4> at{};
    vtkHigherOrderTetra::BarycentricIndex(k, at.data(), n);
    nodes.push_back(Vec3(at[0], at[1], at[2]) / static_cast<double>(n));
  }
  return BentCell(VTK_LAGRANGE_TETRAHEDRON, nodes);
}

TEST(Warp, OrdersTwoToEight)
{
  for (int n = 2; n <= 8; ++n)
  {
    const std::string order = " of order " + std::to_string(n);
    CompareWithWritten(BentHexahedron(n), 0.2, "hexahedron" + order);
    CompareWithWritten(BentWedge(n), 0.2, "wedge" + order);
    CompareWithWritten(BentTetrahedron(n), 0.2, "tetrahedron" + order);
  }
}

vtkSmartPointer<vtkUnstructuredGrid> ReadMfemFiles(
  const std::string& mesh, const std::string& field)
{
  vtkNew<vtkMFEMReader> reader;
  reader->SetFileName(FindData(mesh).c_str());
  reader->AddGridFunctionFileName(FindData(field).c_str());
  reader->Update();
  return reader->GetHighOrderOutput();
}

/// The map at points of each element is x + scale * u, and each point has there the value that it
/// had.
void CheckSums(vtkUnstructuredGrid* grid, const std::string& displacement, double scale,
  const std::string& field)
{
  const auto before = HighOrderModel::From(grid);
  const auto after = HighOrderModel::From(Warping(grid, displacement, scale).Grid());
  // The expression is evaluated at points, the deformed map by its own coefficients.
  const Field& u = before->GetField(displacement);
  const auto wide = static_cast<std::size_t>(before->GetField(field).values.components);
  std::vector<Vec3> points;
  std::vector<double> values;
  const Mesh& mesh = before->GetMesh();
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    const std::vector<Vec3> xi = PlacesIn(mesh.ShapeOf(e));
    std::vector<Vec3> x(xi.size());
    std::vector<Vec3> y(xi.size());
    const auto width = static_cast<std::size_t>(u.values.components);
    std::vector<double> moved(width * xi.size());
    std::vector<double> value(wide * xi.size());
    MapForward(mesh, e, xi, x);
    MapForward(after->GetMesh(), e, xi, y);
    EvaluateAt(mesh, u, e, xi, moved, {});
    EvaluateAt(mesh, before->GetField(field), e, xi, value, {});
    for (std::size_t k = 0; k < xi.size(); ++k)
    {
      for (std::size_t d = 0; d < 3; ++d)
      {
        const int i = static_cast<int>(d);
        const double expected = x[k][i] + (d < width ? scale * moved[width * k + d] : 0.0);
        ASSERT_NEAR(y[k][i], expected, 1e-12 * std::max(1.0, std::fabs(expected)));
      }
      points.push_back(y[k]);
    }
    values.insert(values.end(), value.begin(), value.end());
  }
  std::vector<double> found(wide * points.size());
  std::vector<Verdict> verdicts(points.size());
  SampleTarget target;
  target.value = found;
  target.verdict = verdicts;
  Sample(after->GetLocator(), &after->GetField(field), points, target);
  int inside = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (verdicts[i] == Verdict::Inside)
    {
      ++inside;
      for (std::size_t c = wide * i; c < wide * (i + 1); ++c)
      {
        ASSERT_NEAR(found[c], values[c], 1e-11 * std::max(1.0, std::fabs(values[c])));
      }
    }
  }
  EXPECT_EQ(inside, static_cast<int>(points.size()));
}

TEST(Warp, ABeamIsBentAndStraightAgain)
{
  const std::string folder = "mfem_beam_hex_elast_p4/";
  const auto beam =
    ReadMfemFiles(folder + "mfem_beam_hex_elast_p4.mesh", folder + "displacement.gf");
  CheckSums(beam, "displacement", 3.0, "displacement");
  const Warping bent(beam, "displacement", 3.0);
  const Warping back(bent.Grid(), "displacement", -3.0);
  const auto straight = HighOrderModel::From(back.Grid());
  ExpectSameShape(*straight, *HighOrderModel::From(beam), "displacement", 1e-12, "beam");
  // MFEM's beam is the box [0,8] x [0,1] x [0,1] of straight elements.
  const Mesh& mesh = straight->GetMesh();
  double volume = 0.0;
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    std::vector<Vec3> x(3);
    MapForward(
      mesh, e, std::vector<Vec3>{ Vec3(-1, -1, -1), Vec3(1, 1, 1), Vec3(0.3, -0.5, 0.8) }, x);
    const Vec3 side = x[1] - x[0];
    volume += std::fabs(side.x * side.y * side.z);
    for (int d = 0; d < 3; ++d)
    {
      EXPECT_GE(std::min(x[0][d], x[1][d]), -1e-12);
      EXPECT_LE(std::max(x[0][d], x[1][d]), (d == 0 ? 8.0 : 1.0) + 1e-12);
    }
  }
  EXPECT_NEAR(volume, 8.0, 1e-11);
}

vtkSmartPointer<vtkUnstructuredGrid> ReadNektarFiles(
  const std::string& mesh, const std::string& field)
{
  vtkNew<vtkNektarReader> reader;
  reader->SetFileName(FindData(mesh).c_str());
  reader->AddFieldFileName(FindData(field).c_str());
  reader->Update();
  return reader->GetHighOrderOutput();
}

TEST(Warp, NektarsVelocitiesAsAVector)
{
  if (!std::filesystem::exists(
        FindData("nek_ns_cylinder_hexprism_p4/nek_ns_cylinder_hexprism_p4.xml")))
  {
    GTEST_SKIP() << "needs the larger data";
  }
  const auto grid = ReadNektarFiles("nek_ns_cylinder_hexprism_p4/nek_ns_cylinder_hexprism_p4.xml",
    "nek_ns_cylinder_hexprism_p4/nek_ns_cylinder_hexprism_p4.fld");
  CheckSums(grid, "vec(u,v,w)", 0.01, "p");
}

TEST(Warp, PlaneMeshesStayInTheirPlane)
{
  const auto grid = ReadNektarFiles("nek_plane_kovasznay_p7/nek_plane_kovasznay_p7.xml",
    "nek_plane_kovasznay_p7/nek_plane_kovasznay_p7.rst");
  CheckSums(grid, "vec(u,v)", 0.01, "p");
  const auto along = HighOrderModel::From(Warping(grid, "u", 0.01, Vec3(0, 1, 0)).Grid());
  EXPECT_EQ(along->GetMesh().Elements(), grid->GetNumberOfCells());
}

TEST(Warp, PartsPackedGridsAndBlocksAreDeformedAlike)
{
  const auto grid = Converted(ReadGrid(kData / "toroid_hex_g3_p6.vtu"));
  const Vec3 up(0.0, 0.0, 1.0);
  const auto whole = HighOrderModel::From(Warping(grid, "u", 0.02, up).Grid());
  vtkNew<vtkHighOrderPack> pack;
  pack->SetInputData(grid);
  pack->Update();
  ExpectSameShape(
    *HighOrderModel::From(Warping(pack->GetOutputDataObject(0), "u", 0.02, up).Grid()), *whole, "u",
    0.0, "packed");

  vtkNew<vtkThreshold> threshold;
  threshold->SetInputData(grid);
  threshold->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "PixelExactElementId");
  threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_BETWEEN);
  threshold->SetLowerThreshold(3.0);
  threshold->SetUpperThreshold(1e9);
  threshold->Update();
  const auto part = HighOrderModel::From(Warping(threshold->GetOutput(), "u", 0.02, up).Grid());
  ASSERT_EQ(part->GetMesh().Elements(), whole->GetMesh().Elements() - 3);
  const std::vector<Vec3> xi = PlacesIn(Shape::Hexahedron);
  std::vector<Vec3> x(xi.size());
  std::vector<Vec3> y(xi.size());
  for (int e = 0; e < part->GetMesh().Elements(); ++e)
  {
    MapForward(part->GetMesh(), e, xi, x);
    MapForward(whole->GetMesh(), e + 3, xi, y);
    EXPECT_EQ(x, y);
    EXPECT_EQ(part->SourceCells()[static_cast<std::size_t>(e)], e + 3);
  }

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, grid);
  blocks->SetBlock(1, threshold->GetOutput());
  vtkNew<vtkHighOrderWarp> filter;
  filter->SetInputData(blocks);
  filter->SetFieldName("u");
  filter->SetDirection(0.0, 0.0, 1.0);
  filter->SetScaleFactor(0.02);
  filter->Update();
  const auto both = HighOrderModel::From(filter->GetOutputDataObject(0));
  EXPECT_EQ(both->GetMesh().Elements(), 2 * whole->GetMesh().Elements() - 3);
}

TEST(Warp, TimeDefinitionsAndOtherArraysStay)
{
  const auto grid = ReadGrid(kData / "toroid_hex_g3_p6.vtu");
  vtkNew<vtkHighOrderCalculator> calculator;
  calculator->SetInputData(grid);
  calculator->SetResultArrayName("shift");
  calculator->SetFunction("vec(u,0,u)");
  calculator->Update();
  const auto defined = vtkUnstructuredGrid::SafeDownCast(calculator->GetOutputDataObject(0));
  defined->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), 2.5);
  const Warping warping(defined, "shift", 0.01);
  const auto output = warping.Grid();
  EXPECT_EQ(output->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 2.5);
  const auto model = HighOrderModel::From(output);
  EXPECT_TRUE(model->Definitions().contains("shift"));
  EXPECT_NE(output->GetPointData()->GetArray("u"), nullptr);
  // The input is as it was.
  EXPECT_EQ(defined->GetPoint(0)[0], grid->GetPoint(0)[0]);
  EXPECT_EQ(warping.messages->warnings, "");
}

std::string WarpErrorOf(vtkDataObject* grid, const std::string& field, double scale = 1.0,
  const Vec3& direction = Vec3(0.0))
{
  return Warping(grid, field, scale, direction).messages->errors;
}

void ExpectNamed(const std::string& error, const std::string& part)
{
  EXPECT_NE(error.find(part), std::string::npos) << error;
}

TEST(Warp, WrongUseIsNamedWithTheRemedy)
{
  const auto grid = Converted(ReadGrid(kData / "toroid_hex_g3_p6.vtu"));
  ExpectNamed(WarpErrorOf(grid, ""), "there is no displacement; set FieldName");
  ExpectNamed(WarpErrorOf(grid, "d"), "there is no field 'd'; choose one of 'u'");
  ExpectNamed(
    WarpErrorOf(grid, "u"), "'u' is a scalar, and a displacement is a vector; give the direc");
  ExpectNamed(WarpErrorOf(grid, "u", 1.0, Vec3(std::nan(""), 0, 1)), "zero or not finite");
  ExpectNamed(
    WarpErrorOf(grid, "u", std::nan(""), Vec3(0, 0, 1)), "NaN or infinite; give a finite");
  ExpectNamed(
    WarpErrorOf(grid, "grad(u)"), "'grad(u)' cannot displace the mesh: it is an expression");
  ExpectNamed(WarpErrorOf(grid, "vec(u,u)"), "has 2 components; give 3");
  ExpectNamed(
    WarpErrorOf(grid, "vec(u,u,u*u)"), "'u*u' cannot displace the mesh: it is an expression");
  ExpectNamed(WarpErrorOf(grid, "vec(u,0,0)", 1.0, Vec3(0, 0, 1)), "leave the direction out");
}

TEST(Warp, FieldsThatJumpMapOrAreRationalAreRefused)
{
  const auto periodic = Converted(ReadGrid(kData / "periodic_hex_dg_g3_p4.vtu"));
  ExpectNamed(
    WarpErrorOf(periodic, "u", 1.0, Vec3(0, 0, 1)), "between elements, which would come apart");
  const std::string darcy = "mfem_escher_tet_darcy_p3/";
  const auto flux = ReadMfemFiles(darcy + "mfem_escher_tet_darcy_p3.mesh", darcy + "flux.gf");
  ExpectNamed(WarpErrorOf(flux, "flux"), "it is an H(div) field, whose values contain 1 / det J");
  const std::string pipe = "mfem_nurbs_pipe/";
  const auto nurbs = ReadMfemFiles(pipe + "mfem_nurbs_pipe.mesh", pipe + "u.gf");
  ExpectNamed(WarpErrorOf(nurbs, "u", 1.0, Vec3(0, 0, 1)), "it is a field of NURBS");
  const auto plane = ReadNektarFiles("nek_plane_kovasznay_p7/nek_plane_kovasznay_p7.xml",
    "nek_plane_kovasznay_p7/nek_plane_kovasznay_p7.rst");
  ExpectNamed(
    WarpErrorOf(plane, "u", 1.0, Vec3(0, 0, 1)), "the mesh is 2-D and stays in its plane");
  ExpectNamed(WarpErrorOf(plane, "u"), "give a direction in the plane of the 2-D mesh");
}
} // namespace
