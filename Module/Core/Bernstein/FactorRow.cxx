// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bernstein/FactorRow.h"

#include "Core/Math/Rounding.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelexact
{
namespace
{
constexpr int kMaxBinomial = 99;

/// Pascal's triangle. Those used here, C(66 - n, n) the largest, are below 2^53, hence exact.
double Binomial(int n, int k)
{
  using Triangle = std::array<std::array<double, kMaxBinomial + 1>, kMaxBinomial + 1>;
  static const Triangle triangle = []
  {
    Triangle t{};
    for (std::size_t row = 0; row <= kMaxBinomial; ++row)
    {
      t[row][0] = 1.0;
      for (std::size_t column = 1; column <= row; ++column)
      {
        t[row][column] = t[row - 1][column - 1] + (column < row ? t[row - 1][column] : 0.0);
      }
    }
    return t;
  }();
  return k < 0 || k > n ? 0.0L : triangle[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)];
}

/// The unevaluated sum of two doubles: about 100 bits, for coefficients that cancel.
struct Wide
{
  double high = 0.0;
  double low = 0.0;
};

Wide TwoSum(double a, double b)
{
  const double sum = a + b;
  const double part = sum - a;
  return { sum, (a - (sum - part)) + (b - part) };
}

Wide operator+(const Wide& a, const Wide& b)
{
  const Wide high = TwoSum(a.high, b.high);
  const Wide low = TwoSum(a.low, b.low);
  const Wide sum = TwoSum(high.high, high.low + low.high);
  return TwoSum(sum.high, sum.low + low.low);
}

Wide operator-(const Wide& a)
{
  return { -a.high, -a.low };
}

Wide operator*(const Wide& a, double b)
{
  const double high = a.high * b;
  return TwoSum(high, std::fma(a.high, b, -high) + a.low * b);
}

Wide operator/(const Wide& a, double b)
{
  const double high = a.high / b;
  return TwoSum(high, (std::fma(-high, b, a.high) + a.low) / b);
}

/// Coefficients and, for each, the sum of magnitudes that went into it: errors are at most
/// kRoundings times kWideRoundoff of that.
struct WideRow
{
  explicit WideRow(int degree)
    : b(static_cast<std::size_t>(degree) + 1)
    , s(b.size(), 0.0)
  {
  }
  [[nodiscard]] int Degree() const { return static_cast<int>(b.size()) - 1; }

  std::vector<Wide> b;
  std::vector<double> s;
};

/// 3 of the closed form, 4 of differences and linear factors, 2 + 33 of raising, 32 of each of at
/// most 4 halvings; the rest is slack, also for the sums of magnitudes' own rounding.
constexpr double kRoundings = 256.0;
/// The roundoff of an operation of Wide; it is at most 2^-102 (M. Joldes, J.-M. Muller, V. Popescu,
/// Tight and rigorous error bounds for basic building blocks of double-word arithmetic, ACM TOMS
/// 44, 2017).
constexpr double kWideRoundoff = 0x1p-100;

WideRow Plain(const FactorKey& key)
{
  WideRow row(key.n + key.power);
  for (int i = 0; i <= key.n; ++i)
  {
    const Wide size =
      Wide{ Binomial(key.n + key.alpha, i) } * Binomial(key.n, i) / Binomial(row.Degree(), i);
    row.b[static_cast<std::size_t>(i)] = (key.n - i) % 2 == 0 ? size : -size;
    row.s[static_cast<std::size_t>(i)] = size.high;
  }
  return row;
}

WideRow Slope(const WideRow& row)
{
  const int n = row.Degree();
  WideRow slope(std::max(n - 1, 0));
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i)
  {
    slope.b[i] = (row.b[i + 1] + -row.b[i]) * (n / 2.0);
    slope.s[i] = (row.s[i + 1] + row.s[i]) * (n / 2.0);
  }
  return slope;
}

/// Times (1 + z) / 2.
WideRow Tilted(const WideRow& row)
{
  WideRow tilted(row.Degree() + 1);
  for (std::size_t i = 1; i < tilted.b.size(); ++i)
  {
    tilted.b[i] = row.b[i - 1] * static_cast<double>(i) / tilted.Degree();
    tilted.s[i] = row.s[i - 1] * static_cast<double>(i) / tilted.Degree();
  }
  return tilted;
}

/// (P - 1) / h for P with P(1) = 1, whose last coefficient is 1 exactly.
WideRow Closed(const WideRow& row)
{
  const int n = row.Degree();
  WideRow closed(std::max(n - 1, 0));
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i)
  {
    const auto left = static_cast<double>(n - static_cast<int>(i));
    closed.b[i] = (row.b[i] + Wide{ -1.0 }) * static_cast<double>(n) / left;
    closed.s[i] = (row.s[i] + 1.0) * n / left;
  }
  return closed;
}

WideRow Make(const FactorKey& key, Factor factor)
{
  switch (factor)
  {
    case Factor::Slope:
      return Slope(Plain(key));
    case Factor::Tilted:
      // The derivative of a constant has no degree to raise.
      return key.n + key.power > 0 ? Tilted(Slope(Plain(key))) : WideRow(0);
    case Factor::Lowered:
      return key.power > 0 ? Plain({ key.alpha, key.n, key.power - 1 }) : WideRow(0);
    case Factor::Closed:
      return Closed(Plain(key));
    default:
      return Plain(key);
  }
}

WideRow Raised(const WideRow& row, int degree)
{
  const int low = row.Degree();
  WideRow raised(degree);
  for (int j = 0; j <= degree; ++j)
  {
    const auto to = static_cast<std::size_t>(j);
    for (int i = std::max(0, j - (degree - low)); i <= std::min(low, j); ++i)
    {
      const auto from = static_cast<std::size_t>(i);
      const double weight = Binomial(j, i) * Binomial(degree - j, low - i);
      raised.b[to] = raised.b[to] + row.b[from] * weight;
      raised.s[to] += row.s[from] * weight;
    }
    raised.b[to] = raised.b[to] / Binomial(degree, low);
    raised.s[to] /= Binomial(degree, low);
  }
  return raised;
}

/// The lower or the upper half of coefficients (de Casteljau), in place.
template <class Number>
void Subdivide(std::vector<Number>& b, bool upper)
{
  const auto mean = [](const Number& x, const Number& y) { return (x + y) * 0.5; };
  for (std::size_t level = 1; level < b.size(); ++level)
  {
    if (upper)
    {
      for (std::size_t i = 0; i + level < b.size(); ++i)
      {
        b[i] = mean(b[i], b[i + 1]);
      }
      continue;
    }
    for (std::size_t i = b.size() - 1; i >= level; --i)
    {
      b[i] = mean(b[i - 1], b[i]);
    }
  }
}
} // namespace

FactorRow MakeFactorRow(const FactorKey& key, Factor factor, int degree, int level, int piece)
{
  WideRow row = Raised(Make(key, factor), degree);
  for (int l = level - 1; l >= 0; --l)
  {
    const bool upper = ((static_cast<unsigned>(piece) >> static_cast<unsigned>(l)) & 1U) != 0;
    Subdivide(row.b, upper);
    Subdivide(row.s, upper);
  }
  constexpr double kShare = kRoundings * kWideRoundoff / kUnitRoundoff;
  FactorRow result;
  for (std::size_t i = 0; i < row.b.size(); ++i)
  {
    const double value = row.b[i].high;
    const double magnitude = (std::fabs(value) + kShare * row.s[i]) * (1.0 + 0x1p-40);
    result.value.push_back(value);
    result.magnitude.push_back(magnitude);
    result.largest = std::max(result.largest, magnitude);
  }
  return result;
}
} // namespace pixelexact
