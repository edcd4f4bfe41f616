// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Geometry/Transform.h"

#include "Core/Base/Error.h"
#include "Core/Base/ParseWhole.h"
#include "Formats/Nektar/Files/Expression.h"

#include <cmath>

namespace pixelexact::nektar
{
namespace
{
double ReadExpression(const Document& document, const pugi::xml_node& node,
  const std::string& attribute, double usual, const Parameters& parameters)
{
  const pugi::xml_attribute text = node.attribute(attribute.c_str());
  if (!text)
  {
    return usual;
  }
  try
  {
    return Evaluate(
      WithoutBlanks(text.value()), [&](std::string_view name) { return parameters.Find(name); });
  }
  catch (const InvalidData& error)
  {
    document.Fail(node,
      attribute + "=\"" + std::string(text.value()).substr(0, 60) +
        "\" is no expression that has a value: " + error.what() + ".");
  }
}
} // namespace

Point Transform::operator()(Point x) const
{
  for (int d = 0; d < 3; ++d)
  {
    x[d] = x[d] * scale[d] + move[d];
  }
  if (angle != 0.0)
  {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    x = { x[0] * c - x[1] * s, x[0] * s + x[1] * c, x[2] };
  }
  return x;
}

Transform ReadTransform(
  const Document& document, const pugi::xml_node& vertices, const Parameters& parameters)
{
  Transform transform;
  for (int d = 0; d < 3; ++d)
  {
    const std::string axis(1, "XYZ"[d]);
    transform.scale[d] = ReadExpression(document, vertices, axis + "SCALE", 1.0, parameters);
    transform.move[d] = ReadExpression(document, vertices, axis + "MOVE", 0.0, parameters);
  }
  transform.angle = ReadExpression(document, vertices, "ZROT", 0.0, parameters);
  return transform;
}
} // namespace pixelexact::nektar
