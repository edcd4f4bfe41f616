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
CurvedEquation IsoEquation(const Mesh& mesh, const Field& field, int component, double value)
{
  RequirePolynomials(field, "walls of iso-surfaces");
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
  return { mesh, &field, which, value };
}

/// The elements that may take the value.
struct IsoSurface::Elements
{
  std::vector<CurvedPart> parts;
  std::vector<Box3> boxes;

  Elements(const ElementIndex& index, const CurvedEquation& equation, bool mayBeEmpty);
};

IsoSurface::Elements::Elements(
  const ElementIndex& index, const CurvedEquation& equation, bool mayBeEmpty)
{
  const bool squares = equation.component == kMagnitude;
  const ValueIndex values(equation.mesh,
    { squares ? Quantity::Magnitude : Quantity::Component, equation.field, equation.component });
  std::vector<int> found;
  values.Find(Interval(equation.value), found);
  if (found.empty() && !mayBeEmpty)
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

IsoSurface::IsoSurface(
  const ElementIndex& index, const Field& field, int component, double value, bool mayBeEmpty)
  : IsoSurface(index, IsoEquation(index.GetMesh(), field, component, value),
      Elements(index, IsoEquation(index.GetMesh(), field, component, value), mayBeEmpty))
{
}

IsoSurface::IsoSurface(
  const ElementIndex& index, const CurvedEquation& equation, const Elements& elements)
  : CurvedSurface(equation, elements.parts, elements.boxes)
  , field_(*equation.field)
  , Chords(index, equation, elements.parts)
{
}

std::optional<double> IsoSurface::HeldValue(const Field& field, int component) const
{
  const bool isOwn =
    &field == &field_ && (field.values.components == 1 || component == Equation().component);
  return isOwn ? std::optional(Equation().value) : std::nullopt;
}

void IsoSurface::NormalsOf(
  std::int32_t part, std::span<const Vec3> xi, std::span<Vec3> normals) const
{
  const auto components = static_cast<std::size_t>(field_.values.components);
  const bool squares = Equation().component == kMagnitude;
  std::vector<double> values(components * xi.size());
  std::vector<double> gradients(3 * values.size());
  EvaluateAt(Equation().mesh, field_, PartOf(part).element, xi, values, gradients);
  for (std::size_t i = 0; i < xi.size(); ++i)
  {
    Vec3 normal(0.0);
    for (std::size_t c = 0; c < components; ++c)
    {
      const double* gradient = &gradients[3 * (i * components + c)];
      const double weight = squares ? values[i * components + c] / Equation().value
        : static_cast<int>(c) == Equation().component ? 1.0
                                                      : 0.0;
      normal += weight * Vec3(gradient[0], gradient[1], gradient[2]);
    }
    normals[i] = UnitOrZero(normal);
  }
}
} // namespace pixelexact
