// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/Mesh.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pixelexact
{
namespace
{
[[noreturn]] void Fail(const std::string& what, int element, const std::string& problem)
{
  throw InvalidData(what + ", element " + std::to_string(element) + ": " + problem +
    ". The arrays do not belong together; convert the data set again from its source.");
}

void RequireSize(const std::string& what, std::size_t actual, std::size_t expected)
{
  if (actual != expected)
  {
    throw InvalidData(what + " has " + std::to_string(actual) + " values where " +
      std::to_string(expected) + " are needed; convert the data set again from its source.");
  }
}

/// Only a vector can be mapped like one.
void RequireComponents(const std::string& what, const Field& field)
{
  switch (field.mapping)
  {
    case Mapping::Identity:
    case Mapping::Density:
      return;
    case Mapping::Covariant:
    case Mapping::Contravariant:
      if (field.values.components != 3)
      {
        throw InvalidData(what + " has " + std::to_string(field.values.components) +
          " components, but its mapping is one of vectors, which have 3; convert the data set "
          "again "
          "from its source.");
      }
      return;
  }
  throw InvalidData(what + " has the unknown mapping " +
    std::to_string(static_cast<int>(field.mapping)) +
    "; convert the data set again from its source.");
}
} // namespace

void Validate(const Expansion& expansion, const std::string& what)
{
  const auto count = expansion.spaceOf.size();
  RequireSize(what + " offsets", expansion.offset.size(), count);
  if (expansion.components < 1)
  {
    throw InvalidData(what + " has no components; convert the data set again from its source.");
  }
  for (const auto& space : expansion.spaces)
  {
    if (!space.IsValid())
    {
      throw InvalidData(what + " names a polynomial space that does not exist (shape " +
        std::to_string(static_cast<int>(space.shape)) + ", orders " +
        std::to_string(space.order[0]) + "," + std::to_string(space.order[1]) + "," +
        std::to_string(space.order[2]) + "); convert the data set again from its source.");
    }
  }
  std::vector<std::int64_t> length(expansion.spaces.size());
  std::ranges::transform(expansion.spaces, length.begin(),
    [&](const Space& space)
    { return static_cast<std::int64_t>(space.Modes()) * expansion.components; });
  const auto available = static_cast<std::int64_t>(expansion.coefficients.size());
  for (std::size_t e = 0; e < count; ++e)
  {
    const auto space = expansion.spaceOf[e];
    if (space < 0 || space >= static_cast<std::int64_t>(expansion.spaces.size()))
    {
      Fail(what, static_cast<int>(e), "space index " + std::to_string(space) + " is out of range");
    }
    const auto offset = expansion.offset[e];
    if (offset < 0 || offset > available - length[space])
    {
      Fail(what, static_cast<int>(e),
        "coefficients " + std::to_string(offset) + " to " + std::to_string(offset + length[space]) +
          " lie outside the array of " + std::to_string(available));
    }
  }
}

void Validate(const Mesh& mesh)
{
  Validate(mesh.map, "mesh");
  const auto count = mesh.map.spaceOf.size();
  if (mesh.map.components != 3)
  {
    throw InvalidData("mesh coefficients have " + std::to_string(mesh.map.components) +
      " components, not 3; convert the data set again from its source.");
  }
  RequireSize("mesh centres", mesh.centre.size(), 3 * count);
  RequireSize("mesh sizes", mesh.size.size(), count);
  RequireSize("mesh uncertainties", mesh.uncertainty.size(), count);
  const auto finite = [](double v) { return std::isfinite(v); };
  for (std::size_t e = 0; e < count; ++e)
  {
    const int element = static_cast<int>(e);
    if (!(mesh.size[e] > 0.0) || !finite(mesh.size[e]) || !(mesh.uncertainty[e] >= 0.0) ||
      !std::ranges::all_of(mesh.centre.subspan(3 * e, 3), finite))
    {
      Fail("mesh", element, "its centre, size or uncertainty is not a finite number");
    }
    const std::span<const double> coefficients(mesh.map.Coefficients(element),
      3 * static_cast<std::size_t>(mesh.map.SpaceOf(element).Modes()));
    if (!std::ranges::all_of(coefficients, finite))
    {
      Fail("mesh", element, "a coordinate coefficient is NaN or infinite");
    }
  }
}

void Validate(const Field& field, const Mesh& mesh)
{
  const std::string what = "field '" + field.name + "'";
  Validate(field.values, what);
  RequireComponents(what, field);
  RequireSize(what + " elements", field.values.spaceOf.size(), mesh.map.spaceOf.size());
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    if (field.values.SpaceOf(e).shape != mesh.ShapeOf(e))
    {
      Fail(what, e,
        std::string("a ") + Name(field.values.SpaceOf(e).shape) + "'s space on a " +
          Name(mesh.ShapeOf(e)));
    }
  }
}

void RequirePolynomials(const Field& field, const std::string& what)
{
  if (field.function != nullptr)
  {
    throw Unsupported(what + " are not available for expressions such as '" + field.name +
      "', which are evaluated at points; choose a field of the data.");
  }
}
} // namespace pixelexact
