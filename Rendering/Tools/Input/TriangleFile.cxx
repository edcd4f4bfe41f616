// SPDX-License-Identifier: BSD-3-Clause
#include "Input/TriangleFile.h"

#include "Base/VtkMessages.h"
#include "Input/Input.h"

#include "Core/Base/Error.h"
#include "Formats/FileText.h"
#include "Surfaces/StlText.h"
#include "Surfaces/VtkTriangles.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>

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

/// Throws where a binary .stl ends before its number of triangles. VTK's reader would return the
/// incomplete surface.
void RequireWholeStl(const std::string& file)
{
  constexpr std::size_t kCount = 80; // where it stands, behind the title
  constexpr std::uintmax_t kHeader = 84;
  constexpr std::uintmax_t kTriangle = 50;
  std::array<char, 512> bytes{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(bytes.data(), bytes.size());
  const std::string_view begin(bytes.data(), static_cast<std::size_t>(stream.gcount()));
  // A text has no such byte.
  if (begin.size() < kHeader || begin.find('\0') == std::string_view::npos)
  {
    return;
  }
  std::uintmax_t count = 0;
  for (std::size_t i = 4; i-- > 0;)
  {
    count = 256 * count + static_cast<unsigned char>(begin[kCount + i]);
  }
  const std::uintmax_t there = (std::filesystem::file_size(file) - kHeader) / kTriangle;
  if (there < count)
  {
    CannotRead(file,
      "it is cut short: it counts " + std::to_string(count) + " triangles and holds " +
        std::to_string(there));
  }
}

vtkSmartPointer<vtkPolyData> ReadStl(const std::string& file)
{
  RequireWholeStl(file);
  try
  {
    const auto text = ReadStlText(file);
    return text != nullptr ? text : ReadBy<vtkSTLReader>(file);
  }
  catch (const InvalidData& error)
  {
    CannotRead(file, error.what());
  }
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
  if (IsPipeOrDevice(file))
  {
    CannotRead(file, kPipeRemedy);
  }
  const vtkSmartPointer<vtkPolyData> surface =
    ending == ".vtp" ? ReadBy<vtkXMLPolyDataReader>(file) : ReadStl(file);
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
