// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/IsoEquation.h"

#include "Core/Base/Error.h"
#include "Trace/Scene.h"
#include "Trace/Surfaces/Arguments.h"

#include <cmath>
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
} // namespace pixelexact
