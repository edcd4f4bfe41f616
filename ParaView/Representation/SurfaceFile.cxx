// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFile.h"

#include "vtkHighOrderPatchSurface.h"
#include "vtkHighOrderTriangleSurface.h"

#include "Core/Base/Error.h"
#include "Surfaces/StlText.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <filesystem>

namespace pixelexact
{
namespace
{
/// Returns the output of a reader. Throws Error where it has no points.
template <class Reader>
auto Read(const std::string& file)
{
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkSmartPointer found = reader->GetOutput();
  if (found == nullptr || found->GetNumberOfPoints() == 0)
  {
    throw Error("surface file '" + file + "': no points could be read; choose another file");
  }
  return found;
}

vtkSmartPointer<vtkPolyData> ReadStl(const std::string& file)
{
  try
  {
    const auto text = ReadStlText(file);
    return text != nullptr ? text : Read<vtkSTLReader>(file);
  }
  catch (const InvalidData& error)
  {
    throw Error("surface file '" + file + "': " + error.what());
  }
}

vtkSmartPointer<vtkHighOrderSurface> Triangles(vtkPolyData* data)
{
  auto surface = vtkSmartPointer<vtkHighOrderTriangleSurface>::New();
  surface->SetInputData(data);
  return surface;
}

vtkSmartPointer<vtkHighOrderSurface> Patches(vtkPointSet* data)
{
  auto surface = vtkSmartPointer<vtkHighOrderPatchSurface>::New();
  surface->SetInputData(data);
  return surface;
}
} // namespace

vtkSmartPointer<vtkHighOrderSurface> SurfaceOfFile(const std::string& file)
{
  if (file.empty())
  {
    throw Error("no surface file is chosen: name one of triangles (.stl, .vtp) or patches (.vtu)");
  }
  if (!std::filesystem::is_regular_file(file))
  {
    throw Error("surface file '" + file + "': there is no such file");
  }
  const std::string suffix = std::filesystem::path(file).extension().string();
  if (suffix == ".stl")
  {
    return Triangles(ReadStl(file));
  }
  if (suffix == ".vtp")
  {
    const auto data = Read<vtkXMLPolyDataReader>(file);
    return data->GetNumberOfPolys() + data->GetNumberOfStrips() > 0 ? Triangles(data)
                                                                    : Patches(data);
  }
  if (suffix == ".vtu")
  {
    return Patches(Read<vtkXMLUnstructuredGridReader>(file));
  }
  throw Error("surface file '" + file +
    "': unknown suffix; take triangles (.stl, .vtp) or Bezier patches (.vtu, .vtp)");
}
} // namespace pixelexact
