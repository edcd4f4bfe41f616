// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/MeshSurfaceOptions.h"

#include "Base/Numbers.h"
#include "Base/Options.h"
#include "Scene/LayerOptions.h"
#include "Scene/Model.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pixelexact
{
namespace
{
constexpr const char* kMeshForm = "all, ATTRIBUTE,... or element:NUMBER,...";

template <class Number>
std::vector<Number> ParseNumbers(const std::string& text, const std::string& list)
{
  std::vector<Number> numbers;
  for (const std::string& part : SplitAt(list, ','))
  {
    int number = 0;
    if (!ParseInteger(part, number) || number < 0)
    {
      Refuse("--boundary", text, std::string(kMeshForm) + ", with whole numbers from 0");
    }
    numbers.push_back(number);
  }
  return numbers;
}
} // namespace

BoundaryChoice ParseBoundary(const std::string& text)
{
  constexpr std::string_view kElement = "element:";
  BoundaryChoice choice;
  if (text.starts_with(kElement))
  {
    choice.elements = ParseNumbers<std::int64_t>(text, text.substr(kElement.size()));
  }
  else if (text != "all")
  {
    choice.attributes = ParseNumbers<int>(text, text);
  }
  return choice;
}

IsoText ParseIso(const std::string& text)
{
  const auto equal = text.rfind('=');
  IsoText iso;
  if (equal == std::string::npos || equal == 0 ||
    !ParseNumber(std::string_view(text).substr(equal + 1), iso.value) || !std::isfinite(iso.value))
  {
    Refuse("--isosurface", text,
      "FIELD=VALUE, FIELD.magnitude=VALUE or FIELD.COMPONENT=VALUE with a finite value");
  }
  iso.name = text.substr(0, equal);
  return iso;
}

IsoChoice Resolve(const IsoText& text, const HighOrderModel& model)
{
  const auto isOfPolynomials = [&model](const std::string& name)
  { return std::ranges::find(model.Fields(), name, &Field::name) != model.Fields().end(); };
  const auto dot = text.name.rfind('.');
  if (!isOfPolynomials(text.name) && dot != std::string::npos)
  {
    // A component of a field is proven, which one of an expression is not.
    const std::string name = text.name.substr(0, dot);
    const std::optional<int> component = ParseComponent(text.name.substr(dot + 1));
    if (component && isOfPolynomials(name))
    {
      return { name, *component, text.value };
    }
  }
  return { model.GetField(text.name).name, kMagnitude, text.value };
}
} // namespace pixelexact
