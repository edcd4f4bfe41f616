// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Volume/InsideSearch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pixelexact
{
double ChebyshevSum(std::span<const double> coefficients, double x)
{
  double b1 = 0.0;
  double b2 = 0.0;
  for (std::size_t k = coefficients.size() - 1; k > 0; --k)
  {
    const double b0 = 2.0 * x * b1 - b2 + coefficients[k];
    b2 = b1;
    b1 = b0;
  }
  return x * b1 - b2 + coefficients[0];
}

namespace
{
/// Levels to which an interval is bisected to find where a ray enters and leaves.
constexpr int kMaxLevels = 10;

/// Finds where all sides are >= 0. Series are over [from, to]; results are in the x of the whole.
class InsideSearch
{
public:
  explicit InsideSearch(std::vector<Inside>& out)
    : Out(out)
  {
  }

  void Run(const std::vector<SideSeries>& sides, double from, double to, int levels)
  {
    const double half = 0.5 * (to - from);
    const double middle = 0.5 * (from + to);
    Inside part{ from, to };
    bool isUndecided = false;
    for (const SideSeries& side : sides)
    {
      const std::span<const double> a = side.Coefficients();
      double others = 0.0; // bounds everything but the first two terms
      double bend = 0.0;   // bounds the slope of all terms but the first two
      for (std::size_t k = 2; k < a.size(); ++k)
      {
        others += std::fabs(a[k]);
        bend += static_cast<double>(k * k) * std::fabs(a[k]);
      }
      const double linear = a.size() > 1 ? a[1] : 0.0;
      const double reach = (std::fabs(linear) + others) * kInsideUp;
      if (a[0] - reach > side.error)
      {
        continue;
      }
      if (a[0] + reach < -side.error)
      {
        return;
      }
      const double slope = std::fabs(linear) - bend * kInsideUp;
      if (!(slope > 0.25 * std::fabs(linear)) || !(slope > 0.0))
      {
        isUndecided = true;
        continue;
      }
      Clip(a, side.error, slope, middle, half, part);
    }
    if (isUndecided && levels > 0)
    {
      Run(Parts(sides, -1.0, 0.0), from, middle, levels - 1);
      Run(Parts(sides, 0.0, 1.0), middle, to, levels - 1);
      return;
    }
    if (isUndecided)
    {
      // The whole part may be inside or outside.
      const bool inside = std::ranges::all_of(sides,
        [](const SideSeries& side) { return ChebyshevSum(side.Coefficients(), 0.0) >= 0.0; });
      const double width = to - from;
      Out.push_back(inside ? Inside{ from, to, width, width, false }
                           : Inside{ middle, middle, width, width, false });
      return;
    }
    if (part.to >= part.from)
    {
      Out.push_back(part);
    }
    else if (part.from - part.to < part.fromError + part.toError)
    {
      // It may be inside over less than the errors of both ends.
      const double at = 0.5 * (part.from + part.to);
      Out.push_back({ at, at, part.fromError, part.toError });
    }
  }

private:
  /// The series over a part of [-1, 1].
  static std::vector<SideSeries> Parts(const std::vector<SideSeries>& sides, double from, double to)
  {
    std::vector<SideSeries> parts(sides.size());
    for (std::size_t k = 0; k < sides.size(); ++k)
    {
      const SideSeries& side = sides[k];
      const int n = static_cast<int>(side.count);
      std::array<double, kMaxRayPoints> values{};
      for (std::size_t i = 0; i < side.count; ++i)
      {
        const double x = RayCosines(n)[side.count + i];
        values[i] = ChebyshevSum(side.Coefficients(), 0.5 * (from + to) + 0.5 * (to - from) * x);
      }
      ToCoefficients(values.data(), n, parts[k].values.data());
      parts[k].count = side.count;
      parts[k].error = side.error * kInsideUp + 1e-15;
    }
    return parts;
  }

  /// Moves an end of `part` to the root of a monotone side, if that is nearer.
  static void Clip(
    std::span<const double> a, double error, double slope, double middle, double half, Inside& part)
  {
    const double sign = a[1] > 0.0 ? 1.0 : -1.0;
    const double first = ChebyshevSum(a, -sign);
    const double last = ChebyshevSum(a, sign);
    if (first > error)
    {
      return;
    }
    if (last < -error)
    {
      part.to = part.from - 1.0;
      part.fromError = part.toError = 0.0;
      return;
    }
    // Newton's iteration with bisection; any x is as good as its residual.
    double lower = -1.0;
    double upper = 1.0;
    double x = first > 0.0 ? -sign : (last < 0.0 ? sign : std::clamp(-a[0] / a[1], -1.0, 1.0));
    double value = ChebyshevSum(a, x);
    for (int step = 0; step < 30 && std::fabs(value) > 1e-3 * error; ++step)
    {
      (value * sign > 0.0 ? upper : lower) = x;
      double next = x - value / a[1];
      if (!(next > lower && next < upper))
      {
        next = 0.5 * (lower + upper);
      }
      if (next == x || !(upper - lower > 1e-16))
      {
        break;
      }
      x = next;
      value = ChebyshevSum(a, x);
    }
    const double off = half * (std::fabs(value) + error + 1e-15) / slope * kInsideUp;
    const double root = middle + half * x;
    // Ends of which either may be the true one have the errors of both.
    if (sign > 0.0)
    {
      if (root - off > part.from + part.fromError)
      {
        part.from = root;
        part.fromError = off;
      }
      else if (root + off > part.from - part.fromError)
      {
        const double before = part.from;
        part.from = std::max(part.from, root);
        part.fromError = std::max(part.fromError, off) + std::fabs(before - root);
      }
    }
    else
    {
      if (root + off < part.to - part.toError)
      {
        part.to = root;
        part.toError = off;
      }
      else if (root - off < part.to + part.toError)
      {
        const double before = part.to;
        part.to = std::min(part.to, root);
        part.toError = std::max(part.toError, off) + std::fabs(before - root);
      }
    }
  }

  std::vector<Inside>& Out;
};
} // namespace

const std::vector<double>& RayCosines(int n)
{
  static const std::vector<std::vector<double>> tables = []
  {
    std::vector<std::vector<double>> all(kMaxRayPoints + 1);
    for (std::size_t m = 1; m < all.size(); ++m)
    {
      all[m].resize(m * m);
      for (std::size_t k = 0; k < m; ++k)
      {
        for (std::size_t i = 0; i < m; ++i)
        {
          all[m][k * m + i] = std::cos(std::numbers::pi *
            static_cast<double>(k * (2 * i + 1) % (4 * m)) / (2.0 * static_cast<double>(m)));
        }
      }
    }
    return all;
  }();
  return tables[static_cast<std::size_t>(n)];
}

void ToCoefficients(const double* values, int n, double* coefficients)
{
  const double* cosine = RayCosines(n).data();
  for (int k = 0; k < n; ++k)
  {
    double sum = 0.0;
    for (int i = 0; i < n; ++i)
    {
      sum += cosine[k * n + i] * values[i];
    }
    coefficients[k] = sum * (k == 0 ? 1.0 : 2.0) / n;
  }
}

void FindInside(const std::vector<SideSeries>& sides, std::vector<Inside>& inside)
{
  InsideSearch(inside).Run(sides, -1.0, 1.0, kMaxLevels);
}
} // namespace pixelexact
