// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Files/ExpressionNames.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pixelexact::nektar
{
namespace
{
struct Constant
{
  std::string_view name;
  double value;
};
constexpr Constant kConstants[] = {
  { "MEANINGLESS", 0.0 },
  { "E", std::numbers::e },
  { "LOG2E", std::numbers::log2e },
  { "LOG10E", std::numbers::log10e },
  { "LN2", std::numbers::ln2 },
  { "LN10", std::numbers::ln10 },
  { "PI", std::numbers::pi },
  { "PI_2", std::numbers::pi / 2 },
  { "PI_4", std::numbers::pi / 4 },
  { "SQRT2", std::numbers::sqrt2 },
  { "SQRT1_2", std::numbers::sqrt2 / 2 },
  { "GAMMA", std::numbers::egamma },
  { "DEG", 180 / std::numbers::pi },
  { "PHI", std::numbers::phi },
};

struct Function1
{
  std::string_view name;
  double (*value)(double);
};
constexpr Function1 kFunctions1[] = {
  { "abs", [](double x) { return std::fabs(x); } },
  { "fabs", [](double x) { return std::fabs(x); } },
  { "asin", [](double x) { return std::asin(x); } },
  { "acos", [](double x) { return std::acos(x); } },
  { "atan", [](double x) { return std::atan(x); } },
  { "ceil", [](double x) { return std::ceil(x); } },
  { "floor", [](double x) { return std::floor(x); } },
  { "cos", [](double x) { return std::cos(x); } },
  { "cosh", [](double x) { return std::cosh(x); } },
  { "exp", [](double x) { return std::exp(x); } },
  { "log", [](double x) { return std::log(x); } },
  { "log10", [](double x) { return std::log10(x); } },
  { "sign", [](double x) { return double(x > 0) - double(x < 0); } },
  { "sin", [](double x) { return std::sin(x); } },
  { "sinh", [](double x) { return std::sinh(x); } },
  { "sqrt", [](double x) { return std::sqrt(x); } },
  { "tan", [](double x) { return std::tan(x); } },
  { "tanh", [](double x) { return std::tanh(x); } },
};

struct Function2
{
  std::string_view name;
  double (*value)(double, double);
};
constexpr Function2 kFunctions2[] = {
  { "atan2", [](double y, double x) { return std::atan2(y, x); } },
  { "ang", [](double x, double y) { return std::atan2(y, x); } },
  { "rad", [](double x, double y) { return std::hypot(x, y); } },
  { "fmod", [](double x, double y) { return std::fmod(x, y); } },
  { "max", [](double x, double y) { return std::fmax(x, y); } },
  { "fmax", [](double x, double y) { return std::fmax(x, y); } },
  { "min", [](double x, double y) { return std::fmin(x, y); } },
  { "fmin", [](double x, double y) { return std::fmin(x, y); } },
};
} // namespace

std::optional<double> ConstantNamed(std::string_view name)
{
  const auto* found = std::ranges::find(kConstants, name, &Constant::name);
  return found != std::end(kConstants) ? std::optional(found->value) : std::nullopt;
}

std::optional<double> CallFunction(std::string_view name, std::span<const double> arguments)
{
  const auto* one = std::ranges::find(kFunctions1, name, &Function1::name);
  if (arguments.size() == 1 && one != std::end(kFunctions1))
  {
    return one->value(arguments[0]);
  }
  const auto* two = std::ranges::find(kFunctions2, name, &Function2::name);
  if (arguments.size() == 2 && two != std::end(kFunctions2))
  {
    return two->value(arguments[0], arguments[1]);
  }
  return std::nullopt;
}
} // namespace pixelexact::nektar
