// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/Graph.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <array>

// The chain rule, node by node.
namespace pixelexact
{
int Graph::Product(int a, int b)
{
  // Right for derivatives alone: zero times a factor that may be infinite is zero here.
  return IsConstant(a, 0.0) || IsConstant(b, 0.0) ? Constant(0.0) : Of(Operation::Multiply, a, b);
}

int Graph::Derivative(int node, int d)
{
  if (const auto known = Derivatives.find({ node, d }); known != Derivatives.end())
  {
    return known->second;
  }
  const int derivative = MakeDerivative(node, d);
  Derivatives[{ node, d }] = derivative;
  return derivative;
}

int Graph::DerivativeOfLeafByXi(const Node& leaf, int k)
{
  // Adds a direction to a leaf with the first direction or with none.
  const auto with = [&](Operation operation, int Node::*first, int Node::*second)
  {
    Node node = leaf;
    node.operation = operation;
    if (leaf.operation != operation)
    {
      node.*first = k;
      node.*second = -1;
    }
    else if (leaf.*second >= 0)
    {
      throw Unsupported("third derivatives by xi are not available");
    }
    else
    {
      node.*first = std::min(leaf.*first, k);
      node.*second = std::max(leaf.*first, k);
    }
    return Leaf(node);
  };
  switch (leaf.operation)
  {
    case Operation::Constant:
    case Operation::Pi:
    case Operation::ElementNumber:
    case Operation::Order:
      return Constant(0.0);
    case Operation::Reference:
      return Constant(leaf.a == k ? 1.0 : 0.0);
    case Operation::Coordinate:
    case Operation::CoordinateByXi:
      return with(Operation::CoordinateByXi, &Node::b, &Node::c);
    case Operation::Value:
    case Operation::ValueByXi:
      return with(Operation::ValueByXi, &Node::a, &Node::b);
    case Operation::Slope:
    case Operation::SlopeByXi:
      return with(Operation::SlopeByXi, &Node::b, &Node::c);
    default:
      throw Unsupported("the derivative by xi is not available");
  }
}

int Graph::MakeDerivative(int self, int d)
{
  const Node node = At(self); // a copy: nodes are added below
  if (node.arguments[0] < 0 && d >= kByXi)
  {
    return DerivativeOfLeafByXi(node, d - kByXi);
  }
  const auto& [a, b, c, e, f, g] = node.arguments;
  switch (node.operation)
  {
    case Operation::Coordinate:
      return Constant(node.a == d ? 1.0 : 0.0);
    case Operation::Reference:
      return Leaf({ .operation = Operation::InverseJacobian, .a = node.a, .b = d });
    case Operation::InverseJacobian:
    case Operation::Determinant:
    case Operation::ScaledJacobian:
      throw Unsupported("derivatives of the Jacobian are not available; second derivatives of xi "
                        "and derivatives of detJ and scaledJacobian need them");
    case Operation::Value:
      return Leaf({ .operation = Operation::Slope,
        .field = node.field,
        .component = node.component,
        .a = d });
    case Operation::Slope:
      return Leaf({ .operation = Operation::Curvature,
        .field = node.field,
        .component = node.component,
        .a = std::min(node.a, d),
        .b = std::max(node.a, d) });
    case Operation::Normal:
      throw Unsupported("derivatives of the normal are not available");
    case Operation::Curvature:
      throw Unsupported("third derivatives of fields are not available");
    case Operation::CoordinateByXi:
    case Operation::ValueByXi:
    case Operation::SlopeByXi:
      throw Unsupported("derivatives by xi have no derivatives by x");
    case Operation::Behind:
      throw Unsupported("derivatives of jumps are not available; for the jump of a derivative "
                        "write jump(grad(u))");
    case Operation::Negate:
      return Of(Operation::Negate, Derivative(a, d));
    case Operation::Add:
    case Operation::Subtract:
      return Of(node.operation, Derivative(a, d), Derivative(b, d));
    case Operation::Multiply:
      return Of(Operation::Add, Product(Derivative(a, d), b), Product(a, Derivative(b, d)));
    case Operation::Divide:
    {
      const int da = Derivative(a, d);
      const int db = Derivative(b, d);
      const int top = Of(Operation::Subtract, da, Product(self, db));
      return IsConstant(top, 0.0) ? top : Of(Operation::Divide, top, b);
    }
    case Operation::Power:
    {
      // b a^(b-1) a', and where the exponent changes a^b log(a) b'.
      const int da = Derivative(a, d);
      const int db = Derivative(b, d);
      const int lower = Of(Operation::Power, a, Of(Operation::Subtract, b, Constant(1.0)));
      const int byBase = Product(Product(b, lower), da);
      return IsConstant(db, 0.0)
        ? byBase
        : Of(Operation::Add, byBase, Product(Product(self, Of(Operation::Log, a)), db));
    }
    case Operation::Atan2:
    {
      const int top =
        Of(Operation::Subtract, Product(b, Derivative(a, d)), Product(a, Derivative(b, d)));
      const int squares =
        Of(Operation::Add, Of(Operation::Multiply, a, a), Of(Operation::Multiply, b, b));
      return IsConstant(top, 0.0) ? top : Of(Operation::Divide, top, squares);
    }
    case Operation::Min:
      return Select(Of(Operation::AtMost, a, b), Derivative(a, d), Derivative(b, d));
    case Operation::Max:
      return Select(Of(Operation::AtMost, b, a), Derivative(a, d), Derivative(b, d));
    case Operation::Select:
      return Select(a, Derivative(b, d), Derivative(c, d));
    case Operation::Eigenvalue:
      return OfEigenvalue(node, d);
    case Operation::Eigenvector:
      throw Unsupported("second derivatives of eigenvalues are not available");
    case Operation::Constant:
    case Operation::Pi:
    case Operation::ElementNumber:
    case Operation::Order:
    case Operation::Sign:
    case Operation::Floor:
    case Operation::Ceil:
      return Constant(0.0);
    default:
    {
      if (IsTruth(node.operation))
      {
        return Constant(0.0);
      }
      const int da = Derivative(a, d);
      return IsConstant(da, 0.0) ? da : Product(OfFunction(node, self), da);
    }
  }
}

/// The derivative of a function of one number by that number.
int Graph::OfFunction(const Node& node, int self)
{
  const int a = node.arguments[0];
  const int one = Constant(1.0);
  const auto over = [&](int top, int bottom) { return Of(Operation::Divide, top, bottom); };
  const auto square = [&](int of) { return Of(Operation::Multiply, of, of); };
  const auto rootOfOneMinusSquare = [&]
  { return Of(Operation::Sqrt, Of(Operation::Subtract, one, square(a))); };
  switch (node.operation)
  {
    case Operation::Sqrt:
      return over(Constant(0.5), self);
    case Operation::Exp:
      return self;
    case Operation::Log:
      return over(one, a);
    case Operation::Sin:
      return Of(Operation::Cos, a);
    case Operation::Cos:
      return Of(Operation::Negate, Of(Operation::Sin, a));
    case Operation::Tan:
      return Of(Operation::Add, one, square(self));
    case Operation::Asin:
      return over(one, rootOfOneMinusSquare());
    case Operation::Acos:
      return over(Constant(-1.0), rootOfOneMinusSquare());
    case Operation::Atan:
      return over(one, Of(Operation::Add, one, square(a)));
    case Operation::Sinh:
      return Of(Operation::Cosh, a);
    case Operation::Cosh:
      return Of(Operation::Sinh, a);
    case Operation::Tanh:
      return Of(Operation::Subtract, one, square(self));
    case Operation::Erf:
      return Of(Operation::Multiply,
        over(Constant(2.0), Of(Operation::Sqrt, Leaf({ .operation = Operation::Pi }))),
        Of(Operation::Exp, Of(Operation::Negate, square(a))));
    default: // Abs
      return Of(Operation::Sign, a);
  }
}

/// v' A' v, v the unit eigenvector. For a multiple eigenvalue, v is one of its eigenvectors.
int Graph::OfEigenvalue(const Node& node, int d)
{
  std::array<int, 3> v{};
  for (int i = 0; i < 3; ++i)
  {
    v[static_cast<std::size_t>(i)] = Eigen(Operation::Eigenvector, node.arguments, node.a, i);
  }
  constexpr std::array<std::array<std::size_t, 2>, 6> kEntries{ { { 0, 0 }, { 1, 1 }, { 2, 2 },
    { 0, 1 }, { 1, 2 }, { 0, 2 } } };
  int sum = Constant(0.0);
  for (std::size_t k = 0; k < kEntries.size(); ++k)
  {
    const auto [i, j] = kEntries[k];
    const int change = Derivative(node.arguments[k], d);
    const int twice = i == j ? change : Product(Constant(2.0), change);
    sum = Of(Operation::Add, sum, Product(Of(Operation::Multiply, v[i], v[j]), twice));
  }
  return sum;
}
} // namespace pixelexact
