// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/OuterFunctions.h"

#include "Core/Expression/IntervalOperations.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pixelexact
{
namespace
{
/// The relative error of the C library's functions: 16 units in the last place and the rounding of
/// a bound.
constexpr double kOfFunction = 0x1p-47;
/// The largest and the smallest factor of a product.
constexpr double kMaxFactor = 0x1p200;

bool IsConstant(const Graph& graph, int node)
{
  return graph.At(node).operation == Operation::Constant;
}

/// Whether the operations of a node exclude negative values.
bool IsNotNegative(const Graph& graph, int node)
{
  const Graph::Node& at = graph.At(node);
  const auto& [a, b, c, d, e, f] = at.arguments;
  switch (at.operation)
  {
    case Operation::Constant:
      return at.constant >= 0.0;
    case Operation::Sqrt:
    case Operation::Exp:
    case Operation::Cosh:
    case Operation::Abs:
    case Operation::Pi:
      return true;
    case Operation::Multiply:
      return a == b || (IsNotNegative(graph, a) && IsNotNegative(graph, b));
    case Operation::Add:
    case Operation::Divide:
      return IsNotNegative(graph, a) && IsNotNegative(graph, b);
    case Operation::Power:
      return IsConstant(graph, b) && std::fmod(graph.At(b).constant, 2.0) == 0.0;
    default:
      return false;
  }
}

bool IsFactor(double constant)
{
  return std::fabs(constant) <= kMaxFactor && std::fabs(constant) >= 1.0 / kMaxFactor;
}
} // namespace

OuterFunctions::OuterFunctions(const Graph& graph, int node)
  : Node(node)
{
  // Returns the argument of the function that `Node` is; none if it has no inverse.
  const auto strip = [&]() -> std::optional<int>
  {
    const Graph::Node& at = graph.At(Node);
    const int a = at.arguments[0];
    const int b = at.arguments[1];
    switch (at.operation)
    {
      case Operation::Sqrt:
      case Operation::Log:
        if (!IsNotNegative(graph, a))
        {
          return std::nullopt;
        }
        Steps.push_back({ at.operation, 0.0 });
        return a;
      case Operation::Exp:
        Steps.push_back({ at.operation, 0.0 });
        return a;
      case Operation::Negate:
        Steps.push_back({ Operation::Multiply, -1.0 });
        return a;
      case Operation::Add:
      case Operation::Multiply:
        for (const auto& [constant, other] : { std::pair(a, b), std::pair(b, a) })
        {
          const double k = graph.At(constant).constant;
          if (IsConstant(graph, constant) &&
            (at.operation == Operation::Add ? std::isfinite(k) : IsFactor(k)))
          {
            Steps.push_back({ at.operation, k });
            return other;
          }
        }
        return std::nullopt;
      case Operation::Subtract:
        if (IsConstant(graph, a) && std::isfinite(graph.At(a).constant))
        {
          Steps.push_back({ Operation::Add, graph.At(a).constant });
          Steps.push_back({ Operation::Multiply, -1.0 });
          return b;
        }
        [[fallthrough]];
      case Operation::Divide:
        if (const double k = graph.At(b).constant; IsConstant(graph, b) &&
            (at.operation == Operation::Subtract ? std::isfinite(k) : IsFactor(k)))
        {
          const bool isSum = at.operation == Operation::Subtract;
          Steps.push_back({ isSum ? Operation::Add : Operation::Divide, isSum ? -k : k });
          return a;
        }
        return std::nullopt;
      default:
        return std::nullopt;
    }
  };
  while (const std::optional<int> argument = strip())
  {
    Node = *argument;
  }
}

double OuterFunctions::Invert(double value) const
{
  double v = value;
  for (const auto& [operation, constant] : Steps)
  {
    switch (operation)
    {
      case Operation::Sqrt:
        v = v < 0.0 ? -kInfinity : v * v;
        break;
      case Operation::Exp:
        v = v < 0.0 ? -kInfinity : std::log(v);
        break;
      case Operation::Log:
        v = std::exp(v);
        break;
      case Operation::Add:
        v -= constant;
        break;
      case Operation::Multiply:
        v /= constant;
        break;
      default:
        v *= constant;
    }
  }
  return v;
}

double OuterFunctions::ErrorOver(const Interval& inner) const
{
  if (Steps.empty())
  {
    return 0.0;
  }
  // The values before and after each function, that of G first.
  std::vector<Interval> values{ inner };
  for (auto step = Steps.rbegin(); step != Steps.rend(); ++step)
  {
    const auto& [operation, constant] = *step;
    const Interval& x = values.back();
    switch (operation)
    {
      case Operation::Sqrt:
        values.push_back(Sqrt(x));
        break;
      case Operation::Exp:
        values.push_back(FunctionOf(Operation::Exp, x));
        break;
      case Operation::Log:
        values.push_back(x.lower > 0.0 ? FunctionOf(Operation::Log, x) : Interval::Everything());
        break;
      case Operation::Add:
        values.push_back(x + Interval(constant));
        break;
      case Operation::Multiply:
        values.push_back(x * Interval(constant));
        break;
      default:
        values.push_back(x / Interval(constant));
    }
  }
  // Bounds the difference of the value that Invert computes and that which the program computed on
  // its way to F, from the last function to the first.
  double off = 0.0;
  for (std::size_t k = 0; k < Steps.size(); ++k)
  {
    const auto& [operation, constant] = Steps[k];
    const double y = values[Steps.size() - k].Magnitude();
    const double x = values[Steps.size() - k - 1].Magnitude();
    switch (operation)
    {
      case Operation::Sqrt:
        off = 2.0 * y * off + off * off + 8.0 * kUnitRoundoff * (x + off * off);
        break;
      case Operation::Exp:
      {
        // A logarithm changes by at most twice a small relative error.
        const double relative = off / values[Steps.size() - k].Mignitude() + kOfFunction;
        off = relative <= 0.25 ? 2.0 * relative + kOfFunction * (x + 1.0) : kInfinity;
        break;
      }
      case Operation::Log:
      {
        // x |log x| is at most 1 / e below 1.
        const double change = x * off + kOfFunction * std::max(1.0, x * std::log(std::max(x, 1.0)));
        off = off <= 0.25 ? 2.0 * (change + kOfFunction * x) : kInfinity;
        break;
      }
      case Operation::Add:
        off += 2.0 * kUnitRoundoff * (x + y + off);
        break;
      case Operation::Multiply:
        off = off / std::fabs(constant) + 4.0 * kUnitRoundoff * (x + off / std::fabs(constant));
        break;
      default:
        off = off * std::fabs(constant) + 4.0 * kUnitRoundoff * (x + off * std::fabs(constant));
    }
  }
  // Covers the rounding of the bound and of numbers near underflow. The comparison is written so
  // that a NaN is no bound.
  const double bound = off * (1.0 + 0x1p-40) + 0x1p-700;
  return bound >= 0.0 ? bound : kInfinity;
}
} // namespace pixelexact
