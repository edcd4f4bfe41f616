// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/ElementFaces.h"

#include "Core/Questions/Questions.h"
#include "Trace/Surfaces/Arguments.h"
#include "Trace/Surfaces/Curved/FaceNormals.h"

#include <string>

namespace pixelexact
{
namespace
{
std::vector<CurvedPart> PartsOf(const Mesh& mesh, std::span<const ElementFace> faces)
{
  if (faces.empty())
  {
    Refuse("element faces", "there are none");
  }
  std::vector<CurvedPart> parts;
  for (const ElementFace& one : faces)
  {
    if (one.element < 0 || one.element >= mesh.Elements() || one.face < 0 ||
      one.face >= static_cast<int>(FacesOf(mesh.ShapeOf(one.element)).size()))
    {
      Refuse("element faces",
        ("there is no face " + std::to_string(one.face) + " of element " +
          std::to_string(one.element))
          .c_str());
    }
    parts.push_back({ one.element, one.face });
  }
  return parts;
}

std::vector<Box3> BoxesOf(const ElementIndex& index, std::span<const ElementFace> faces)
{
  std::vector<Box3> boxes;
  for (const ElementFace& one : faces)
  {
    boxes.push_back(index.ElementBox(one.element));
  }
  return boxes;
}
} // namespace

ElementFaces::ElementFaces(const ElementIndex& index, std::span<const ElementFace> faces)
  : CurvedSurface({ index.GetMesh() }, PartsOf(index.GetMesh(), faces), BoxesOf(index, faces))
  , TheFaces(faces.begin(), faces.end())
  , Chords(index, Equation(), AllParts())
{
}

void ElementFaces::NormalsOf(
  const CurvedPart& part, std::span<const Vec3> xi, std::span<Vec3> normals) const
{
  FaceNormals(Equation().mesh, part, xi, normals);
}
} // namespace pixelexact
