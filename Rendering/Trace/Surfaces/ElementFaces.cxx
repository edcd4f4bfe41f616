// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/ElementFaces.h"

#include "Core/Shape/ShapeFace.h"
#include "Trace/Surfaces/Arguments.h"
#include "Trace/Surfaces/Curved/HitsBehind.h"

#include <string>
#include <utility>

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
  , faces_(faces.begin(), faces.end())
  , Chords(index, Equation(), AllParts())
{
}

ElementFaces::ElementFaces(
  const Locator& locator, std::span<const ElementFace> faces, std::vector<bool> partly)
  : ElementFaces(locator.Index(), faces)
{
  if (partly.size() != faces.size())
  {
    Refuse("element faces", "give one `partly` flag for each face");
  }
  Behind = &locator;
  Partly = std::move(partly);
}

void ElementFaces::Review(
  const CurvedPart& part, std::vector<CurvedHit>& hits, std::size_t first) const
{
  if (Behind == nullptr || !IsPartly(hits[first].part))
  {
    return;
  }
  const std::vector<BehindFace> behind = HitsBehind(*Behind, part, hits, first);
  std::size_t kept = first;
  for (std::size_t k = first; k < hits.size(); ++k)
  {
    const Verdict covered = behind[k - first].verdict;
    if (covered != Verdict::Inside)
    {
      hits[kept] = hits[k];
      hits[kept].status = covered == Verdict::Unknown ? HitStatus::Undecided : hits[k].status;
      ++kept;
    }
  }
  hits.resize(kept);
}
} // namespace pixelexact
