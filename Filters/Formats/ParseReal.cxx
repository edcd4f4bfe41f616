// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/ParseReal.h"

#include "Core/Base/ParseWhole.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace pixelexact
{
namespace
{
/// Of a decimal number that is not zero: whether it is below 1.
bool IsSmall(std::string_view number)
{
  const auto letter = std::min(number.find_first_of("eE"), number.size());
  const std::string_view digits = number.substr(0, letter);
  const std::string_view power = number.substr(std::min(letter + 1, number.size()));
  long exponent = 0;
  if (!power.empty() && !ParseWhole(power, exponent))
  {
    return power.starts_with('-');
  }
  const auto first = static_cast<long>(digits.find_first_of("123456789"));
  const auto point = static_cast<long>(std::min(digits.find('.'), digits.size()));
  // The first digit stands before the point, or behind it.
  return exponent < (first < point ? first - point + 1 : first - point);
}
} // namespace

bool ParseReal(std::string_view word, double& value)
{
  if (ParseWhole(word, value))
  {
    return true;
  }
  word.remove_prefix(word.starts_with('+') ? 1 : 0);
  double none = 0.0;
  const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), none);
  if (failure != std::errc::result_out_of_range || end != word.data() + word.size())
  {
    return false;
  }
  const bool negative = word.starts_with('-');
  word.remove_prefix(negative ? 1 : 0);
  value = IsSmall(word) ? 0.0 : std::numeric_limits<double>::infinity();
  value = negative ? -value : value;
  return true;
}
} // namespace pixelexact
