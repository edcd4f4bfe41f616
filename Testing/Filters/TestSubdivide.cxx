// SPDX-License-Identifier: BSD-3-Clause
// vtkHighOrderSubdivide: against VTK's own evaluation of its cells and closed forms, wrong use.
#include "Support.h"

#include "vtkHighOrderSubdivide.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTypeInt64Array.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace
{
using namespace pixelexact::testing;

struct Subdividing
{
  vtkNew<vtkHighOrderSubdivide> filter;
  vtkNew<Messages> messages;

  explicit Subdividing(vtkDataObject* grid)
  {
    messages->Watch(filter);
    filter->SetInputData(grid);
  }
  vtkUnstructuredGrid* At(int level)
  {
    filter->SetLevel(level);
    filter->Update();
    return filter->GetOutput();
  }
};

/// The volume of a cell from its faces' triangles.
double ComputeVolume(vtkCell* cell)
{
  double volume = 0.0;
  const auto at = [](vtkCell* face, vtkIdType i)
  {
    std::array<double, 3> x;
    face->GetPoints()->GetPoint(i, x.data());
    return x;
  };
  for (int f = 0; f < cell->GetNumberOfFaces(); ++f)
  {
    vtkCell* face = cell->GetFace(f);
    const auto a = at(face, 0);
    for (vtkIdType i = 1; i + 1 < face->GetNumberOfPoints(); ++i)
    {
      const auto b = at(face, i);
      const auto c = at(face, i + 1);
      volume += vtkMath::Determinant3x3(a.data(), b.data(), c.data()) / 6.0;
    }
  }
  return volume;
}

/// The volume of the cells, each of which must be positive.
double ComputeVolume(vtkUnstructuredGrid* grid)
{
  double sum = 0.0;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    const double volume = ComputeVolume(grid->GetCell(i));
    EXPECT_GT(volume, 0.0) << i;
    sum += volume;
  }
  return sum;
}

/// The number of faces that belong to one cell. VTK 9.1's surface filters leak memory.
vtkIdType FacesOutside(vtkUnstructuredGrid* grid)
{
  std::map<std::set<vtkIdType>, int> cells;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    vtkCell* const cell = grid->GetCell(i);
    for (int k = 0; k < cell->GetNumberOfFaces(); ++k)
    {
      vtkIdList* const points = cell->GetFace(k)->GetPointIds();
      ++cells[{ points->GetPointer(0), points->GetPointer(0) + points->GetNumberOfIds() }];
    }
  }
  return std::ranges::count_if(cells, [](const auto& face) { return face.second == 1; });
}

TEST(Subdivide, CellsOfEachShapeFillItAndFit)
{
  struct Case
  {
    int type;
    std::vector<double> xyz;
    double volume;
    vtkIdType (*cells)(vtkIdType n);
    vtkIdType (*faces)(vtkIdType n);
  };
  const Case cases[] = {
    { VTK_HEXAHEDRON, { 0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 0, 0, 0, 1, 2, 0, 1, 2, 1, 1, 0, 1, 1 },
      2.0, [](vtkIdType n) { return n * n * n; }, [](vtkIdType n) { return 6 * n * n; } },
    { VTK_WEDGE, { 0, 0, 0, 0, 1, 0, 2, 0, 0, 0, 0, 3, 0, 1, 3, 2, 0, 3 }, 3.0,
      [](vtkIdType n) { return n * n * n; }, [](vtkIdType n) { return 5 * n * n; } },
    { VTK_TETRA, { 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 1 }, 1.0, [](vtkIdType n) { return n * n * n; },
      [](vtkIdType n) { return 4 * n * n; } },
    { VTK_PYRAMID, { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0.5, 3 }, 1.0,
      [](vtkIdType n) { return n * (2 * n * n + 1) / 3 + 2 * n * (n * n - 1) / 3; },
      [](vtkIdType n) { return 5 * n * n; } },
  };
  for (const Case& shape : cases)
  {
    Subdividing subdividing(OneCell(shape.type, shape.xyz));
    for (int level = 0; level <= 5; ++level)
    {
      const vtkIdType n = vtkIdType{ 1 } << level;
      vtkUnstructuredGrid* output = subdividing.At(level);
      ASSERT_EQ(output->GetNumberOfCells(), shape.cells(n)) << shape.type << " level " << level;
      EXPECT_NEAR(ComputeVolume(output), shape.volume, 1e-12) << shape.type << " level " << level;
      // Where two cells do not match, the faces between them count as outer ones.
      EXPECT_EQ(FacesOutside(output), shape.faces(n)) << shape.type << " level " << level;
    }
    EXPECT_EQ(subdividing.messages->errors, "");
  }
}

TEST(Subdivide, PointsAndValuesAreThoseOfVtksCells)
{
  const auto grid = ReadGrid(kData / "toroid_hex_g3_p6.vtu");
  vtkDataArray* u = grid->GetPointData()->GetArray("u");
  Subdividing subdividing(grid);
  vtkUnstructuredGrid* output = subdividing.At(2);
  const int side = 5;
  ASSERT_EQ(output->GetNumberOfPoints(), grid->GetNumberOfCells() * side * side * side);
  vtkDataArray* values = output->GetPointData()->GetArray("u");
  ASSERT_NE(values, nullptr);
  vtkIdType point = 0;
  std::vector<double> weights(1000);
  for (vtkIdType element = 0; element < grid->GetNumberOfCells(); ++element)
  {
    vtkCell* cell = grid->GetCell(element);
    for (int i = 0; i < side * side * side; ++i, ++point)
    {
      const double pcoords[3] = { i % side / 4.0, i / side % side / 4.0, i / side / side / 4.0 };
      int subId = 0;
      double x[3];
      cell->EvaluateLocation(subId, pcoords, x, weights.data());
      double value = 0.0;
      for (vtkIdType k = 0; k < cell->GetNumberOfPoints(); ++k)
      {
        value += weights[static_cast<std::size_t>(k)] * u->GetTuple1(cell->GetPointId(k));
      }
      double made[3];
      output->GetPoint(point, made);
      for (int d = 0; d < 3; ++d)
      {
        ASSERT_NEAR(made[d], x[d], 1e-6) << point; // the file's coordinates are floats
      }
      ASSERT_NEAR(values->GetTuple1(point), value, 1e-12) << point;
    }
  }
}

TEST(Subdivide, CurvedVolumesConvergeAtSecondOrder)
{
  for (const char* name : { "toroid_hex_g3_p6.vtu" })
  {
    Subdividing subdividing(ReadGrid(kData / name));
    std::vector<double> volumes;
    for (int level = 1; level <= 4; ++level)
    {
      volumes.push_back(ComputeVolume(subdividing.At(level)));
    }
    for (std::size_t i = 0; i + 2 < volumes.size(); ++i)
    {
      const double ratio = (volumes[i + 1] - volumes[i]) / (volumes[i + 2] - volumes[i + 1]);
      EXPECT_NEAR(std::log2(ratio), 2.0, 0.3) << name << " " << i;
    }
  }
}

TEST(Subdivide, CellArraysGoToTheParts)
{
  const auto grid = Boxes(2);
  vtkNew<vtkIntArray> colors;
  colors->SetName("material");
  for (int i = 0; i < 8; ++i)
  {
    colors->InsertNextValue(10 + i);
  }
  grid->GetCellData()->AddArray(colors);
  Subdividing subdividing(grid);
  subdividing.filter->AddField("f");
  vtkUnstructuredGrid* output = subdividing.At(1);
  ASSERT_EQ(output->GetNumberOfCells(), 64);
  auto* material = vtkIntArray::SafeDownCast(output->GetCellData()->GetArray("material"));
  auto* element = vtkTypeInt64Array::SafeDownCast(output->GetCellData()->GetArray("Element"));
  ASSERT_TRUE(material != nullptr && element != nullptr);
  for (vtkIdType i = 0; i < 64; ++i)
  {
    EXPECT_EQ(element->GetValue(i), i / 8);
    EXPECT_EQ(material->GetValue(i), 10 + i / 8);
  }
  EXPECT_FALSE(vtkHighOrderGrid::IsHighOrder(output));
  EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 1);
}

TEST(Subdivide, CompositeDataBecomesOneGrid)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int b = 0; b < 2; ++b)
  {
    const auto grid = Boxes(1);
    vtkNew<vtkIntArray> number;
    number->SetName("number");
    number->InsertNextValue(static_cast<int>(b));
    grid->GetCellData()->AddArray(number);
    blocks->SetBlock(b, Converted(grid));
  }
  Subdividing subdividing(blocks);
  vtkUnstructuredGrid* output = subdividing.At(1);
  ASSERT_EQ(subdividing.messages->errors, "");
  ASSERT_EQ(output->GetNumberOfCells(), 16);
  vtkDataArray* number = output->GetCellData()->GetArray("number");
  ASSERT_NE(number, nullptr);
  EXPECT_EQ(number->GetTuple1(0), 0.0);
  EXPECT_EQ(number->GetTuple1(15), 1.0);
}

TEST(Subdivide, LinearFieldsOnStraightElementsNeedNoParts)
{
  Subdividing subdividing(Boxes(2));
  subdividing.filter->SetTolerance(1e-9);
  EXPECT_EQ(subdividing.At(5)->GetNumberOfCells(), 8);
  EXPECT_EQ(subdividing.filter->GetNumberOfCoarseElements(), 0);
}

TEST(Subdivide, TolerancesAreMetAndNamedWhereNot)
{
  Subdividing subdividing(ReadGrid(kData / "toroid_hex_g3_p6.vtu"));
  vtkIdType before = 0;
  for (const double tolerance : { 1e-1, 1e-2, 3e-3 })
  {
    subdividing.filter->SetTolerance(tolerance);
    const vtkIdType cells = subdividing.At(5)->GetNumberOfCells();
    EXPECT_EQ(subdividing.filter->GetNumberOfCoarseElements(), 0);
    EXPECT_GT(cells, before);
    before = cells;
  }
  subdividing.filter->SetTolerance(1e-6);
  EXPECT_EQ(subdividing.At(1)->GetNumberOfCells(), 48 * 8);
  EXPECT_EQ(subdividing.filter->GetNumberOfCoarseElements(), 48);
}

TEST(Subdivide, IsTheSameForAnyNumberOfThreads)
{
  const auto grid = ReadGrid(kData / "toroid_hex_g3_p6.vtu");
  Subdividing many(grid);
  vtkUnstructuredGrid* output = many.At(3);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  Subdividing alone(grid);
  vtkUnstructuredGrid* serial = alone.At(3);
  for (const auto& [a, b] :
    { std::pair{ output->GetPoints()->GetData(), serial->GetPoints()->GetData() },
      std::pair{ output->GetPointData()->GetArray("u"), serial->GetPointData()->GetArray("u") } })
  {
    ASSERT_EQ(a->GetNumberOfValues(), b->GetNumberOfValues());
    const auto* first = static_cast<const double*>(a->GetVoidPointer(0));
    EXPECT_TRUE(std::equal(
      first, first + a->GetNumberOfValues(), static_cast<const double*>(b->GetVoidPointer(0))));
  }
}

TEST(Subdivide, AbortsAndTellsItsProgress)
{
  Subdividing subdividing(ReadGrid(kData / "toroid_hex_g3_p6.vtu"));
  struct Watch : vtkCommand
  {
    static Watch* New() { return new Watch; }
    void Execute(vtkObject* caller, unsigned long /*event*/, void* data) override
    {
      const double part = *static_cast<double*>(data);
      rises = rises && part >= last;
      last = part;
      if (part > 0.3 && abort)
      {
        static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
      }
    }
    bool abort = true;
    bool rises = true;
    double last = 0.0;
  };
  vtkNew<Watch> watch;
  subdividing.filter->AddObserver(vtkCommand::ProgressEvent, watch);
  EXPECT_EQ(subdividing.At(3)->GetNumberOfCells(), 0);
  EXPECT_TRUE(watch->rises);
  watch->abort = false;
  subdividing.filter->SetAbortExecute(0);
  subdividing.filter->Modified();
  watch->last = 0.0;
  EXPECT_EQ(subdividing.At(3)->GetNumberOfCells(), 48 * 512);
  EXPECT_TRUE(watch->rises);
}

TEST(Subdivide, WrongUseIsNamed)
{
  Subdividing unknown(Boxes(1));
  unknown.filter->AddField("no such");
  EXPECT_EQ(unknown.At(1)->GetNumberOfCells(), 0);
  EXPECT_NE(
    unknown.messages->errors.find("no field 'no such'; choose one of 'f'"), std::string::npos)
    << unknown.messages->errors;

  Subdividing large(Boxes(50));
  EXPECT_EQ(large.At(5)->GetNumberOfCells(), 0);
  EXPECT_NE(
    large.messages->errors.find("4492125000 points in 4096000000 cells need"), std::string::npos)
    << large.messages->errors;
  EXPECT_NE(large.messages->errors.find("lower the level"), std::string::npos);
}
} // namespace
