// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Faces/AttributedFace.h"

#include "Core/Base/Error.h"

#include <string>

namespace pixelexact
{
namespace
{
[[noreturn]] void Refuse(std::span<const AttributedFace> faces, std::int32_t attribute)
{
  const std::string what = "there is no boundary attribute " + std::to_string(attribute);
  const auto counts = CountByAttribute(faces);
  if (counts.empty())
  {
    throw InvalidData(what +
      ": the input lists none. Solvers' own files do (MFEM's boundary elements, Nektar++'s "
      "composites of faces); of this one ask for the whole boundary.");
  }
  std::string listed;
  for (const auto& [known, count] : counts)
  {
    listed += (listed.empty() ? "" : ", ") + std::to_string(known);
  }
  throw InvalidData(what + "; the input has: " + listed + ".");
}
} // namespace

std::map<std::int32_t, std::int64_t> CountByAttribute(std::span<const AttributedFace> faces)
{
  std::map<std::int32_t, std::int64_t> counts;
  for (const AttributedFace& face : faces)
  {
    ++counts[face.attribute];
  }
  return counts;
}

std::vector<ElementFace> FacesOfAttribute(
  std::span<const AttributedFace> faces, std::int32_t attribute)
{
  std::vector<ElementFace> found;
  for (const AttributedFace& face : faces)
  {
    if (face.attribute == attribute)
    {
      found.push_back(face.face);
    }
  }
  if (found.empty())
  {
    Refuse(faces, attribute);
  }
  return found;
}
} // namespace pixelexact
