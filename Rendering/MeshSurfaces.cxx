// SPDX-License-Identifier: BSD-3-Clause
#include "MeshSurfaces.h"

#include "FieldChoice.h"
#include "FieldRange.h"
#include "HighOrderModel.h"

#include "Core/Base/Error.h"
#include "Core/Element/MeshRanges.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace pixelexact
{
namespace
{
void RequireElements(const HighOrderModel& model, const std::vector<std::int64_t>& elements)
{
  std::vector<std::int64_t> there(model.SourceCells().begin(), model.SourceCells().end());
  std::ranges::sort(there);
  for (const std::int64_t element : elements)
  {
    if (!std::ranges::binary_search(there, element))
    {
      throw Error("the mesh has no element " + std::to_string(element) +
        (there.empty() ? "; it has none at all"
                       : "; its elements are numbered from " + std::to_string(there.front()) +
              " to " + std::to_string(there.back())));
    }
  }
}

/// Such as "component 1 of field 'v'".
std::string NameOf(const Field& field, int component)
{
  std::string name = "field '" + field.name + "'";
  if (field.values.components == 1)
  {
    return name;
  }
  return component == kMagnitude ? "the magnitude of " + name
                                 : "component " + std::to_string(component) + " of " + name;
}

/// As few digits as tell it from others.
std::string Digits(double number)
{
  std::array<char, 32> text{};
  return { text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr };
}

void RequireValue(const HighOrderModel& model, const Field& field, int component, double value)
{
  const Interval range = ProvenRange(model.GetMesh(), field, component);
  if (range.lower <= value && value <= range.upper)
  {
    return;
  }
  throw Error("iso-surface: " + NameOf(field, component) +
    (range.IsEmpty() ? " has no finite value; choose another field"
                     : " has values from " + Digits(range.lower) + " to " + Digits(range.upper) +
          ", and " + Digits(value) + " is none of them; choose a value between"));
}
} // namespace

std::shared_ptr<const Surface> MakeBoundary(
  const std::shared_ptr<const HighOrderModel>& model, const BoundaryChoice& choice)
{
  RequireElements(*model, choice.elements);
  throw Unsupported("faces of elements are not available yet; cut by a function or triangles");
}

std::shared_ptr<const Surface> MakeIsoSurface(
  const std::shared_ptr<const HighOrderModel>& model, const IsoChoice& choice)
{
  if (!std::isfinite(choice.value))
  {
    throw Error("iso-surface: the value is not finite; choose a number");
  }
  if (model->Fields().empty())
  {
    throw Error("iso-surface: the mesh carries no field; choose another surface");
  }
  const Field& field = FieldChoice{ .name = choice.field }.In(*model);
  RequireComponent(field, choice.component);
  RequireValue(*model, field, choice.component, choice.value);
  throw Unsupported("iso-surfaces are not available yet; cut by a function or triangles");
}
} // namespace pixelexact
