// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/RoundValues.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace pixelexact
{
namespace
{
/// A value at most this fraction of a step from an end of the range counts as the end.
constexpr double kAtEnd = 0.05;
/// Larger multiples are no longer whole numbers in doubles.
constexpr double kMaxMultiple = 9e15;

/// multiple * 10^exponent, rounded once.
double Decimal(double multiple, int exponent)
{
  const std::string text =
    std::to_string(static_cast<long long>(multiple)) + "e" + std::to_string(exponent);
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value + 0.0; // no -0
}

/// Whole numbers first, first + step, ... inside a range.
struct Progression
{
  double first;
  double step;
};

/// Chooses the step for a range in units: a step whose multiples fit, else the one whose values are
/// nearest to the middle of the range. None where any `count` values leave space for a further one.
std::optional<Progression> FitProgression(int count, double lower, double upper)
{
  std::optional<Progression> best;
  double bestOff = std::numeric_limits<double>::infinity();
  const double length = upper - lower;
  const auto leastStep = std::max(1.0, std::ceil(length / (count + 1.0 + 2.0 * kAtEnd)));
  for (double step = leastStep; step <= length && step * (count - 1) <= length; ++step)
  {
    // The last whole number that is not inside at the lower end, and the first one at the upper
    // end.
    const double below = std::floor(lower + kAtEnd * step);
    const double above = std::ceil(upper - kAtEnd * step);
    const double least = std::max(below + 1.0, above - count * step);
    const double most = std::min(below + step, above - 1.0 - (count - 1) * step);
    if (least > most)
    {
      continue;
    }
    const double multiple = std::ceil(least / step) * step;
    if (multiple <= most)
    {
      return Progression{ multiple, step };
    }
    const double centred = 0.5 * (lower + upper) - 0.5 * (count - 1) * step;
    const double first = std::clamp(std::round(centred), least, most);
    if (std::fabs(first - centred) < bestOff)
    {
      bestOff = std::fabs(first - centred);
      best = Progression{ first, step };
    }
  }
  return best;
}

std::vector<double> LinearValues(int count, const std::array<double, 2>& range)
{
  struct Unit
  {
    double factor;
    int digits; ///< of the factor behind its point
  };
  constexpr std::array kUnits{ Unit{ 5.0, 0 }, Unit{ 2.5, 1 }, Unit{ 2.0, 0 }, Unit{ 1.0, 0 } };
  const double length = range[1] - range[0];
  const double size = std::max(std::fabs(range[0]), std::fabs(range[1]));
  for (int exponent = static_cast<int>(std::ceil(std::log10(length)));; --exponent)
  {
    for (const Unit& unit : kUnits)
    {
      const double scaled = unit.digits > 0 ? 10.0 * unit.factor : unit.factor;
      const double in = Decimal(scaled, exponent - unit.digits);
      if (!(in > 0.0) || size / in > kMaxMultiple / scaled)
      {
        return {};
      }
      const auto fit = FitProgression(count, range[0] / in, range[1] / in);
      if (!fit)
      {
        continue;
      }
      std::vector<double> values;
      values.reserve(static_cast<std::size_t>(count));
      for (int i = 0; i < count; ++i)
      {
        values.push_back(Decimal((fit->first + i * fit->step) * scaled, exponent - unit.digits));
      }
      return values;
    }
  }
}

/// The number nearest to `value` by its logarithm among `factors` times powers of ten; the factors
/// are from 1 to 10.
template <std::size_t Count>
double NearestOf(const std::array<int, Count>& factors, double value)
{
  const int exponent = static_cast<int>(std::floor(std::log10(value)));
  double nearest = 0.0;
  for (const int power : { exponent - 1, exponent, exponent + 1 })
  {
    for (const int factor : factors)
    {
      const double candidate = Decimal(factor, power);
      const double off = std::fabs(std::log(candidate / value));
      nearest = nearest > 0.0 && std::fabs(std::log(nearest / value)) <= off ? nearest : candidate;
    }
  }
  return nearest;
}

/// Rounds to `digits` digits.
double WithDigits(double value, int digits)
{
  const int exponent = static_cast<int>(std::floor(std::log10(value))) - digits + 1;
  return Decimal(std::round(value / std::pow(10.0, exponent)), exponent);
}

std::vector<double> LogarithmicValues(int count, const std::array<double, 2>& range)
{
  constexpr double kMaxOff = 0.2; // of a step
  constexpr int kMaxDigits = 15;
  const double step = (std::log(range[1]) - std::log(range[0])) / (count + 1);
  for (int level = -1; level <= kMaxDigits; ++level)
  {
    std::vector<double> values;
    for (int i = 1; i <= count; ++i)
    {
      const double exact = std::exp(std::log(range[0]) + i * step);
      const double value = level < 0 ? NearestOf(std::array{ 1 }, exact)
        : level == 0                 ? NearestOf(std::array{ 1, 2, 5 }, exact)
                                     : WithDigits(exact, level);
      if (!(std::fabs(std::log(value / exact)) <= kMaxOff * step))
      {
        break;
      }
      values.push_back(value);
    }
    if (values.size() == static_cast<std::size_t>(count))
    {
      return values;
    }
  }
  return {};
}
} // namespace

std::vector<double> RoundValues(int count, const std::array<double, 2>& range, bool logarithm)
{
  const double length = range[1] - range[0];
  if (count < 1 || !std::isfinite(length) || !(length > 0.0) || (logarithm && !(range[0] > 0.0)))
  {
    return {};
  }
  return logarithm ? LogarithmicValues(count, range) : LinearValues(count, range);
}
} // namespace pixelexact
