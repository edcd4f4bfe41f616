// SPDX-License-Identifier: BSD-3-Clause
// Grids in several files: put together, or refused.
#include "SeriesFiles.h"

#include "HighOrderArrays.h"

#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

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

TEST_F(GridParts, GhostCellsOfOthersAreLeftOut)
{
  const auto markLast = [](vtkUnstructuredGrid* grid)
  {
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfValues(grid->GetNumberOfCells());
    ghosts->Fill(0.0);
    ghosts->SetValue(grid->GetNumberOfCells() - 1, vtkDataSetAttributes::DUPLICATECELL);
    grid->GetCellData()->AddArray(ghosts);
  };
  const auto left = Slabs(0, 2, 1.0); // holds cell 1 of the right
  markLast(left);
  Write("left.vtu", left);
  const auto right = Slabs(1, 3, 1.0);
  markLast(right);
  Write("right.vtu", right);
  WritePieces("both.pvtu", { "left.vtu", "right.vtu" });
  Reader->SetFileName((Folder / "both.pvtu").c_str());
  ExpectValues(0.0, 1.0);
  EXPECT_EQ(Converter->GetHighOrderOutput()->GetNumberOfCells(), 3);
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
  // 3 x 2 x 2 nodes: only the degrees tell along which direction there are three.
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
  ExpansionArrays p;
  p.Allocate(spaces, 1);
  p.coefficients->Fill(1.0);
  StoreField(solver, "p", p, Origin::Coefficients);
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
