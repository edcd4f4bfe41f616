// SPDX-License-Identifier: BSD-3-Clause
#include "Input/TriangleFile.h"

#include "Base/VtkMessages.h"
#include "Input/Input.h"

#include "Core/Base/Error.h"
#include "VtkTriangles.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <filesystem>

namespace pixelexact
{
namespace
{
template <class Reader>
vtkSmartPointer<vtkPolyData> ReadBy(const std::string& file)
{
  vtkNew<Reader> reader;
  const VtkMessages messages;
  reader->SetFileName(file.c_str());
  reader->Update();
  if (const std::string failure = messages.FirstError(); !failure.empty())
  {
    CannotRead(file, failure);
  }
  return reader->GetOutput();
}
} // namespace

std::shared_ptr<const Surface> ReadTriangles(const std::string& file)
{
  const std::string ending = std::filesystem::path(file).extension().string();
  if (ending != ".vtp" && ending != ".stl")
  {
    throw Error("--surface: '" + file + "' is neither a .vtp nor an .stl file");
  }
  if (!std::filesystem::exists(file))
  {
    CannotRead(file, "there is no such file");
  }
  const vtkSmartPointer<vtkPolyData> surface =
    ending == ".vtp" ? ReadBy<vtkXMLPolyDataReader>(file) : ReadBy<vtkSTLReader>(file);
  try
  {
    return ToTriangles(surface);
  }
  catch (const Error& error)
  {
    CannotRead(file, error.what());
  }
}
} // namespace pixelexact
