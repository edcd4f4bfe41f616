// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/IsoSurface.h"

#include "Core/Base/Error.h"
#include "Core/Index/ValueIndex.h"
#include "Core/Location/Sample.h"
#include "Trace/Scene.h"
#include "Trace/Surfaces/Arguments.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <sstream>
#include <string>

namespace pixelexact
{
/// Those that may hold the value.
struct IsoSurface::Elements
{
  std::vector<CurvedPart> parts;
  std::vector<Box3> boxes;

  Elements(const ElementIndex& index, const CurvedEquation& equation);
};

namespace
{
CurvedEquation EquationOf(
  const ElementIndex& index, const Field& field, int component, double value)
{
  if (field.mapping != Mapping::Identity)
  {
    throw Unsupported("An iso-surface of field '" + field.name +
      "' is not available: it is an H(curl), H(div) or density field, whose values depend on the "
      "elements' Jacobian; choose another field");
  }
  const bool scalar = field.values.components == 1;
  const int which = component == kMagnitude && scalar ? 0 : component;
  if (which != kMagnitude && (which < 0 || which >= field.values.components))
  {
    Refuse("iso-surface",
      ("field '" + field.name + "' has no component " + std::to_string(component)).c_str());
  }
  if (!std::isfinite(value))
  {
    Refuse("iso-surface", "the value is not a finite number");
  }
  if (which == kMagnitude && !(value > 0.0))
  {
    Refuse("iso-surface",
      ("the magnitude of field '" + field.name +
        "' is zero at points and along lines alone, and never below; choose a positive value")
        .c_str());
  }
  return { index.GetMesh(), &field, which, value };
}
} // namespace

IsoSurface::Elements::Elements(const ElementIndex& index, const CurvedEquation& equation)
{
  const bool squares = equation.component == kMagnitude;
  const ValueIndex values(equation.mesh,
    { squares ? Quantity::Magnitude : Quantity::Component, equation.field, equation.component });
  std::vector<int> found;
  values.Find(Interval(equation.value), found);
  if (found.empty())
  {
    std::ostringstream why;
    why.precision(17);
    why << "field '" << equation.field->name << "' nowhere has the value " << equation.value
        << "; its values lie from " << values.Range().lower << " to " << values.Range().upper;
    Refuse("iso-surface", why.str().c_str());
  }
  for (const int element : found)
  {
    parts.push_back({ element, -1 });
    boxes.push_back(index.ElementBox(element));
  }
}

IsoSurface::IsoSurface(const ElementIndex& index, const Field& field, int component, double value)
  : IsoSurface(index, EquationOf(index, field, component, value),
      Elements(index, EquationOf(index, field, component, value)))
{
}

IsoSurface::IsoSurface(
  const ElementIndex& /*index*/, const CurvedEquation& equation, const Elements& elements)
  : CurvedSurface(equation, elements.parts, elements.boxes)
  , TheField(*equation.field)
{
}

Vec3 IsoSurface::Normal(const SurfacePoint& point) const
{
  const auto components = static_cast<std::size_t>(TheField.values.components);
  std::vector<double> value(components);
  std::vector<double> gradient(3 * components);
  EvaluateAt(Equation().mesh, TheField, point.element, std::span(&point.xi, 1), value, gradient);
  Vec3 normal(0.0);
  for (std::size_t c = 0; c < components; ++c)
  {
    const bool counts =
      Equation().component == kMagnitude || static_cast<int>(c) == Equation().component;
    const double weight = !counts          ? 0.0
      : Equation().component == kMagnitude ? value[c] / Equation().value
                                           : 1.0;
    normal += weight * Vec3(gradient[3 * c], gradient[3 * c + 1], gradient[3 * c + 2]);
  }
  const double size = LargestOf(normal);
  return size > 0.0 && std::isfinite(size) ? UnitDirection(normal / size) : Vec3(0.0);
}
} // namespace pixelexact
