// SPDX-License-Identifier: BSD-3-Clause
#include "MeshBuilder.h"

#include "Core/Expression/OuterFunctions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

// Functions that an expression applies last, and their inverses, in long double.
namespace pixelexact::testing
{
namespace
{
using Long = long double;

/// h of a node G.
struct Chain
{
  std::string text;
  std::function<int(Graph&, int)> build;
  std::function<double(double)> rounded; ///< as programs compute it
  std::function<Long(Long)> inverse;
};

const Chain kChains[] = {
  { "sqrt", [](Graph& graph, int g) { return graph.Of(pixelexact::Operation::Sqrt, g); },
    [](double g) { return std::sqrt(g); }, [](Long v) { return v * v; } },
  { "3 - sqrt / 7",
    [](Graph& graph, int g)
    {
      const int root = graph.Of(pixelexact::Operation::Sqrt, g);
      return graph.Of(pixelexact::Operation::Subtract, graph.Constant(3.0),
        graph.Of(pixelexact::Operation::Divide, root, graph.Constant(7.0)));
    },
    [](double g) { return 3.0 - std::sqrt(g) / 7.0; },
    [](Long v) { return 49.0L * (3.0L - v) * (3.0L - v); } },
  { "0.3 exp + 1e-3",
    [](Graph& graph, int g)
    {
      return graph.Of(pixelexact::Operation::Add,
        graph.Of(pixelexact::Operation::Multiply, graph.Constant(0.3),
          graph.Of(pixelexact::Operation::Exp, g)),
        graph.Constant(1e-3));
    },
    [](double g) { return 0.3 * std::exp(g) + 1e-3; },
    [](Long v) { return std::log((v - static_cast<Long>(1e-3)) / static_cast<Long>(0.3)); } },
  { "log", [](Graph& graph, int g) { return graph.Of(pixelexact::Operation::Log, g); },
    [](double g) { return std::log(g); }, [](Long v) { return std::exp(v); } },
};

/// A node that is not negative by its operations.
int SquareIn(Graph& graph)
{
  const int u = graph.Leaf({ .operation = pixelexact::Operation::Value, .field = 0 });
  return graph.Of(pixelexact::Operation::Multiply, u, u);
}
} // namespace

TEST(OuterFunctions, InversesStayWithinTheirErrors)
{
  Random random(91);
  for (const Chain& chain : kChains)
  {
    SCOPED_TRACE(chain.text);
    Graph graph;
    const int inner = SquareIn(graph);
    const OuterFunctions outer(graph, chain.build(graph, inner));
    EXPECT_EQ(outer.Inner(), inner);
    for (int k = 0; k < 2000; ++k)
    {
      const double g = std::pow(10.0, random(-6.0, 1.0));
      const double error = outer.ErrorOver({ 0.5 * g, g });
      const double value = chain.rounded(g);
      EXPECT_LE(std::fabs(outer.Invert(value) - g), error);
      EXPECT_LE(std::fabs(static_cast<Long>(outer.Invert(value)) - chain.inverse(value)), error);
      EXPECT_LT(error, 1e-12 * (1.0 + g) * (chain.text == "0.3 exp + 1e-3" ? 10.0 : 1.0));
    }
  }
}

TEST(OuterFunctions, ValuesOutsideOfTheRangeAreInfinite)
{
  Graph graph;
  const int inner = SquareIn(graph);
  const double infinity = std::numeric_limits<double>::infinity();
  const OuterFunctions root(graph, graph.Of(pixelexact::Operation::Sqrt, inner));
  EXPECT_EQ(root.Invert(-1.0), -infinity);
  EXPECT_EQ(root.Invert(0.0), 0.0);
  const OuterFunctions falling(
    graph, graph.Of(pixelexact::Operation::Negate, graph.Of(pixelexact::Operation::Exp, inner)));
  EXPECT_EQ(falling.Invert(1.0), -infinity);
  EXPECT_EQ(falling.Invert(-1.0), 0.0);
}

/// The root of a node that may be negative is undefined there, and stays.
TEST(OuterFunctions, RootsOfOtherNodesStay)
{
  Graph graph;
  const int u = graph.Leaf({ .operation = pixelexact::Operation::Value, .field = 0 });
  for (const pixelexact::Operation operation :
    { pixelexact::Operation::Sqrt, pixelexact::Operation::Log, pixelexact::Operation::Sin })
  {
    const int node = graph.Of(operation, u);
    const OuterFunctions outer(graph, node);
    EXPECT_EQ(outer.Inner(), node);
    EXPECT_EQ(outer.Invert(0.25), 0.25);
    EXPECT_EQ(outer.ErrorOver({ 0.0, 1.0 }), 0.0);
  }
}
} // namespace pixelexact::testing
