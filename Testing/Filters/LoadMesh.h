// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Support.h"

#include "vtkGLVisReader.h"
#include "vtkMFEMReader.h"
#include "vtkNektarReader.h"
#include "vtkUnstructuredGridReader.h"

namespace pixelexact::testing
{
/// The mesh of a file of any kind that is read, without its fields; null where there is none in it.
inline vtkSmartPointer<vtkUnstructuredGrid> LoadMesh(const std::filesystem::path& file)
{
  const std::string name = file.filename().string();
  vtkSmartPointer<vtkHighOrderFileReader> reader;
  if (name.ends_with(".mesh") || name.ends_with(".mesh.gz"))
  {
    reader = vtkSmartPointer<vtkMFEMReader>::New();
  }
  else if (name.ends_with(".saved"))
  {
    reader = vtkSmartPointer<vtkGLVisReader>::New();
  }
  else if (name.ends_with(".xml"))
  {
    reader = vtkSmartPointer<vtkNektarReader>::New();
  }
  if (reader)
  {
    reader->SetFileName(file.c_str());
    reader->Update();
    return reader->GetHighOrderOutput();
  }
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  if (name.ends_with(".vtk"))
  {
    vtkNew<vtkUnstructuredGridReader> legacy;
    legacy->SetFileName(file.c_str());
    legacy->Update();
    grid = legacy->GetOutput();
  }
  else if (name.ends_with(".vtu"))
  {
    grid = ReadGrid(file);
  }
  return grid ? Converted(grid) : nullptr;
}
} // namespace pixelexact::testing
