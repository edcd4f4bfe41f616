// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/SolverModel.h"

#include <algorithm>
#include <utility>

namespace pixelexact
{
namespace
{
struct Range
{
  std::size_t begin = 0;
  std::size_t end = 0;
};

Range RangeOf(const PieceOf& part, std::size_t elements)
{
  const auto [begin, end] = part.Of(static_cast<std::int64_t>(elements));
  return { static_cast<std::size_t>(begin), static_cast<std::size_t>(end) };
}

/// `stride` entries for each element; an empty list stays empty.
template <class T>
void Keep(const Range& range, std::vector<T>& values, std::size_t stride = 1)
{
  if (!values.empty())
  {
    values.resize(range.end * stride);
    values.erase(
      values.begin(), values.begin() + static_cast<std::ptrdiff_t>(range.begin * stride));
    values.shrink_to_fit();
  }
}

void Keep(const Range& range, OwnedExpansion& expansion)
{
  OwnedExpansion kept;
  kept.spaces = expansion.spaces;
  kept.spaceOf = expansion.spaceOf;
  kept.components = expansion.components;
  Keep(range, kept.spaceOf);
  kept.Allocate();
  for (std::size_t e = 0; e < kept.spaceOf.size(); ++e)
  {
    std::ranges::copy(expansion.Coefficients(range.begin + e), kept.Coefficients(e).begin());
  }
  expansion = std::move(kept);
}

void Keep(const Range& range, SolverMesh& mesh)
{
  Keep(range, mesh.map);
  Keep(range, mesh.centre, 3);
  Keep(range, mesh.size);
  Keep(range, mesh.uncertainty);
  Keep(range, mesh.number);
  Keep(range, mesh.corners);
  Keep(range, mesh.attribute);
  std::erase_if(mesh.boundary,
    [&range](const BoundaryFace& face)
    {
      const auto element = static_cast<std::size_t>(face.element);
      return element < range.begin || element >= range.end;
    });
  for (BoundaryFace& face : mesh.boundary)
  {
    face.element -= static_cast<std::int32_t>(range.begin);
  }
}
} // namespace

void KeepPiece(const PieceOf& part, SolverModel& model)
{
  if (part.IsWhole())
  {
    return;
  }
  if (!model.mesh.number.empty())
  {
    Keep(RangeOf(part, model.mesh.number.size()), model.mesh);
  }
  for (SolverField& field : model.fields)
  {
    Keep(RangeOf(part, field.values.spaceOf.size()), field.values);
  }
}
} // namespace pixelexact
