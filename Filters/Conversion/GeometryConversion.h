// SPDX-License-Identifier: BSD-3-Clause
#ifndef GeometryConversion_h
#define GeometryConversion_h

#include "Conversion/SourceMesh.h"

namespace pixelexact
{
/// The map of one element, in units of its size.
struct ElementGeometry
{
  Space space;
  std::vector<double> coefficients; ///< three components, one after the other
  std::array<double, 3> centre{};
  double size = 1.0;
  double uncertainty = 0.0; ///< world units
};

/// The map of an element from its nodes, without trailing orders that are but the rounding of the
/// file's coordinates (isoparametric files store geometry of order 3 at the field's order 6).
/// Throws InvalidData where the element is too large for doubles.
ElementGeometry ConvertGeometry(const SourceMesh& mesh, int element);

/// The largest possible number of coefficients of an element's map.
std::size_t MostCoefficients(const SourceMesh& mesh, int element);
} // namespace pixelexact
#endif
