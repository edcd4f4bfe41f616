// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/FaceChart.h"

#include "Core/Faces/FacePlane.h"
#include "Core/Shape/ShapeFace.h"

namespace pixelexact
{
FaceChart ChartOf(Shape shape, int face)
{
  const auto at = static_cast<std::size_t>(face);
  const FacePlane& plane = FacePlanesOf(shape)[at];
  FaceChart chart;
  chart.across = FacesOf(shape)[at].direction;
  chart.free = { chart.across == 0 ? 1 : 0, chart.across == 2 ? 1 : 2 };
  const double across = plane.gradient[chart.across];
  chart.constant = -plane.constant / across;
  for (std::size_t j = 0; j < 2; ++j)
  {
    chart.along[j] = 0.0 - plane.gradient[chart.free[j]] / across;
  }
  switch (shape)
  {
    case Shape::Hexahedron:
      break;
    case Shape::Prism:
      chart.collapses = chart.across == 1;
      break;
    case Shape::Tetrahedron:
      chart.collapses = true;
      break;
    default:
      chart.collapses = chart.across != 2;
  }
  return chart;
}
} // namespace pixelexact
