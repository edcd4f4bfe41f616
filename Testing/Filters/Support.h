// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkHighOrderGrid.h"
#include "vtkUnstructuredGridToHighOrderGrid.h"

#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace pixelexact::testing
{
inline const std::filesystem::path kData = PIXELEXACT_DATA_DIR;
inline const std::filesystem::path kToroid = kData / "toroid_hex_g3_p6.vtu";

/// Keeps what an object reports instead of printing it.
class Messages : public vtkCommand
{
public:
  static Messages* New() { return new Messages; }
  void Execute(vtkObject* /*caller*/, unsigned long event, void* data) override
  {
    (event == vtkCommand::ErrorEvent ? errors : warnings) += static_cast<const char*>(data);
  }
  void Watch(vtkObject* object)
  {
    object->AddObserver(vtkCommand::ErrorEvent, this);
    object->AddObserver(vtkCommand::WarningEvent, this);
  }

  std::string errors;
  std::string warnings;
};

inline vtkSmartPointer<vtkUnstructuredGrid> ReadGrid(const std::filesystem::path& file)
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

struct Conversion
{
  vtkNew<vtkUnstructuredGridToHighOrderGrid> filter;
  vtkNew<Messages> messages;
  bool done = false;

  explicit Conversion(vtkUnstructuredGrid* grid)
  {
    messages->Watch(filter);
    filter->SetInputData(grid);
    Run();
  }
  void Run()
  {
    filter->Update();
    done = messages->errors.empty() && filter->GetHighOrderOutput()->GetNumberOfCells() > 0;
  }
  [[nodiscard]] vtkHighOrderGrid* Output() const { return filter->GetHighOrderOutput(); }
};

/// The grid with its coefficients, independent of the filter.
inline vtkSmartPointer<vtkHighOrderGrid> Converted(vtkUnstructuredGrid* grid)
{
  return Conversion(grid).Output();
}

/// A grid of one cell with nodes at the given points.
inline vtkSmartPointer<vtkUnstructuredGrid> OneCell(int type, const std::vector<double>& xyz)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::vector<vtkIdType> ids;
  for (std::size_t i = 0; i + 2 < xyz.size(); i += 3)
  {
    ids.push_back(points->InsertNextPoint(&xyz[i]));
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->Allocate(1);
  grid->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
  return grid;
}

inline void AddPointField(
  vtkUnstructuredGrid* grid, const std::string& name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  grid->GetPointData()->AddArray(array);
}

/// The plane at this z.
inline vtkNew<vtkPlane> MakePlaneAt(double z)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, z);
  plane->SetNormal(0.0, 0.0, 1.0);
  return plane;
}

/// n x n x n trilinear hexahedra on [0,1]^3 with the point field f = x + 2 y + 3 z.
inline vtkSmartPointer<vtkUnstructuredGrid> Boxes(int n)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::vector<double> f;
  for (int k = 0; k <= n; ++k)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        points->InsertNextPoint(double(i) / n, double(j) / n, double(k) / n);
        f.push_back(double(i) / n + 2.0 * j / n + 3.0 * k / n);
      }
    }
  }
  grid->SetPoints(points);
  grid->Allocate(n * n * n);
  const vtkIdType m = n + 1;
  for (vtkIdType k = 0; k < n; ++k)
  {
    for (vtkIdType j = 0; j < n; ++j)
    {
      for (vtkIdType i = 0; i < n; ++i)
      {
        const vtkIdType a = (k * m + j) * m + i;
        const vtkIdType b = a + m * m;
        const vtkIdType ids[8] = { a, a + 1, a + m + 1, a + m, b, b + 1, b + m + 1, b + m };
        grid->InsertNextCell(12, 8, ids); // VTK_HEXAHEDRON
      }
    }
  }
  AddPointField(grid, "f", f);
  return grid;
}

/// Columns of a CSV file by name; words become 0.
using Table = std::map<std::string, std::vector<double>>;
inline Table ReadTable(const std::filesystem::path& file)
{
  std::ifstream in(file);
  std::string line;
  const auto cells = [&]
  {
    std::vector<std::string> out;
    std::stringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');)
    {
      out.push_back(cell);
    }
    return out;
  };
  std::getline(in, line);
  const auto names = cells();
  Table table;
  while (std::getline(in, line))
  {
    const auto row = cells();
    for (std::size_t i = 0; i < names.size() && i < row.size(); ++i)
    {
      table[names[i]].push_back(std::strtod(row[i].c_str(), nullptr));
    }
  }
  return table;
}
} // namespace pixelexact::testing
