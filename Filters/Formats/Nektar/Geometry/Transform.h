// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Nektar/Files/Conditions.h"
#include "Formats/Nektar/Files/Document.h"

#include <array>

namespace pixelexact::nektar
{
using Point = std::array<double, 3>;

/// What is done to each point of a geometry, vertices' and curves': first scaled, then moved, then
/// turned about the z axis.
struct Transform
{
  Point scale{ 1.0, 1.0, 1.0 };
  Point move{};
  double angle = 0.0; ///< in radians

  [[nodiscard]] Point operator()(Point x) const;
  bool operator==(const Transform&) const = default;
};

/// The attributes XSCALE, YSCALE, ZSCALE, XMOVE, YMOVE, ZMOVE and ZROT of a VERTEX element:
/// expressions of the session's parameters. Throws InvalidData for what is none.
Transform ReadTransform(
  const Document& document, const pugi::xml_node& vertices, const Parameters& parameters);
} // namespace pixelexact::nektar
