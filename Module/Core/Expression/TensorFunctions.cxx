// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Core/Expression/Tensor.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <utility>

// The functions of expressions. Definitions:
//
//   strain(v) = (grad v + grad v') / 2, spin W = (grad v - grad v') / 2
//   Q(v) = (|W|^2 - |strain|^2) / 2                     (Hunt, Wray and Moin, 1988)
//   lambda2(v): the middle eigenvalue of strain^2 + W^2 (Jeong and Hussain, JFM 285, 1995)
//   vonMises(s) = sqrt(3/2 s_d : s_d), s_d the deviator of the stress s; of a displacement, of
//   s = lambda tr(strain) I + 2 mu strain (of one in the plane: plane strain)
namespace pixelexact
{
namespace
{
using Arguments = std::span<const Tensor>;

struct TensorFunction
{
  std::size_t fewest = 1;
  std::size_t most = 1;
  std::function<Tensor(TensorAlgebra&, Arguments)> of;
};
using FunctionTable = std::map<std::string, TensorFunction>;

constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();

int Scalar(const Tensor& a, const std::string& function)
{
  RequireScalar(a, function);
  return a.At(0);
}

int Squares(TensorAlgebra& algebra, const Tensor& a)
{
  return a.IsScalar() ? algebra.GetGraph().Of(Operation::Multiply, a.At(0), a.At(0))
                      : algebra.Dot(a, a);
}

Tensor Number(TensorAlgebra& algebra, double value)
{
  return ScalarOf(algebra.GetGraph().Constant(value));
}

Tensor Magnitude(TensorAlgebra& algebra, const Tensor& a)
{
  Graph& graph = algebra.GetGraph();
  return ScalarOf(a.IsScalar() ? graph.Of(Operation::Abs, a.At(0))
                               : graph.Of(Operation::Sqrt, Squares(algebra, a)));
}

Tensor Jump(TensorAlgebra& algebra, const Tensor& a)
{
  Tensor jump = a;
  std::ranges::transform(
    a.nodes, jump.nodes.begin(), [&](int node) { return algebra.GetGraph().Jump(node); });
  return jump;
}

Tensor Spin(TensorAlgebra& algebra, const Tensor& a)
{
  return algebra.Scale(
    algebra.Add(a, algebra.Transpose(a), Operation::Subtract), algebra.GetGraph().Constant(0.5));
}

Tensor GradientOfVector(TensorAlgebra& algebra, const Tensor& v, const std::string& function)
{
  if (v.rank != 1 || v.rows < 2 || v.rows > 3)
  {
    throw InvalidData(function + " takes a vector of 2 or 3 components, not " + NameOf(v) +
      "; make one of components with vec(u, v, w)");
  }
  return algebra.Gradient(v);
}

Tensor Strain(TensorAlgebra& algebra, const Tensor& v, const std::string& function)
{
  return algebra.Symmetric(GradientOfVector(algebra, v, function));
}

Tensor Identity(TensorAlgebra& algebra)
{
  Tensor identity{ .rank = 2, .rows = 3, .columns = 3 };
  for (int k = 0; k < 9; ++k)
  {
    identity.nodes.push_back(algebra.GetGraph().Constant(k % 4 == 0 ? 1.0 : 0.0));
  }
  return identity;
}

Tensor TensorOfComponents(const Tensor& a)
{
  const auto at = [&a](int k) { return a.At(k); };
  if (a.rank == 1 && a.rows == 6)
  {
    return { .rank = 2,
      .rows = 3,
      .columns = 3,
      .nodes = { at(0), at(3), at(5), at(3), at(1), at(4), at(5), at(4), at(2) } };
  }
  if (a.rank == 1 && (a.rows == 9 || a.rows == 4))
  {
    const int rows = a.rows == 9 ? 3 : 2;
    return { .rank = 2, .rows = rows, .columns = rows, .nodes = a.nodes };
  }
  throw InvalidData("tensor takes a vector of 9 components, of 6 (xx, yy, zz, xy, yz, xz) or of 4, "
                    "not " +
    NameOf(a));
}

Tensor VonMises(TensorAlgebra& algebra, Arguments a)
{
  Tensor stress = a[0];
  if (a.size() == 3)
  {
    const Tensor strain = Strain(algebra, a[0], "vonMises");
    const Tensor pressure = algebra.Scale(Identity(algebra), algebra.Trace(strain));
    stress = algebra.Add(algebra.Scale(pressure, Scalar(a[1], "vonMises")),
      algebra.Scale(strain, algebra.Scale(Number(algebra, 2.0), Scalar(a[2], "vonMises")).At(0)));
  }
  else if (a.size() == 2)
  {
    throw InvalidData("vonMises takes a stress, or a displacement, lambda and mu");
  }
  else if (stress.rank == 1)
  {
    stress = TensorOfComponents(stress);
  }
  if (stress.rank != 2 || stress.rows != 3 || stress.columns != 3)
  {
    throw InvalidData("vonMises takes a stress of 3 x 3 or of 6 components, or a displacement, "
                      "lambda and mu; not " +
      NameOf(a[0]));
  }
  Graph& graph = algebra.GetGraph();
  const int third = graph.Of(Operation::Divide, algebra.Trace(stress), graph.Constant(3.0));
  const Tensor deviator =
    algebra.Add(stress, algebra.Scale(Identity(algebra), third), Operation::Subtract);
  return ScalarOf(graph.Of(Operation::Sqrt,
    graph.Of(Operation::Multiply, graph.Constant(1.5), Squares(algebra, deviator))));
}

Tensor Divergence(TensorAlgebra& algebra, const Tensor& a)
{
  Graph& graph = algebra.GetGraph();
  const auto row = [&](int i)
  {
    int sum = graph.Constant(0.0);
    for (int d = 0; d < a.columns; ++d)
    {
      sum = graph.Of(Operation::Add, sum, graph.Derivative(a.At(i, d), d));
    }
    return sum;
  };
  if (a.rank == 2 && a.columns <= 3)
  {
    std::vector<int> rows;
    rows.reserve(static_cast<std::size_t>(a.rows));
    for (int i = 0; i < a.rows; ++i)
    {
      rows.push_back(row(i));
    }
    return VectorOf(std::move(rows));
  }
  return ScalarOf(algebra.Trace(GradientOfVector(algebra, a, "div")));
}

Tensor Laplacian(TensorAlgebra& algebra, const Tensor& a)
{
  if (a.rank == 2)
  {
    throw InvalidData("laplacian takes scalars and vectors, not " + NameOf(a));
  }
  Graph& graph = algebra.GetGraph();
  Tensor result = a;
  for (int& node : result.nodes)
  {
    int sum = graph.Constant(0.0);
    for (int d = 0; d < 3; ++d)
    {
      sum = graph.Of(Operation::Add, sum, graph.Derivative(graph.Derivative(node, d), d));
    }
    node = sum;
  }
  return result;
}

Tensor HessianMatrix(TensorAlgebra& algebra, const Tensor& a)
{
  return algebra.Gradient(algebra.Gradient(ScalarOf(Scalar(a, "hessian"))));
}

/// The sum of the squares of the strain and the spin.
Tensor SquaresOfStrainAndSpin(TensorAlgebra& algebra, const Tensor& v)
{
  const Tensor gradient = GradientOfVector(algebra, v, "lambda2");
  const Tensor strain = algebra.Symmetric(gradient);
  const Tensor spin = Spin(algebra, gradient);
  // Symmetric but for the order of sums: the upper half stands for both.
  Tensor sum = algebra.Add(algebra.Product(strain, strain), algebra.Product(spin, spin));
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      sum.nodes[static_cast<std::size_t>(3 * i) + static_cast<std::size_t>(j)] = sum.At(j, i);
    }
  }
  return sum;
}

Tensor QCriterion(TensorAlgebra& algebra, const Tensor& v)
{
  const Tensor gradient = GradientOfVector(algebra, v, "Q");
  Graph& graph = algebra.GetGraph();
  // |strain|^2 - |W|^2 is the sum of g_ij g_ji. Their difference would lose digits, and most of the
  // bounds.
  int diagonal = graph.Constant(0.0);
  int mixed = graph.Constant(0.0);
  for (int i = 0; i < gradient.rows; ++i)
  {
    const int g = gradient.At(i, i);
    diagonal = graph.Of(Operation::Add, diagonal, graph.Of(Operation::Multiply, g, g));
    for (int j = 0; j < i; ++j)
    {
      mixed = graph.Of(
        Operation::Add, mixed, graph.Of(Operation::Multiply, gradient.At(i, j), gradient.At(j, i)));
    }
  }
  const int sum =
    graph.Of(Operation::Add, graph.Of(Operation::Multiply, graph.Constant(0.5), diagonal), mixed);
  return ScalarOf(graph.Of(Operation::Negate, sum));
}

Tensor Outer(TensorAlgebra& algebra, const Tensor& a, const Tensor& b)
{
  if (a.rank != 1 || b.rank != 1)
  {
    throw InvalidData("outer takes two vectors, not " + NameOf(a) + " and " + NameOf(b));
  }
  Tensor outer{ .rank = 2, .rows = a.rows, .columns = b.rows };
  for (const int x : a.nodes)
  {
    for (const int y : b.nodes)
    {
      outer.nodes.push_back(algebra.GetGraph().Of(Operation::Multiply, x, y));
    }
  }
  return outer;
}

Tensor VectorOfScalars(Arguments a)
{
  std::vector<int> nodes;
  std::ranges::transform(
    a, std::back_inserter(nodes), [](const Tensor& component) { return Scalar(component, "vec"); });
  return VectorOf(std::move(nodes));
}

void AddScalarFunctions(FunctionTable& table)
{
  const auto unary = [&table](const std::string& name, Operation operation)
  {
    table[name] = { 1, 1, [=](TensorAlgebra& algebra, Arguments a) {
                     return ScalarOf(algebra.GetGraph().Of(operation, Scalar(a[0], name)));
                   } };
  };
  unary("sqrt", Operation::Sqrt);
  unary("exp", Operation::Exp);
  unary("log", Operation::Log);
  unary("sin", Operation::Sin);
  unary("cos", Operation::Cos);
  unary("tan", Operation::Tan);
  unary("asin", Operation::Asin);
  unary("acos", Operation::Acos);
  unary("atan", Operation::Atan);
  unary("sinh", Operation::Sinh);
  unary("cosh", Operation::Cosh);
  unary("tanh", Operation::Tanh);
  unary("erf", Operation::Erf);
  unary("abs", Operation::Abs);
  unary("sign", Operation::Sign);
  unary("floor", Operation::Floor);
  unary("ceil", Operation::Ceil);
  const auto folded =
    [&table](const std::string& name, std::size_t fewest, std::size_t most, Operation operation)
  {
    table[name] = { fewest, most,
      [=](TensorAlgebra& algebra, Arguments a)
      {
        int result = Scalar(a[0], name);
        for (const Tensor& other : a.subspan(1))
        {
          result = algebra.GetGraph().Of(operation, result, Scalar(other, name));
        }
        return ScalarOf(result);
      } };
  };
  folded("min", 2, kAnyNumber, Operation::Min);
  folded("max", 2, kAnyNumber, Operation::Max);
  folded("atan2", 2, 2, Operation::Atan2);
  folded("pow", 2, 2, Operation::Power);
  table["log10"] = { 1, 1,
    [](TensorAlgebra& algebra, Arguments a)
    {
      Graph& graph = algebra.GetGraph();
      return ScalarOf(graph.Of(Operation::Divide, graph.Of(Operation::Log, Scalar(a[0], "log10")),
        graph.Of(Operation::Log, graph.Constant(10.0))));
    } };
  table["where"] = { 3, 3,
    [](TensorAlgebra& algebra, Arguments a)
    {
      const int condition = Scalar(a[0], "the condition of where");
      if (a[1].nodes.size() != a[2].nodes.size() || a[1].rank != a[2].rank)
      {
        throw InvalidData("where chooses between two of the same shape, not " + NameOf(a[1]) +
          " and " + NameOf(a[2]));
      }
      Tensor chosen = a[1];
      for (std::size_t k = 0; k < chosen.nodes.size(); ++k)
      {
        chosen.nodes[k] = algebra.GetGraph().Select(condition, chosen.nodes[k], a[2].nodes[k]);
      }
      return chosen;
    } };
}

void AddTensorFunctions(FunctionTable& table)
{
  const auto of = [&table](const std::string& name, const auto& function)
  {
    table[name] = { 1, 1,
      [function](TensorAlgebra& algebra, Arguments a) { return function(algebra, a[0]); } };
  };
  table["vec"] = { 2, 3, [](TensorAlgebra&, Arguments a) { return VectorOfScalars(a); } };
  table["dot"] = { 2, 2,
    [](TensorAlgebra& algebra, Arguments a) { return ScalarOf(algebra.Dot(a[0], a[1])); } };
  table["cross"] = { 2, 2,
    [](TensorAlgebra& algebra, Arguments a) { return algebra.Cross(a[0], a[1]); } };
  table["outer"] = { 2, 2,
    [](TensorAlgebra& algebra, Arguments a) { return Outer(algebra, a[0], a[1]); } };
  table["vonMises"] = { 1, 3, VonMises };
  of("mag", Magnitude);
  of("jump", Jump);
  of("tensor", [](TensorAlgebra&, const Tensor& a) { return TensorOfComponents(a); });
  of("grad", [](TensorAlgebra& algebra, const Tensor& a) { return algebra.Gradient(a); });
  of("div", Divergence);
  of("curl", [](TensorAlgebra& algebra, const Tensor& a) { return algebra.Curl(a); });
  of("vorticity", [](TensorAlgebra& algebra, const Tensor& a) { return algebra.Curl(a); });
  of("laplacian", Laplacian);
  of("hessian", HessianMatrix);
  of("sym", [](TensorAlgebra& algebra, const Tensor& a) { return algebra.Symmetric(a); });
  of("transpose", [](TensorAlgebra& algebra, const Tensor& a) { return algebra.Transpose(a); });
  of("tr", [](TensorAlgebra& algebra, const Tensor& a) { return ScalarOf(algebra.Trace(a)); });
  of("det",
    [](TensorAlgebra& algebra, const Tensor& a) { return ScalarOf(algebra.Determinant(a)); });
  of("eig", [](TensorAlgebra& algebra, const Tensor& a) { return algebra.Eigenvalues(a); });
  of(
    "strain", [](TensorAlgebra& algebra, const Tensor& a) { return Strain(algebra, a, "strain"); });
  of("Q", QCriterion);
  of("lambda2",
    [](TensorAlgebra& algebra, const Tensor& a)
    { return ScalarOf(algebra.Eigenvalues(SquaresOfStrainAndSpin(algebra, a)).At(1)); });
}

const FunctionTable& Table()
{
  static const FunctionTable table = []
  {
    FunctionTable made;
    AddScalarFunctions(made);
    AddTensorFunctions(made);
    return made;
  }();
  return table;
}
} // namespace

std::string TensorAlgebra::Functions()
{
  std::string names;
  for (const auto& [name, function] : Table())
  {
    names += (names.empty() ? "" : " ") + name;
  }
  return names;
}

Tensor TensorAlgebra::Call(const std::string& function, std::span<const Tensor> arguments)
{
  const auto found = Table().find(function);
  if (found == Table().end())
  {
    throw InvalidData("there is no function '" + function + "'; there are " + Functions());
  }
  const TensorFunction& entry = found->second;
  if (arguments.size() < entry.fewest || arguments.size() > entry.most)
  {
    const std::string many = entry.most == kAnyNumber ? " or more"
      : entry.most > entry.fewest                     ? " to " + std::to_string(entry.most)
                                                      : "";
    throw InvalidData(function + " takes " + std::to_string(entry.fewest) + many +
      (entry.most == 1 ? " argument" : " arguments") + ", not " + std::to_string(arguments.size()));
  }
  return entry.of(*this, arguments);
}
} // namespace pixelexact
