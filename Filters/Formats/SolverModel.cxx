// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/SolverModel.h"

#include <algorithm>

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

void Keep(const Range& range, SolverExpansion& expansion)
{
  Keep(range, expansion.spaceOf);
  Keep(range, expansion.offset);
  const auto valuesOf = [&expansion](std::size_t e)
  {
    const Space& space = expansion.spaces[static_cast<std::size_t>(expansion.spaceOf[e])];
    return static_cast<std::size_t>(space.Modes()) * static_cast<std::size_t>(expansion.components);
  };
  std::size_t total = 0;
  for (std::size_t e = 0; e < expansion.spaceOf.size(); ++e)
  {
    total += valuesOf(e);
  }
  CoefficientBlock kept{ std::make_unique<double[]>(total), total };
  std::size_t next = 0;
  for (std::size_t e = 0; e < expansion.spaceOf.size(); ++e)
  {
    std::copy_n(
      expansion.coefficients.data.get() + expansion.offset[e], valuesOf(e), kept.data.get() + next);
    expansion.offset[e] = static_cast<std::int64_t>(next);
    next += valuesOf(e);
  }
  expansion.coefficients = std::move(kept);
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
