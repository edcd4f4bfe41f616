// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/Tensor.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <map>
#include <utility>

namespace pixelexact
{
namespace
{
constexpr int kDimensions = 3;

void RequireVector(const Tensor& a, const std::string& what)
{
  if (a.rank != 1 || a.rows < 2 || a.rows > kDimensions)
  {
    throw InvalidData(
      what + " takes vectors of 2 or 3 components, not " + NameOf(a) + "; make one with vec(...)");
  }
}

void RequireSquare(const Tensor& a, const std::string& what)
{
  if (a.rank != 2 || a.rows != a.columns)
  {
    throw InvalidData(what + " takes square matrices, not " + NameOf(a) +
      "; grad of a vector and hessian of a scalar are some");
  }
}
} // namespace

Tensor ScalarOf(int node)
{
  return { .nodes = { node } };
}

Tensor VectorOf(std::vector<int> nodes)
{
  const auto rows = static_cast<int>(nodes.size());
  return { .rank = 1, .rows = rows, .nodes = std::move(nodes) };
}

void RequireScalar(const Tensor& tensor, const std::string& what)
{
  if (!tensor.IsScalar())
  {
    throw InvalidData(what + " takes scalars, not " + NameOf(tensor) +
      "; mag(...) is the length of a vector, and v.x, v[0] or m[0,1] is a component");
  }
}

std::string NameOf(const Tensor& tensor)
{
  if (tensor.rank == 0)
  {
    return "a scalar";
  }
  const std::string rows = std::to_string(tensor.rows);
  return tensor.rank == 1 ? "a vector of " + rows + " components"
                          : "a matrix of " + rows + " x " + std::to_string(tensor.columns);
}

Tensor TensorAlgebra::Widened(const Tensor& a, int rows)
{
  Tensor wide = a;
  while (wide.rank == 1 && wide.rows < rows)
  {
    wide.nodes.push_back(Number(0.0));
    ++wide.rows;
  }
  return wide;
}

Tensor TensorAlgebra::Add(const Tensor& a, const Tensor& b, Operation operation)
{
  Tensor left = a;
  Tensor right = b;
  if (a.rank == 1 && b.rank == 1 && std::max(a.rows, b.rows) == kDimensions &&
    std::min(a.rows, b.rows) == kDimensions - 1)
  {
    left = Widened(a, kDimensions);
    right = Widened(b, kDimensions);
  }
  if (left.rank != right.rank || left.rows != right.rows || left.columns != right.columns)
  {
    throw InvalidData(NameOf(a) + " and " + NameOf(b) + " do not add up");
  }
  for (std::size_t k = 0; k < left.nodes.size(); ++k)
  {
    left.nodes[k] = Scalars.Of(operation, left.nodes[k], right.nodes[k]);
  }
  return left;
}

Tensor TensorAlgebra::Scale(const Tensor& a, int factor)
{
  Tensor scaled = a;
  for (int& node : scaled.nodes)
  {
    node = Scalars.Of(Operation::Multiply, node, factor);
  }
  return scaled;
}

Tensor TensorAlgebra::Product(const Tensor& a, const Tensor& b)
{
  if (a.IsScalar() || b.IsScalar())
  {
    return a.IsScalar() ? Scale(b, a.At(0)) : Scale(a, b.At(0));
  }
  if (a.rank == 1)
  {
    throw InvalidData(NameOf(a) + " and " + NameOf(b) +
      " have no product *; write dot(a, b), cross(a, b) or outer(a, b)");
  }
  const Tensor right = Widened(b, a.columns);
  if (a.columns != right.rows)
  {
    throw InvalidData(NameOf(a) + " and " + NameOf(b) + " have no product");
  }
  Tensor product{ .rank = right.rank, .rows = a.rows, .columns = right.columns };
  for (int i = 0; i < a.rows; ++i)
  {
    for (int j = 0; j < right.columns; ++j)
    {
      int sum = Number(0.0);
      for (int k = 0; k < a.columns; ++k)
      {
        sum = Scalars.Of(
          Operation::Add, sum, Scalars.Of(Operation::Multiply, a.At(i, k), right.At(k, j)));
      }
      product.nodes.push_back(sum);
    }
  }
  return product;
}

Tensor TensorAlgebra::Transpose(const Tensor& a)
{
  if (a.rank != 2)
  {
    throw InvalidData("transpose takes matrices, not " + NameOf(a));
  }
  Tensor turned{ .rank = 2, .rows = a.columns, .columns = a.rows };
  for (int i = 0; i < a.columns; ++i)
  {
    for (int j = 0; j < a.rows; ++j)
    {
      turned.nodes.push_back(a.At(j, i));
    }
  }
  return turned;
}

int TensorAlgebra::Dot(const Tensor& a, const Tensor& b)
{
  const Tensor left = Widened(a, b.rank == 1 ? b.rows : 0);
  const Tensor right = Widened(b, left.rank == 1 ? left.rows : 0);
  if (left.IsScalar() || left.rank != right.rank || left.nodes.size() != right.nodes.size())
  {
    throw InvalidData("dot takes two vectors or two matrices of the same size, not " + NameOf(a) +
      " and " + NameOf(b));
  }
  int sum = Number(0.0);
  for (std::size_t k = 0; k < left.nodes.size(); ++k)
  {
    sum = Scalars.Of(
      Operation::Add, sum, Scalars.Of(Operation::Multiply, left.nodes[k], right.nodes[k]));
  }
  return sum;
}

int TensorAlgebra::Trace(const Tensor& a)
{
  RequireSquare(a, "tr");
  int sum = Number(0.0);
  for (int i = 0; i < a.rows; ++i)
  {
    sum = Scalars.Of(Operation::Add, sum, a.At(i, i));
  }
  return sum;
}

int TensorAlgebra::Determinant(const Tensor& a)
{
  RequireSquare(a, "det");
  const auto product = [this](int x, int y) { return Scalars.Of(Operation::Multiply, x, y); };
  const auto minus = [this](int x, int y) { return Scalars.Of(Operation::Subtract, x, y); };
  if (a.rows == 2)
  {
    return minus(product(a.At(0, 0), a.At(1, 1)), product(a.At(0, 1), a.At(1, 0)));
  }
  if (a.rows != kDimensions)
  {
    throw InvalidData("det takes matrices of 2 x 2 or 3 x 3, not " + NameOf(a));
  }
  int sum = Number(0.0);
  for (int j = 0; j < kDimensions; ++j)
  {
    const int k = (j + 1) % kDimensions;
    const int l = (j + 2) % kDimensions;
    const int minor = minus(product(a.At(1, k), a.At(2, l)), product(a.At(1, l), a.At(2, k)));
    sum = Scalars.Of(Operation::Add, sum, product(a.At(0, j), minor));
  }
  return sum;
}

Tensor TensorAlgebra::Cross(const Tensor& a, const Tensor& b)
{
  RequireVector(a, "cross");
  RequireVector(b, "cross");
  const Tensor left = Widened(a, kDimensions);
  const Tensor right = Widened(b, kDimensions);
  Tensor cross{ .rank = 1, .rows = kDimensions };
  for (int i = 0; i < kDimensions; ++i)
  {
    const int j = (i + 1) % kDimensions;
    const int k = (i + 2) % kDimensions;
    cross.nodes.push_back(
      Scalars.Of(Operation::Subtract, Scalars.Of(Operation::Multiply, left.At(j), right.At(k)),
        Scalars.Of(Operation::Multiply, left.At(k), right.At(j))));
  }
  return cross;
}

Tensor TensorAlgebra::Gradient(const Tensor& a)
{
  if (a.rank == 2)
  {
    throw InvalidData("grad takes scalars and vectors, not " + NameOf(a));
  }
  // The matrix is square, also for fields of the plane.
  const Tensor of = a.rows == kDimensions - 1 ? Widened(a, kDimensions) : a;
  Tensor gradient{ .rank = a.rank + 1,
    .rows = a.rank == 0 ? kDimensions : of.rows,
    .columns = a.rank == 0 ? 1 : kDimensions };
  for (const int node : of.nodes)
  {
    for (int d = 0; d < kDimensions; ++d)
    {
      gradient.nodes.push_back(Scalars.Derivative(node, d));
    }
  }
  return gradient;
}

Tensor TensorAlgebra::Curl(const Tensor& a)
{
  RequireVector(a, "curl");
  const auto slope = [&](int i, int d) { return Scalars.Derivative(a.At(i), d); };
  if (a.rows == 2)
  {
    return ScalarOf(Scalars.Of(Operation::Subtract, slope(1, 0), slope(0, 1)));
  }
  Tensor curl{ .rank = 1, .rows = kDimensions };
  for (int i = 0; i < kDimensions; ++i)
  {
    const int j = (i + 1) % kDimensions;
    const int k = (i + 2) % kDimensions;
    curl.nodes.push_back(Scalars.Of(Operation::Subtract, slope(k, j), slope(j, k)));
  }
  return curl;
}

Tensor TensorAlgebra::Symmetric(const Tensor& a)
{
  RequireSquare(a, "sym");
  return Scale(Add(a, Transpose(a)), Number(0.5));
}

Tensor TensorAlgebra::Eigenvalues(const Tensor& a)
{
  RequireSquare(a, "eig");
  if (a.rows != kDimensions || a.nodes != Transpose(a).nodes)
  {
    throw InvalidData("eig takes symmetric matrices of 3 x 3; sym(...) makes one of " + NameOf(a));
  }
  const std::array<int, 6> entries{ a.At(0, 0), a.At(1, 1), a.At(2, 2), a.At(0, 1), a.At(1, 2),
    a.At(0, 2) };
  Tensor values{ .rank = 1, .rows = kDimensions };
  for (int number = 0; number < kDimensions; ++number)
  {
    values.nodes.push_back(Scalars.Eigen(Operation::Eigenvalue, entries, number));
  }
  return values;
}

Tensor TensorAlgebra::Operate(const std::string& sign, const Tensor& a, const Tensor& b)
{
  if (sign == "+" || sign == "-")
  {
    return Add(a, b, sign == "+" ? Operation::Add : Operation::Subtract);
  }
  if (sign == "*")
  {
    return Product(a, b);
  }
  if (sign == "/")
  {
    RequireScalar(b, "a divisor");
    Tensor quotient = a;
    for (int& node : quotient.nodes)
    {
      node = Scalars.Of(Operation::Divide, node, b.At(0));
    }
    return quotient;
  }
  RequireScalar(a, sign);
  RequireScalar(b, sign);
  static const std::map<std::string, std::pair<Operation, bool>> kOperations{
    { "^", { Operation::Power, false } },
    { "<", { Operation::Less, false } },
    { "<=", { Operation::AtMost, false } },
    { ">", { Operation::Less, true } },
    { ">=", { Operation::AtMost, true } },
    { "==", { Operation::Equal, false } },
    { "!=", { Operation::NotEqual, false } },
    { "&&", { Operation::And, false } },
    { "||", { Operation::Or, false } },
  };
  const auto [operation, isTurned] = kOperations.at(sign);
  return ScalarOf(
    isTurned ? Scalars.Of(operation, b.At(0), a.At(0)) : Scalars.Of(operation, a.At(0), b.At(0)));
}

Tensor TensorAlgebra::Operate(const std::string& sign, const Tensor& a)
{
  Tensor result = a;
  if (sign == "!")
  {
    RequireScalar(a, sign);
  }
  for (int& node : result.nodes)
  {
    node = Scalars.Of(sign == "!" ? Operation::Not : Operation::Negate, node);
  }
  return result;
}

Tensor TensorAlgebra::Index(const Tensor& tensor, std::span<const int> index)
{
  const auto require = [&](int i, int count)
  {
    if (i >= count)
    {
      throw InvalidData("there is no number " + std::to_string(i) + " in " + NameOf(tensor) +
        "; they count from 0");
    }
  };
  if (tensor.IsScalar() || static_cast<int>(index.size()) > tensor.rank)
  {
    throw InvalidData(NameOf(tensor) + " has no [" +
      (index.size() > 1 ? std::string("i, j") : std::string("i")) + "]");
  }
  require(index[0], tensor.rows);
  if (tensor.rank == 1)
  {
    return ScalarOf(tensor.At(index[0]));
  }
  if (index.size() == 2)
  {
    require(index[1], tensor.columns);
    return ScalarOf(tensor.At(index[0], index[1]));
  }
  std::vector<int> row;
  row.reserve(static_cast<std::size_t>(tensor.columns));
  for (int j = 0; j < tensor.columns; ++j)
  {
    row.push_back(tensor.At(index[0], j));
  }
  return VectorOf(std::move(row));
}
} // namespace pixelexact
