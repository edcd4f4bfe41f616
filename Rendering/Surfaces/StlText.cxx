// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/StlText.h"

#include "Core/Base/Error.h"
#include "Core/Base/ParseWhole.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <array>
#include <cctype>
#include <fstream>
#include <sstream>
#include <string_view>

namespace pixelexact
{
namespace
{
/// The next word, in lower case; empty at the end.
std::string NextWord(std::istream& text)
{
  std::string word;
  text >> word;
  for (char& c : word)
  {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return word;
}

bool IsText(std::istream& stream)
{
  std::array<char, 512> begin{};
  stream.read(begin.data(), begin.size());
  const std::string_view read(begin.data(), static_cast<std::size_t>(stream.gcount()));
  stream.clear();
  stream.seekg(0);
  std::istringstream first{ std::string(read) };
  return read.find('\0') == std::string_view::npos && NextWord(first) == "solid";
}

std::array<double, 3> ReadCorner(std::istream& text)
{
  std::array<double, 3> corner{};
  for (double& coordinate : corner)
  {
    const std::string word = NextWord(text);
    if (!ParseWhole(word, coordinate))
    {
      throw InvalidData("'" + word + "' is no coordinate; the file is damaged or cut short");
    }
  }
  return corner;
}
} // namespace

vtkSmartPointer<vtkPolyData> ReadStlText(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  if (!stream || !IsText(stream))
  {
    return nullptr;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  std::string line;
  while (std::getline(stream, line))
  {
    std::istringstream words(line);
    std::string word = NextWord(words);
    const bool isName = word == "solid" || word == "endsolid"; // any words follow
    for (; !word.empty() && !isName; word = NextWord(words))
    {
      if (word == "vertex")
      {
        points->InsertNextPoint(ReadCorner(words).data());
      }
    }
  }
  if (points->GetNumberOfPoints() % 3 != 0)
  {
    throw InvalidData("it ends within a triangle; the file is damaged or cut short");
  }
  for (vtkIdType first = 0; first < points->GetNumberOfPoints(); first += 3)
  {
    const std::array<vtkIdType, 3> corners{ first, first + 1, first + 2 };
    triangles->InsertNextCell(3, corners.data());
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  return surface;
}
} // namespace pixelexact
