// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Numbers.h"

#include "Core/Base/ParseWhole.h"

#include <cmath>

namespace pixelexact
{
std::string_view Trim(std::string_view text)
{
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos)
  {
    return {};
  }
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

bool ParseNumber(std::string_view text, double& number)
{
  return ParseWhole(Trim(text), number);
}

bool ParseInteger(std::string_view text, int& number)
{
  return !text.starts_with('+') && ParseWhole(text, number);
}

double WithoutRoundings(double number, double size)
{
  constexpr double kRoundings = 1e-14;
  return std::fabs(number) < kRoundings * size ? 0.0 : number + 0.0;
}
} // namespace pixelexact
