// SPDX-License-Identifier: BSD-3-Clause
// Grids in several files: put together, or refused.
#include "SeriesFiles.h"

#include "HighOrderArrays.h"

#include "vtkDataSetAttributes.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGridWriter.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

using GridParts = SeriesFiles;

// MFEM: name.pvd, Cycle000000/data.pvtu, Cycle000000/proc000000.vtu.
TEST_F(GridParts, ReadsThePiecesOfProcesses)
{
  std::string sets;
  for (const int cycle : { 0, 1 })
  {
    const std::string folder = "Cycle00000" + std::to_string(cycle) + "/";
    Write(folder + "proc000000.vtu", Slabs(0, 1, cycle));
    Write(folder + "proc000001.vtu", Slabs(1, 2, cycle));
    WritePieces(folder + "data.pvtu", { "proc000000.vtu", "proc000001.vtu" });
    sets +=
      DataSet("timestep=\"" + std::to_string(cycle) + "\" group=\"\" part=\"0\" name=\"mesh\"",
        folder + "data.pvtu");
  }
  Reader->SetFileName(WriteCollection(sets).c_str());
  ExpectValues(0.0, 0.0);
  const Locator* first = Located();
  ExpectValues(1.0, 1.0);
  EXPECT_EQ(Located(), first);
  EXPECT_EQ(Heard->warnings, "");
  auto* grid = vtkUnstructuredGrid::SafeDownCast(Reader->GetOutputDataObject(0));
  EXPECT_EQ(grid->GetNumberOfCells(), 3);
  EXPECT_EQ(grid->GetNumberOfPoints(), 81); // none merged
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(grid->GetCellData()->GetArray("number")->GetComponent(i, 0), i);
  }
  Reader->SetFileName((Folder / "Cycle000000/data.pvtu").c_str());
  EXPECT_EQ(Steps(), std::vector<double>());
  ExpectValues(0.0, 0.0);
}

/// Each cell of Slabs in eight.
vtkSmartPointer<vtkUnstructuredGrid> Subdivided(vtkUnstructuredGrid* slabs)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::vector<double> u;
  grid->SetPoints(points);
  grid->Allocate(1);
  for (vtkIdType cell = 0; cell < slabs->GetNumberOfCells(); ++cell)
  {
    for (int child = 0; child < 8; ++child)
    {
      std::vector<vtkIdType> ids;
      double first[3];
      slabs->GetPoint(27 * cell, first);
      for (vtkIdType node = 0; node < 27; ++node)
      {
        double x[3];
        slabs->GetPoint(27 * cell + node, x);
        for (int d = 0; d < 3; ++d)
        {
          x[d] = first[d] + (x[d] - first[d]) / 2 + ((child >> d) & 1) / 2.0;
        }
        ids.push_back(points->InsertNextPoint(x));
        u.push_back(Exact({ x[0], x[1], x[2] }, 1.0));
      }
      grid->InsertNextCell(72, 27, ids.data());
    }
  }
  AddPointField(grid, "u", u);
  return grid;
}

/// Marks cells from `first` on as another part's.
vtkSmartPointer<vtkUnstructuredGrid> Marked(
  vtkSmartPointer<vtkUnstructuredGrid> grid, vtkIdType first)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    ghosts->InsertNextValue(cell < first ? 0 : vtkDataSetAttributes::DUPLICATECELL);
  }
  grid->GetCellData()->AddArray(ghosts);
  return grid;
}

TEST_F(GridParts, GhostCellsOfOthersAreLeftOut)
{
  Write("left.vtu", Marked(Slabs(0, 2, 1.0), 1)); // holds cell 1 of the right
  Write("right.vtu", Marked(Slabs(1, 2, 1.0), 2));
  WritePieces("both.pvtu", { "left.vtu", "right.vtu" });
  Reader->SetFileName((Folder / "both.pvtu").c_str());
  ExpectValues(0.0, 1.0);
  EXPECT_EQ(Converter->GetHighOrderOutput()->GetNumberOfCells(), 3);
  EXPECT_EQ(Heard->warnings, "");
}

TEST_F(GridParts, GhostCellsThatNoPartOwnsAreKeptOnce)
{
  Write("left.vtu", Marked(Slabs(0, 2, 1.0), 0));
  Write("right.vtu", Marked(Slabs(1, 2, 1.0), 0)); // cell 1 of both, 2 of this one alone
  WritePieces("both.pvtu", { "left.vtu", "right.vtu" });
  Reader->SetFileName((Folder / "both.pvtu").c_str());
  ExpectValues(0.0, 1.0);
  EXPECT_EQ(Converter->GetHighOrderOutput()->GetNumberOfCells(), 3);
  EXPECT_NE(Heard->warnings.find("3 cells marked as a duplicate"), std::string::npos)
    << Heard->warnings;
  vtkDataArray* marks = Converter->GetHighOrderOutput()->GetCellData()->GetArray(
    vtkDataSetAttributes::GhostArrayName());
  ASSERT_NE(marks, nullptr);
  for (int cell = 0; cell < 3; ++cell)
  {
    EXPECT_EQ(marks->GetComponent(cell, 0), 0.0);
  }
}

TEST_F(GridParts, CellsThatSeveralPartsHoldCountOnce)
{
  Write("left.vtu", Slabs(0, 2, 5.0)); // cell 1 of an earlier time
  const auto right = Slabs(1, 2, 1.0);
  double x[3]; // a part may round its points otherwise
  right->GetPoint(2, x);
  right->GetPoints()->SetPoint(2, x[0], std::nextafter(x[1], 2.0), x[2]);
  Write("right.vtu", right);
  WritePieces("both.pvtu", { "left.vtu", "right.vtu" });
  Reader->SetFileName((Folder / "both.pvtu").c_str());
  Probe->Update();
  EXPECT_EQ(Converter->GetHighOrderOutput()->GetNumberOfCells(), 3);
  EXPECT_NE(Heard->warnings.find("1 cell held by several parts"), std::string::npos)
    << Heard->warnings;
  auto* u = vtkPolyData::SafeDownCast(Probe->GetOutputDataObject(0))->GetPointData()->GetArray("u");
  EXPECT_NEAR(u->GetComponent(0, 0), Exact({ 0.3, 0.4, 0.85 }, 5.0), 1e-13);
  EXPECT_NEAR(u->GetComponent(1, 0), Exact({ 1.7, 0.4, 0.85 }, 1.0), 1e-12);
}

TEST_F(GridParts, OfAPartThatIsListedTwiceTheLaterOneCounts)
{
  Write("first.vtu", Slabs(0, 2, 5.0));
  Write("other.vtu", Slabs(2, 1, 1.0));
  // The run that went on had finer cells.
  Write("later.vtu", Subdivided(Slabs(0, 2, 1.0)));
  const std::string part = "timestep='1' group='' part='0'";
  Reader->SetFileName(WriteCollection(DataSet("timestep='0' group='' part='0'", "first.vtu") +
    DataSet(part, "first.vtu") + DataSet(part, "other.vtu") + DataSet(part, "later.vtu"))
                        .c_str());
  ExpectValues(1.0, 1.0);
  // The other file with the same label is a separate part of the mesh, and stays.
  EXPECT_EQ(Converter->GetHighOrderOutput()->GetNumberOfCells(), 17);
  EXPECT_NE(Heard->warnings.find("lists the same part twice"), std::string::npos)
    << Heard->warnings;
  Heard->warnings.clear();
  ExpectValues(0.0, 5.0, 2);
  EXPECT_EQ(Heard->warnings, "");
}

/// A piece of an XML file, as deal.II writes it.
std::string PieceText(vtkUnstructuredGrid* grid, const std::vector<std::string>& arrays,
  const std::string& cellArray = {})
{
  std::ostringstream text;
  text.precision(17);
  text << "<Piece NumberOfPoints='" << grid->GetNumberOfPoints() << "' NumberOfCells='"
       << grid->GetNumberOfCells() << "'>\n<Points><DataArray type='Float64' "
       << "NumberOfComponents='3' format='ascii'>";
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    const double* x = grid->GetPoint(p);
    text << x[0] << ' ' << x[1] << ' ' << x[2] << ' ';
  }
  text << "</DataArray></Points>\n<Cells><DataArray type='Int32' Name='connectivity' "
       << "format='ascii'>";
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    // Before version 2.1 the last two edges along t have each other's place.
    const vtkIdType node = p % 27;
    text << (node == 18 ? p + 1 : node == 19 ? p - 1 : p) << ' ';
  }
  text << "</DataArray><DataArray type='Int32' Name='offsets' format='ascii'>";
  for (vtkIdType c = 1; c <= grid->GetNumberOfCells(); ++c)
  {
    text << 27 * c << ' ';
  }
  text << "</DataArray><DataArray type='UInt8' Name='types' format='ascii'>";
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    text << "72 ";
  }
  text << "</DataArray></Cells>\n<PointData>";
  for (const std::string& name : arrays)
  {
    text << "<DataArray type='Float64' Name='" << name << "' format='ascii'>";
    for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
    {
      text << grid->GetPointData()->GetArray(name.c_str())->GetComponent(p, 0) << ' ';
    }
    text << "</DataArray>";
  }
  text << "</PointData>\n<CellData>" << cellArray << "</CellData></Piece>\n";
  return text.str();
}

std::string Pieces(const std::string& pieces)
{
  return "<VTKFile type='UnstructuredGrid' version='0.1' byte_order='LittleEndian'>\n"
         "<UnstructuredGrid>\n" +
    pieces + "</UnstructuredGrid></VTKFile>\n";
}

// Cells of a file below version 2.1 have VTK 8's order of nodes. VTK's reader undoes it for all
// cells once more with each piece, and takes arrays by their place in the first one.
TEST_F(GridParts, PiecesOfOneFileAreReadAsTheyAre)
{
  std::string pieces = PieceText(Slabs(0, 0, 1.0), {}); // an idle process
  for (const int lower : { 0, 1, 2 })
  {
    const auto slab = Slabs(lower, 1, 1.0);
    AddPointField(slab, "p", std::vector<double>(27, 7.0));
    pieces += PieceText(slab,
      lower == 1 ? std::vector<std::string>{ "p", "u" } : std::vector<std::string>{ "u", "p" });
  }
  const std::string file = WriteText("pieces.vtu", Pieces(pieces));
  Reader->SetFileName(file.c_str());
  ExpectValues(0.0, 1.0);
  EXPECT_EQ(Heard->warnings, "");
  WritePieces("all.pvtu", { "pieces.vtu" });
  Reader->SetFileName((Folder / "all.pvtu").c_str());
  ExpectValues(0.0, 1.0);
  EXPECT_EQ(Converter->GetHighOrderOutput()->GetNumberOfCells(), 3);

  // The diagnostics detect the order of nodes that VTK's reader leaves.
  Conversion byVtk(ReadGrid(file));
  EXPECT_NE(byVtk.messages->warnings.find("mid nodes fit other edges"), std::string::npos)
    << byVtk.messages->warnings;
}

TEST_F(GridParts, GhostLevelsOfLaterPiecesAreMarks)
{
  const auto levels = [](const std::string& values)
  {
    return "<DataArray type='UInt8' Name='vtkGhostLevels' format='ascii'>" + values +
      "</DataArray>";
  };
  Reader->SetFileName(WriteText("ghosts.vtu",
    Pieces(PieceText(Slabs(0, 2, 1.0), { "u" }, levels("0 0")) +
      PieceText(Slabs(1, 2, 1.0), { "u" }, levels("2 0"))))
                        .c_str());
  ExpectValues(0.0, 1.0);
  EXPECT_EQ(Converter->GetHighOrderOutput()->GetNumberOfCells(), 3);
  EXPECT_EQ(Heard->warnings, "");
}

TEST_F(GridParts, WeightsOfOnePartAreKept)
{
  // A quarter of a ring between radii 1 and 2 as one rational Bezier hexahedron of degrees 2, 1, 1.
  const double w = std::sqrt(0.5);
  std::vector<double> xyz;
  for (const auto& [x, y] : { std::pair{ 1.0, 0.0 }, std::pair{ 0.0, 1.0 }, std::pair{ 1.0, 1.0 } })
  {
    for (const double r : { 1.0, 2.0 })
    {
      for (const double z : { 0.0, 1.0 })
      {
        xyz.insert(xyz.end(), { r * x, r * y, z });
      }
    }
  }
  // VTK's order: eight corners, then the middles of the four edges along r.
  const int order[12] = { 0, 4, 6, 2, 1, 5, 7, 3, 8, 10, 9, 11 };
  std::vector<double> ordered;
  for (const int i : order)
  {
    ordered.insert(ordered.end(), &xyz[3 * i], &xyz[3 * i] + 3);
  }
  const auto ring = OneCell(79, ordered); // VTK_BEZIER_HEXAHEDRON
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("RationalWeights");
  for (int i = 0; i < 12; ++i)
  {
    weights->InsertNextValue(i < 8 ? 1.0 : w);
  }
  ring->GetPointData()->SetRationalWeights(weights);
  vtkNew<vtkDoubleArray> degrees;
  degrees->SetName("HigherOrderDegrees");
  degrees->SetNumberOfComponents(3);
  degrees->InsertNextTuple3(2, 1, 1);
  ring->GetCellData()->SetHigherOrderDegrees(degrees);
  AddPointField(ring, "u", std::vector<double>(12, 1.0));
  Write("ring.vtu", ring);
  Write("slab.vtu", Slabs(3, 1, 1.0));
  WritePieces("both.pvtu", { "slab.vtu", "ring.vtu" });
  Reader->SetFileName((Folder / "both.pvtu").c_str());
  Converter->Update();
  ASSERT_EQ(Heard->errors, "");
  const double middle[3] = { 0.0, -1.0, -1.0 };
  double x[3];
  ASSERT_TRUE(Converter->GetHighOrderOutput()->MapForward(1, middle, x));
  // The middle of the arc is on the circle, which the polynomial through the points misses by 0.06.
  EXPECT_NEAR(std::hypot(x[0], x[1]), 1.0, 1e-3);
}

TEST_F(GridParts, TheContentDecidesWhetherAFileIsLegacy)
{
  vtkNew<vtkUnstructuredGridWriter> writer;
  writer->SetInputData(Slabs(0, 3, 1.0));
  std::filesystem::create_directories(Folder);
  writer->SetFileName((Folder / "legacy.vtu").c_str());
  ASSERT_EQ(writer->Write(), 1);
  Reader->SetFileName((Folder / "legacy.vtu").c_str());
  ExpectValues(0.0, 1.0);
  Write("xml.vtk", Slabs(0, 3, 1.0));
  Reader->SetFileName((Folder / "xml.vtk").c_str());
  ExpectValues(0.0, 1.0);
  WriteText("surface.vtu", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\n");
  Reader->SetFileName((Folder / "surface.vtu").c_str());
  ExpectError("but POLYDATA");
}

TEST_F(GridParts, PartsOfOneStepAreOneGrid)
{
  Write("a.vtu", Slabs(0, 1, 1.0));
  Write("b.vtu", Slabs(1, 2, 1.0));
  const auto idle = vtkSmartPointer<vtkUnstructuredGrid>::New();
  idle->SetPoints(vtkNew<vtkPoints>());
  Write("idle.vtu", idle);
  const double triangle[9] = { 0, 0, 0, 1, 0, 0, 0, 1, 0 };
  Write("wall.vtu", OneCell(5, { triangle, triangle + 9 })); // VTK_TRIANGLE
  Reader->SetFileName(WriteCollection(DataSet("timestep='1' part='0'", "a.vtu") +
    DataSet("timestep='1' part='1'", "b.vtu") + DataSet("timestep='1' part='2'", "idle.vtu") +
    DataSet("timestep='1' part='3'", "wall.vtu") + DataSet("timestep='1' part='4'", "cut.vtp") +
    DataSet("timestep='1' part='1'", "b.vtu")) // written again by a run that was continued
                        .c_str());
  EXPECT_EQ(Steps(), std::vector{ 1.0 });
  ExpectValues(1.0, 1.0);
  EXPECT_EQ(Converter->GetHighOrderOutput()->GetNumberOfCells(), 3);
  EXPECT_EQ(Reader->GetNumberOfDiagnostics(), 2);
  EXPECT_NE(Heard->warnings.find("cut.vtp"), std::string::npos);
  EXPECT_NE(Heard->warnings.find("wall.vtu"), std::string::npos);
}

TEST_F(GridParts, DoublesAreKeptBesideFloats)
{
  const auto left = Slabs(0, 1, 1.0);
  vtkNew<vtkPoints> floats;
  floats->SetDataTypeToFloat();
  floats->GetData()->DeepCopy(left->GetPoints()->GetData());
  left->SetPoints(floats);
  Write("a.vtu", left);
  const auto right = Slabs(1, 2, 1.0);
  const double moved = 1.0 + 1e-12;
  right->GetPoints()->SetPoint(0, moved, moved, moved);
  Write("b.vtu", right);
  WritePieces("both.pvtu", { "a.vtu", "b.vtu" });
  Reader->SetFileName((Folder / "both.pvtu").c_str());
  Reader->Update();
  vtkPoints* points =
    vtkUnstructuredGrid::SafeDownCast(Reader->GetOutputDataObject(0))->GetPoints();
  EXPECT_EQ(points->GetPoint(left->GetNumberOfPoints())[0], moved);
  EXPECT_NE(Heard->warnings.find("single precision"), std::string::npos);
}

TEST_F(GridParts, ArraysThatSomePartsLackAreNoted)
{
  const auto left = Slabs(0, 1, 1.0);
  AddPointField(left, "p", std::vector<double>(27, 1.0));
  Write("a.vtu", left);
  Write("b.vtu", Slabs(1, 2, 1.0));
  WritePieces("both.pvtu", { "a.vtu", "b.vtu" });
  Reader->SetFileName((Folder / "both.pvtu").c_str());
  ExpectValues(0.0, 1.0);
  EXPECT_NE(Heard->warnings.find("'p'"), std::string::npos);
}

TEST_F(GridParts, DegreesOfPartsAreKept)
{
  // There are 3 x 2 x 2 nodes. Only the degrees show the direction with three.
  const auto slab = [](double lower)
  {
    std::vector<double> xyz;
    std::vector<double> u;
    const int nodes[12][3] = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 }, { 0, 0, 2 },
      { 2, 0, 2 }, { 2, 2, 2 }, { 0, 2, 2 }, { 1, 0, 0 }, { 1, 2, 0 }, { 1, 0, 2 }, { 1, 2, 2 } };
    for (const auto& node : nodes)
    {
      const double x = lower + 1.5 * node[0] / kDegree;
      xyz.insert(xyz.end(), { x, node[1] / kDegree, node[2] / kDegree });
      u.push_back(x * x);
    }
    auto grid = OneCell(72, xyz);
    AddPointField(grid, "u", u);
    vtkNew<vtkDoubleArray> degrees;
    degrees->SetName("degrees");
    degrees->SetNumberOfComponents(3);
    degrees->InsertNextTuple3(2, 1, 1);
    grid->GetCellData()->SetHigherOrderDegrees(degrees);
    return grid;
  };
  Write("a.vtu", slab(0.0));
  Write("b.vtu", slab(1.5));
  WritePieces("both.pvtu", { "a.vtu", "b.vtu" });
  Reader->SetFileName((Folder / "both.pvtu").c_str());
  Probe->Update();
  ASSERT_EQ(Heard->errors, "");
  auto* out = vtkPolyData::SafeDownCast(Probe->GetOutputDataObject(0));
  EXPECT_NEAR(out->GetPointData()->GetArray("u")->GetComponent(1, 0), 1.7 * 1.7, 1e-14);
}

TEST_F(GridParts, CoefficientsOfPartsAreMadeAgainOrRefused)
{
  Write("a.vtu", Converted(Slabs(0, 1, 1.0)));
  Write("b.vtu", Converted(Slabs(1, 2, 1.0)));
  WritePieces("both.pvtu", { "a.vtu", "b.vtu" });
  Reader->SetFileName((Folder / "both.pvtu").c_str());
  ExpectValues(0.0, 1.0);

  const auto solver = Converted(Slabs(1, 2, 1.0));
  const std::vector<Space> spaces(2, UniformSpace(Shape::Hexahedron, 0));
  OwnedExpansion p;
  p.Allocate(spaces, 1);
  std::ranges::fill(p.coefficients, 1.0);
  StoreField(solver, "p", { std::move(p) }, Origin::Coefficients);
  Write("b.vtu", solver);
  ExpectError("solver's own coefficients");
  // Alone they are read as they are.
  Reader->SetFileName((Folder / "b.vtu").c_str());
  Heard->errors.clear();
  Converter->Update();
  EXPECT_EQ(Heard->errors, "");
  EXPECT_EQ(Converter->GetHighOrderOutput()->GetNumberOfHighOrderFields(), 3);
}
} // namespace
