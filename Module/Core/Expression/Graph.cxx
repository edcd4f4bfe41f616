// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/Graph.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

namespace pixelexact
{
namespace
{
/// Whether the operation on constants rounds nothing: others stay as they are, so that intervals
/// hold what they are exactly.
bool IsExact(Operation operation, double a, double b, double result)
{
  const auto isFarFromUnderflow = [](double v) { return std::fabs(v) > 1e-250; };
  switch (operation)
  {
    case Operation::Add:
    case Operation::Subtract:
      return std::isfinite(result) && result - a == (operation == Operation::Add ? b : -b) &&
        (operation == Operation::Add ? result - b : result + b) == a;
    case Operation::Multiply:
      return a == 0.0 || b == 0.0
        ? std::isfinite(result)
        : std::isfinite(result) && isFarFromUnderflow(result) && std::fma(a, b, -result) == 0.0;
    case Operation::Divide:
      return std::isfinite(result) && b != 0.0 &&
        (a == 0.0 || (isFarFromUnderflow(result) && isFarFromUnderflow(a))) &&
        std::fma(result, b, -a) == 0.0;
    case Operation::Power:
    case Operation::Atan2:
      return false;
    default:
      return true; // comparisons, logic, Min and Max
  }
}

bool IsCommutative(Operation operation)
{
  return operation == Operation::Add || operation == Operation::Multiply ||
    operation == Operation::Min || operation == Operation::Max || operation == Operation::Equal ||
    operation == Operation::NotEqual || operation == Operation::And || operation == Operation::Or;
}
} // namespace

bool Graph::Node::operator<(const Node& other) const
{
  const auto key = [](const Node& node)
  {
    return std::tuple(node.operation, std::bit_cast<std::uint64_t>(node.constant), node.arguments,
      node.field, node.component, node.a, node.b, node.c);
  };
  return key(*this) < key(other);
}

double Apply(Operation operation, double a, double b, double c)
{
  const auto truth = [](bool is) { return is ? 1.0 : 0.0; };
  switch (operation)
  {
    case Operation::Negate:
      return -a;
    case Operation::Not:
      return truth(a == 0.0);
    case Operation::Sqrt:
      return std::sqrt(a);
    case Operation::Exp:
      return std::exp(a);
    case Operation::Log:
      return std::log(a);
    case Operation::Sin:
      return std::sin(a);
    case Operation::Cos:
      return std::cos(a);
    case Operation::Tan:
      return std::tan(a);
    case Operation::Asin:
      return std::asin(a);
    case Operation::Acos:
      return std::acos(a);
    case Operation::Atan:
      return std::atan(a);
    case Operation::Sinh:
      return std::sinh(a);
    case Operation::Cosh:
      return std::cosh(a);
    case Operation::Tanh:
      return std::tanh(a);
    case Operation::Erf:
      return std::erf(a);
    case Operation::Abs:
      return std::fabs(a);
    case Operation::Sign:
      return a > 0.0 ? 1.0 : a < 0.0 ? -1.0 : a;
    case Operation::Floor:
      return std::floor(a);
    case Operation::Ceil:
      return std::ceil(a);
    case Operation::Add:
      return a + b;
    case Operation::Subtract:
      return a - b;
    case Operation::Multiply:
      return a * b;
    case Operation::Divide:
      return a / b;
    case Operation::Power:
      // Squares and cubes are products, which is faster and what users mean by them.
      return b == 2.0 ? a * a : b == 3.0 ? a * a * a : std::pow(a, b);
    case Operation::Atan2:
      return std::atan2(a, b);
    case Operation::Min:
      return std::isnan(a) || a < b ? a : b;
    case Operation::Max:
      return std::isnan(a) || a > b ? a : b;
    case Operation::Less:
      return truth(a < b);
    case Operation::AtMost:
      return truth(a <= b);
    case Operation::Equal:
      return truth(a == b);
    case Operation::NotEqual:
      return truth(a != b);
    case Operation::And:
      return truth(a != 0.0 && b != 0.0);
    case Operation::Or:
      return truth(a != 0.0 || b != 0.0);
    case Operation::Select:
      return std::isnan(a) ? a : a != 0.0 ? b : c;
    default:
      return std::numeric_limits<double>::quiet_NaN();
  }
}

int Graph::Insert(const Node& node)
{
  const auto [known, isNew] = Known.try_emplace(node, Size());
  if (isNew)
  {
    if (Nodes.size() == kMaxNodes)
    {
      throw InvalidData("the expression consists of more than " + std::to_string(kMaxNodes) +
        " operations; write a simpler one");
    }
    Nodes.push_back(node);
  }
  return known->second;
}

int Graph::Constant(double value)
{
  return Insert({ .constant = value });
}

int Graph::Leaf(const Node& node)
{
  return Insert(node);
}

int Graph::Of(Operation operation, int a)
{
  const Node& argument = At(a);
  if (argument.operation == Operation::Constant && operation == Operation::Negate)
  {
    return Constant(-argument.constant);
  }
  if (operation == Operation::Negate && argument.operation == Operation::Negate)
  {
    return argument.arguments[0];
  }
  return Insert({ .operation = operation, .arguments = { a, -1, -1, -1, -1, -1 } });
}

int Graph::Of(Operation operation, int a, int b)
{
  if (At(a).operation == Operation::Constant && At(b).operation == Operation::Constant)
  {
    const double result = Apply(operation, At(a).constant, At(b).constant);
    if (IsExact(operation, At(a).constant, At(b).constant, result))
    {
      return Constant(result);
    }
  }
  switch (operation)
  {
    case Operation::Add:
      if (IsConstant(a, 0.0) || IsConstant(b, 0.0))
      {
        return IsConstant(a, 0.0) ? b : a;
      }
      break;
    case Operation::Subtract:
      if (IsConstant(a, 0.0) || IsConstant(b, 0.0))
      {
        return IsConstant(b, 0.0) ? a : Of(Operation::Negate, b);
      }
      break;
    case Operation::Multiply:
      if (IsConstant(a, 1.0) || IsConstant(b, 1.0))
      {
        return IsConstant(a, 1.0) ? b : a;
      }
      break;
    case Operation::Divide:
    case Operation::Power:
      if (IsConstant(b, 1.0))
      {
        return a;
      }
      break;
    default:
      break;
  }
  if (IsCommutative(operation) && b < a)
  {
    std::swap(a, b);
  }
  return Insert({ .operation = operation, .arguments = { a, b, -1, -1, -1, -1 } });
}

int Graph::Select(int condition, int yes, int no)
{
  if (yes == no && At(yes).operation == Operation::Constant)
  {
    return yes;
  }
  return Insert(
    { .operation = Operation::Select, .arguments = { condition, yes, no, -1, -1, -1 } });
}

int Graph::Eigen(Operation operation, const std::array<int, 6>& matrix, int number, int component)
{
  return Insert({ .operation = operation, .arguments = matrix, .a = number, .b = component });
}

int Graph::Jump(int node)
{
  return Of(Operation::Subtract, Leaf({ .operation = Operation::Behind, .a = node }), node);
}

std::vector<int> Graph::NeededFor(std::span<const int> nodes) const
{
  std::vector<char> isNeeded(Nodes.size(), 0);
  std::vector<int> open(nodes.begin(), nodes.end());
  while (!open.empty())
  {
    const int node = open.back();
    open.pop_back();
    if (std::exchange(isNeeded[static_cast<std::size_t>(node)], 1) == 0)
    {
      std::ranges::copy_if(
        At(node).arguments, std::back_inserter(open), [](int argument) { return argument >= 0; });
    }
  }
  std::vector<int> needed;
  for (int node = 0; node < Size(); ++node)
  {
    if (isNeeded[static_cast<std::size_t>(node)] != 0)
    {
      needed.push_back(node); // numbers ascend from arguments to what is computed from them
    }
  }
  return needed;
}
} // namespace pixelexact
