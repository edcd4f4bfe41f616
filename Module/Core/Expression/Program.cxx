// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/Program.h"

#include "Core/Expression/SymmetricEigen.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace pixelexact
{
namespace
{
int ArgumentsOf(const Graph::Node& node)
{
  return static_cast<int>(
    std::ranges::count_if(node.arguments, [](int argument) { return argument >= 0; }));
}

/// `from` and what it counts on by; a constant stays where it is.
struct Operand
{
  const double* values;
  std::size_t stride;

  [[nodiscard]] double operator[](std::size_t i) const { return values[i * stride]; }
};

template <class Function>
void ForAll(int count, double* out, const Operand& a, const Operand& b, const Function& function)
{
  const auto n = static_cast<std::size_t>(count);
  // With strides that the compiler knows, the loops over arrays become lanes.
  if (a.stride == 1 && b.stride == 1)
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      out[i] = function(a.values[i], b.values[i]);
    }
  }
  else
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      out[i] = function(a[i], b[i]);
    }
  }
}

void RunEigen(Operation operation, int number, int component, std::span<const Operand> arguments,
  int count, double* out)
{
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
  {
    std::array<double, 6> matrix{};
    for (std::size_t k = 0; k < matrix.size(); ++k)
    {
      matrix[k] = arguments[k][i];
    }
    const SymmetricEigen eigen(matrix);
    out[i] =
      operation == Operation::Eigenvalue ? eigen.Value(number) : eigen.Vector(number)[component];
  }
}

void RunStep(Operation operation, std::span<const Operand> arguments, int count, double* out)
{
  const Operand& a = arguments[0];
  const Operand& b = arguments[1];
  switch (operation)
  {
    case Operation::Add:
      ForAll(count, out, a, b, [](double x, double y) { return x + y; });
      return;
    case Operation::Subtract:
      ForAll(count, out, a, b, [](double x, double y) { return x - y; });
      return;
    case Operation::Multiply:
      ForAll(count, out, a, b, [](double x, double y) { return x * y; });
      return;
    case Operation::Divide:
      ForAll(count, out, a, b, [](double x, double y) { return x / y; });
      return;
    case Operation::Negate:
      ForAll(count, out, a, a, [](double x, double /*y*/) { return -x; });
      return;
    case Operation::Sqrt:
      ForAll(count, out, a, a, [](double x, double /*y*/) { return std::sqrt(x); });
      return;
    default:
      for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
      {
        out[i] = Apply(operation, a[i], b[i], arguments[2][i]);
      }
  }
}
} // namespace

Program::Program(const Graph& graph, std::vector<int> outputs)
{
  const std::vector<int> needed = graph.NeededFor(outputs);
  std::map<int, int> uses; // that are still to come
  for (const int node : needed)
  {
    for (const int argument : graph.At(node).arguments)
    {
      if (argument >= 0)
      {
        ++uses[argument];
      }
    }
  }
  for (const int output : outputs)
  {
    ++uses[output]; // at the end: its register is never free
  }
  std::map<int, Place> places;
  std::vector<std::size_t> unused;
  for (const int number : needed)
  {
    const Graph::Node& node = graph.At(number);
    Place& place = places[number];
    if (node.operation == Operation::Constant)
    {
      place = { Place::Kind::Constant, Constants.size() };
      Constants.push_back(node.constant);
      continue;
    }
    if (ArgumentsOf(node) == 0)
    {
      place = { Place::Kind::Leaf, LeafNodes.size() };
      LeafNodes.push_back(node);
      continue;
    }
    Step step{ .operation = node.operation, .a = node.a, .b = node.b };
    for (std::size_t k = 0; k < node.arguments.size(); ++k)
    {
      // Where an operation takes fewer arguments, the first one replaces the others.
      const int argument = node.arguments[k] >= 0 ? node.arguments[k] : node.arguments[0];
      step.arguments[k] = places.at(argument);
      if (node.arguments[k] >= 0 && --uses[argument] == 0 &&
        step.arguments[k].kind == Place::Kind::Register)
      {
        unused.push_back(step.arguments[k].index);
      }
    }
    if (unused.empty())
    {
      unused.push_back(Registers++);
    }
    step.result = unused.back();
    unused.pop_back();
    place = { Place::Kind::Register, step.result };
    Steps.push_back(step);
  }
  std::ranges::transform(
    outputs, std::back_inserter(Outputs), [&places](int node) { return places.at(node); });
}

void Program::Run(std::span<const double* const> leaves, int count, double* const* out,
  std::vector<double>& scratch) const
{
  const auto n = static_cast<std::size_t>(count);
  scratch.resize(std::max(scratch.size(), Registers * n));
  const auto operandOf = [&](const Place& place) -> Operand
  {
    switch (place.kind)
    {
      case Place::Kind::Leaf:
        return { leaves[place.index], 1 };
      case Place::Kind::Constant:
        return { &Constants[place.index], 0 };
      default:
        return { &scratch[place.index * n], 1 };
    }
  };
  for (const Step& step : Steps)
  {
    std::array<Operand, Graph::kMaxArguments> arguments{};
    std::ranges::transform(step.arguments, arguments.begin(), operandOf);
    double* const result = &scratch[step.result * n];
    if (step.operation == Operation::Eigenvalue || step.operation == Operation::Eigenvector)
    {
      RunEigen(step.operation, step.a, step.b, arguments, count, result);
    }
    else
    {
      RunStep(step.operation, arguments, count, result);
    }
  }
  for (std::size_t k = 0; k < Outputs.size(); ++k)
  {
    const Operand values = operandOf(Outputs[k]);
    for (std::size_t i = 0; i < n; ++i)
    {
      out[k][i] = values[i];
    }
  }
}
} // namespace pixelexact
