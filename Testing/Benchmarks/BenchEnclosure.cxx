// SPDX-License-Identifier: BSD-3-Clause
// Value enclosures: how wide they are against the true error of the plain value, which is measured
// in 113 bits, and what they cost. Prints tables in Markdown.
#include "../Core/EnclosureCases.h"

#include <chrono>
#include <cmath>
#include <cstdio>

namespace pixelexact::testing
{
namespace
{
const char* Title(Shape shape, Form form)
{
  return form == Form::Tensor ? "pyramid, Tensor" : Name(shape);
}

/// Calls `visit(shape, form)` for all that there are.
template <class Visit>
void ForEachForm(Visit&& visit)
{
  for (const Shape shape : kShapes)
  {
    visit(shape, Form::Collapsed);
  }
  visit(Shape::Pyramid, Form::Tensor);
}

EnclosureCase CaseOf(Shape shape, Form form, int order)
{
  EnclosureCase c;
  c.shape = shape;
  c.form = form;
  c.fieldOrder = order;
  return c;
}

double Quantile(std::vector<double>& sorted, double share)
{
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

double Ulp(double value)
{
  return std::nextafter(std::fabs(value), INFINITY) - std::fabs(value);
}

struct Widths
{
  std::vector<double> toError; ///< width / max(error of the plain value, its ulp)
  std::vector<double> toRange; ///< width / range of the values
  int plainOutside = 0;        ///< plain values that the interval does not hold
  int lost = 0;                ///< truths that it does not hold: a defect
};

void MeasureWidths(const EnclosureCase& c, int points, Random& random, Widths& widths)
{
  const EnclosureElement element(c, random);
  const auto enclosed = EnclosePoints(element, points, 0.0, random);
  double low = INFINITY;
  double high = -INFINITY;
  for (const auto& point : enclosed)
  {
    low = std::min(low, point.plain[0]);
    high = std::max(high, point.plain[0]);
  }
  for (const auto& point : enclosed)
  {
    const Interval& interval = point.interval[0];
    const double error = std::fabs(static_cast<double>(Quad(point.plain[0]) - point.truth[0]));
    widths.toError.push_back(interval.Width() / std::max(error, Ulp(point.plain[0])));
    widths.toRange.push_back(interval.Width() / (high - low));
    widths.plainOutside += interval.Contains(point.plain[0]) ? 0 : 1;
    widths.lost += Holds(interval, point.truth[0]) ? 0 : 1;
  }
}

void PrintWidths()
{
  std::printf("| shape | order | median | 90 %% | max | width / range: median | max | plain value "
              "outside | truth outside |\n|---|---|---|---|---|---|---|---|---|\n");
  Random random(7);
  ForEachForm(
    [&](Shape shape, Form form)
    {
      for (const int order : { 1, 2, 3, 4, 6, 8, 12, 16 })
      {
        Widths widths;
        for (int element = 0; element < 8; ++element)
        {
          MeasureWidths(CaseOf(shape, form, order), 125, random, widths);
        }
        std::ranges::sort(widths.toError);
        std::ranges::sort(widths.toRange);
        std::printf("| %s | %d | %.1f | %.1f | %.0f | %.1e | %.1e | %.1f %% | %d |\n",
          Title(shape, form), order, Quantile(widths.toError, 0.5), Quantile(widths.toError, 0.9),
          widths.toError.back(), Quantile(widths.toRange, 0.5), widths.toRange.back(),
          0.1 * widths.plainOutside, widths.lost);
      }
    });
}

/// Nanoseconds per point of the fastest of several runs.
template <class Run>
double Nanoseconds(std::size_t points, Run&& run)
{
  double best = INFINITY;
  for (int repeat = 0; repeat < 15; ++repeat)
  {
    const auto begin = std::chrono::steady_clock::now();
    run();
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - begin;
    best = std::min(best, took.count() / static_cast<double>(points));
  }
  return best;
}

struct Costs
{
  double evaluation; ///< at known xi
  double probe;      ///< location and evaluation
  double enclosed;   ///< location, evaluation and enclosure
};

Costs MeasureCosts(const EnclosureCase& c, Random& random)
{
  const EnclosureElement element(c, random);
  const Mesh mesh = element.MeshView();
  const Field field = element.FieldView();
  std::vector<Vec3> xi(1024);
  std::vector<Vec3> x(xi.size());
  for (auto& point : xi)
  {
    point = random.Inside(c.shape);
  }
  MapForward(mesh, 0, xi, x);
  const Locator locator(mesh);
  std::vector<double> value(xi.size());
  std::vector<double> lower(xi.size());
  std::vector<double> upper(xi.size());
  SampleTarget target;
  target.value = value;
  Costs costs{};
  costs.evaluation = Nanoseconds(xi.size(), [&] { EvaluateAt(mesh, field, 0, xi, value, {}); });
  costs.probe = Nanoseconds(xi.size(), [&] { SampleTile(locator, &field, x, target); });
  target.valueLower = lower;
  target.valueUpper = upper;
  costs.enclosed = Nanoseconds(xi.size(), [&] { SampleTile(locator, &field, x, target); });
  return costs;
}

void PrintCosts()
{
  std::printf("\n| shape | order | evaluation, ns | probe, ns | probe with enclosures, ns | "
              "enclosure / evaluation | probe with / without |\n|---|---|---|---|---|---|---|\n");
  Random random(8);
  ForEachForm(
    [&](Shape shape, Form form)
    {
      for (const int order : { 1, 2, 3, 4, 6, 8, 12 })
      {
        const Costs costs = MeasureCosts(CaseOf(shape, form, order), random);
        std::printf("| %s | %d | %.0f | %.0f | %.0f | %.0f | %.1f |\n", Title(shape, form), order,
          costs.evaluation, costs.probe, costs.enclosed,
          (costs.enclosed - costs.probe) / costs.evaluation, costs.enclosed / costs.probe);
      }
    });
}
} // namespace
} // namespace pixelexact::testing

int main()
{
  std::printf("Instruction set %s; maps of order 3 (pyramids 4)\n\n", pixelexact::InstructionSet());
  pixelexact::testing::PrintWidths();
  pixelexact::testing::PrintCosts();
  return 0;
}
