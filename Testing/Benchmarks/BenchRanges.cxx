// SPDX-License-Identifier: BSD-3-Clause
// Certified ranges: how the bound of the conversion's rounding grows with the order, and what an
// enclosure costs. Prints tables in Markdown.
#include "../Core/RangeCases.h"

#include "Core/Basis/ModeBound.h"
#include "Core/Bernstein/PieceForm.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace pixelexact::testing
{
namespace
{
Space SpaceFor(Shape shape, int order)
{
  return UniformSpace(shape, order);
}

/// Random modes whose contributions decrease by `decay` with each total degree; the largest is 1.
std::vector<double> Modes(const Space& space, double decay, Random& random)
{
  std::vector<double> modes;
  ForEachMode(space,
    [&](int p, int q, int r, int)
    { modes.push_back(random() * std::pow(decay, p + q + r) / ModeBound(space, p, q, r)); });
  return modes;
}

/// The bound over the largest value that the function may take by its modes, worst piece.
double Growth(const PieceForm& form, Part part, const std::vector<double>& modes, double largest)
{
  double worst = 0.0;
  const int pieces = 1 << form.Level();
  for (int i = 0; i < pieces * pieces * pieces; ++i)
  {
    worst = std::max(worst,
      form.ErrorBound(
        part, { i / (pieces * pieces), i / pieces % pieces, i % pieces }, modes.data()));
  }
  return worst / largest;
}

void PrintGrowth()
{
  std::printf(
    "| shape | order | pieces | equal modes: cube | pieces | decaying modes: cube | pieces "
    "| derivative, decaying: pieces |\n|---|---|---|---|---|---|---|---|\n");
  for (const Shape shape : kShapes)
  {
    for (const int order : { 1, 2, 4, 8, 16, 32 })
    {
      const Space space = SpaceFor(shape, order);
      const PieceForm& cube = PieceForm::Of(space, 0);
      const PieceForm& pieces = PieceForm::Of(space);
      Random random(5);
      double bound[5];
      int k = 0;
      for (const double decay : { 1.0, 0.5 })
      {
        const auto modes = Modes(space, decay, random);
        // Sum of |c| max |mode|: no smaller bound of the values is known without a search.
        double largest = 0.0;
        ForEachMode(space,
          [&](int p, int q, int r, int mode)
          {
            largest = std::max(largest,
              std::fabs(modes[static_cast<std::size_t>(mode)]) * ModeBound(space, p, q, r));
          });
        bound[k++] = Growth(cube, Part::Value, modes, largest);
        bound[k++] = Growth(pieces, Part::Value, modes, largest);
        bound[4] = Growth(pieces, Part::ByXi1, modes, largest);
      }
      std::printf("| %s | %d | %d | %.1e | %.1e | %.1e | %.1e | %.1e |\n", Name(shape), order,
        1 << pieces.Level(), bound[0], bound[1], bound[2], bound[3], bound[4]);
    }
  }
}

/// A curved element with a field of decaying modes.
RangeCase MakeCase(Shape shape, int order)
{
  Random random(7);
  RangeCase one(UniformSpace(shape, 3),
    [](const LongVec3& xi)
    {
      const auto [x, y, z] = xi;
      return LongVec3{ x + y * y / 20, y + z * x / 20, z + x * y / 20 };
    });
  const Space space = SpaceFor(shape, order);
  one.SetField(space, Modes(space, 0.6, random));
  return one;
}

void PrintCosts()
{
  std::printf("\n| shape | order | quantity | tolerance | boxes | ms | excess / range |\n"
              "|---|---|---|---|---|---|---|\n");
  const std::pair<const char*, Quantity> quantities[] = { { "value", Quantity::Component },
    { "gradient, norm", Quantity::GradientMagnitude }, { "det J", Quantity::Jacobian } };
  for (const Shape shape : kShapes)
  {
    for (const int order : { 3, 6, 12 })
    {
      const RangeCase one = MakeCase(shape, order);
      for (const auto& [name, quantity] : quantities)
      {
        if (quantity == Quantity::Jacobian && order != 3)
        {
          continue;
        }
        for (const double tolerance : { 1e-2, 1e-4, 1e-6 })
        {
          const RangeQuestion question{ quantity, &one.field };
          const auto start = std::chrono::steady_clock::now();
          const CertifiedRange range = RangeOf(one.mesh, 0, question, { tolerance, 200000 });
          const double ms =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
              .count();
          const double width = range.attained.upper - range.attained.lower;
          std::printf("| %s | %d | %s | %.0e%s | %d | %.2g | %.1e |\n", Name(shape), order, name,
            tolerance, range.met ? "" : " (not met)", range.boxes, ms,
            std::max(range.GapBelow(), range.GapAbove()) / width);
        }
      }
    }
  }
}
} // namespace
} // namespace pixelexact::testing

int main()
{
  pixelexact::testing::PrintGrowth();
  pixelexact::testing::PrintCosts();
}
