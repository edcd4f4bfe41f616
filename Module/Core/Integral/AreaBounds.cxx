// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/AreaBounds.h"

#include "Core/Bernstein/BoxAlgebra.h"
#include "Core/Integral/BoxRanges.h"
#include "Core/Integral/IntegralCut.h"

namespace pixelexact
{
namespace
{
/// Bounds all quantities over a box that contains at most this area of the surface.
Sums BoundsOfArea(ElementFunctions& functions, const PieceBox& box, double area)
{
  const IntegralQuestion& question = functions.Question();
  Sums sums(question.Quantities());
  sums[0] = Interval(0.0, area);
  Interval largest = 0.0;
  for (int c = 0; c < question.Components(); ++c)
  {
    const Interval value = FieldRange(functions, box, c);
    sums[static_cast<std::size_t>(c) + 1] = value * sums[0];
    largest += Square(value);
  }
  if (question.HasFlux())
  {
    const double flux = (Sqrt(largest) * Interval(area)).upper;
    sums.back() = Interval(-flux, flux);
  }
  return sums;
}
} // namespace

Sums BoundIn(ElementFunctions& functions, const PieceBox& box)
{
  return BoundsOfArea(functions, box, functions.Question().cut->AreaIn(functions, box));
}

Sums BoundOn(ElementFunctions& functions, const CutGraph& graph)
{
  const Interval slope = Derivative(functions.Cut(graph.box), graph.axes[2]).Hull();
  // The collapse of the shape is at most 1.
  Interval area = functions.Question().cut->Stretch(functions, graph.box) *
    Interval(functions.Unit()) / Abs(slope);
  for (int d = 0; d < 3; ++d)
  {
    area *= Interval(2.0) * functions.HalfWidth(graph.box, d);
  }
  return BoundsOfArea(functions, graph.box, area.upper);
}
} // namespace pixelexact
