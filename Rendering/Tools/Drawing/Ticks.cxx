// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/Ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

namespace pixelexact
{
namespace
{
/// Tolerance, relative to a step, within which a value counts as an end of the range.
constexpr double kRounding = 1e-9;
constexpr int kMaxDigits = 17;
/// Steps of shorter ranges would be denormal numbers.
constexpr double kMinLength = 1e-300;
/// Numbers below it have no exponent.
constexpr double kMaxPlain = 1e6;

/// "-1.5e-07" with minus signs of print and without zeros before the exponent; "90", not "9e+01".
std::string Printed(double value, int digits)
{
  std::string plain = fmt::format("{:.{}g}", value, digits);
  if (const double rounded = std::strtod(plain.c_str(), nullptr); std::fabs(rounded) >= 1.0 &&
      std::fabs(rounded) < kMaxPlain && plain.find('e') != std::string::npos)
  {
    plain = fmt::format("{:.0f}", rounded);
  }
  return WithMinus(plain);
}

/// Ticks in the fewest digits, at least `fewest`, that distinguish them. `reproduced`: and that
/// give the values.
std::vector<Tick> Written(const std::vector<double>& values, int fewest, bool reproduced)
{
  std::vector<Tick> ticks;
  const std::set<double> different(values.begin(), values.end());
  for (int digits = fewest; digits <= kMaxDigits; ++digits)
  {
    ticks.clear();
    std::set<std::string> texts;
    bool same = true;
    for (const double value : values)
    {
      ticks.push_back({ value, Printed(value, digits) });
      texts.insert(ticks.back().text);
      const double read = std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr);
      same = same && (!reproduced || std::fabs(read - value) <= 1e-9 * std::fabs(value));
    }
    if (texts.size() == different.size() && same)
    {
      break;
    }
  }
  return ticks;
}

std::vector<double> Linear(const std::array<double, 2>& range, int most)
{
  const double length = range[1] - range[0];
  double unit = std::pow(10.0, std::floor(std::log10(length)) - 1.0);
  for (;; unit *= 10.0)
  {
    for (const double factor : { 1.0, 2.0, 5.0 })
    {
      const double step = factor * unit;
      const double first = std::ceil(range[0] / step - kRounding);
      const double last = std::floor(range[1] / step + kRounding);
      if (last - first < most)
      {
        std::vector<double> values;
        for (double i = first; i <= last; ++i)
        {
          // i * step would give 0.30000000000000004 instead of 0.3.
          const double value = unit < 1.0 ? i * factor / std::round(1.0 / unit) : i * step;
          // Adding 0 turns -0 into 0.
          values.push_back(std::clamp(value, range[0], range[1]) + 0.0);
        }
        return values;
      }
    }
  }
}

std::vector<double> Logarithmic(const std::array<double, 2>& range, int most)
{
  const int first = static_cast<int>(std::floor(std::log10(range[0])));
  const int last = static_cast<int>(std::ceil(std::log10(range[1])));
  const auto with = [&](const std::vector<double>& factors, int stride)
  {
    std::vector<double> values;
    for (int power = first; power <= last; power += stride)
    {
      for (const double factor : factors)
      {
        const double value = factor * std::pow(10.0, power);
        if (value >= range[0] * (1.0 - kRounding) && value <= range[1] * (1.0 + kRounding))
        {
          values.push_back(value);
        }
      }
    }
    return values;
  };
  std::vector<double> values = with({ 1.0, 2.0, 5.0 }, 1);
  for (int stride = 1; std::ssize(values) > most; ++stride)
  {
    values = with({ 1.0 }, stride);
  }
  return values;
}
} // namespace

std::string WithMinus(const std::string& number)
{
  constexpr const char* kMinus = "\u2212";
  std::string text;
  text.reserve(number.size() + 4);
  for (std::size_t i = 0; i < number.size(); ++i)
  {
    const bool isOfExponent = i > 0 && number[i - 1] == 'e';
    if (number[i] == '-')
    {
      text += kMinus;
    }
    else if (number[i] != '+')
    {
      text += number[i];
    }
    if (isOfExponent && i + 2 < number.size() && number[i + 1] == '0')
    {
      ++i;
    }
  }
  return text;
}

double PartOfRange(const std::array<double, 2>& range, bool logarithm, double value)
{
  // Quotients of the ends may overflow, their logarithms do not.
  return logarithm
    ? (std::log(value) - std::log(range[0])) / (std::log(range[1]) - std::log(range[0]))
    : (value - range[0]) / (range[1] - range[0]);
}

double ValueInRange(const std::array<double, 2>& range, bool logarithm, double part)
{
  const double value = logarithm ? std::exp(std::lerp(std::log(range[0]), std::log(range[1]), part))
                                 : std::lerp(range[0], range[1], part);
  return std::clamp(value, range[0], range[1]);
}

std::vector<Tick> TicksOfBands(
  const std::array<double, 2>& range, bool logarithm, int bands, int most)
{
  const int stride = std::max(1, (bands + most) / std::max(1, most));
  std::vector<double> values;
  for (int i = 0; i < bands; i += stride)
  {
    values.push_back(ValueInRange(range, logarithm, static_cast<double>(i) / bands));
  }
  values.push_back(range[1]);
  const double length = range[1] - range[0];
  for (double& value : values)
  {
    // Replaces a rounding error about zero by 0.
    value = !logarithm && std::fabs(value) < kRounding * length ? 0.0 : value;
  }
  return Written(values, 3, false);
}

std::vector<Tick> RoundTicks(const std::array<double, 2>& range, int most)
{
  if (!(range[1] - range[0] > kMinLength) || !std::isfinite(range[1] - range[0]))
  {
    return TicksAt({ range[0], range[1] });
  }
  std::vector<double> values = Linear(range, most);
  while (values.size() < 2)
  {
    values = Linear(range, ++most);
  }
  return Written(values, 1, true);
}

std::vector<Tick> TicksAt(const std::vector<double>& values)
{
  return Written(values, 4, false);
}

std::vector<Tick> TicksOfBar(const std::array<double, 2>& range, bool logarithm, int most)
{
  if (!(range[1] > range[0]))
  {
    return TicksAt({ range[0] });
  }
  const double room = 1.0 / std::max(most, 2);
  std::vector<Tick> ticks = TicksWithin(range, logarithm, most);
  std::erase_if(ticks,
    [&](const Tick& tick)
    {
      const double part = PartOfRange(range, logarithm && range[0] > 0.0, tick.value);
      return !(part > 0.7 * room && part < 1.0 - 0.7 * room);
    });
  // Rounding changes the ends by at most a thousandth of the range.
  const double size = std::max(std::fabs(range[0]), std::fabs(range[1]));
  const double last = std::floor(std::log10(range[1] - range[0]) - std::log10(500.0));
  const int digits =
    static_cast<int>(std::clamp(std::floor(std::log10(size)) + 1.0 - last, 4.0, 17.0));
  const std::vector<Tick> ends = Written({ range[0], range[1] }, digits, false);
  ticks.insert(ticks.begin(), ends.front());
  ticks.push_back(ends.back());
  return ticks;
}

std::vector<Tick> TicksWithin(const std::array<double, 2>& range, bool logarithm, int most)
{
  const bool decades = logarithm && range[0] > 0.0 && range[1] >= 10.0 * range[0];
  const double size = std::max(std::fabs(range[0]), std::fabs(range[1]));
  std::vector<double> values{ range[0] };
  if (const double length = range[1] - range[0];
      length > 1e-12 * size && length > kMinLength && std::isfinite(length))
  {
    values = decades ? Logarithmic(range, most) : Linear(range, most);
    if (values.size() < 2)
    {
      values = { range[0], range[1] };
    }
  }
  return Written(values, 1, true);
}
} // namespace pixelexact
