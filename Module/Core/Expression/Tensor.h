// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Expression/Graph.h"

#include <span>
#include <string>
#include <vector>

namespace pixelexact
{
/// A scalar, a vector or a matrix of nodes of a graph.
struct Tensor
{
  int rank = 0; ///< 0: scalar, 1: vector, 2: matrix
  int rows = 1;
  int columns = 1;          ///< 1 of scalars and vectors
  std::vector<int> nodes{}; ///< row by row

  [[nodiscard]] int At(int row, int column = 0) const
  {
    const int place = row * columns + column;
    return nodes[static_cast<std::size_t>(place)];
  }
  [[nodiscard]] bool IsScalar() const { return rank == 0; }
};

Tensor ScalarOf(int node);
Tensor VectorOf(std::vector<int> nodes);
/// Throws InvalidData, naming `what`, unless the tensor is a scalar.
void RequireScalar(const Tensor& tensor, const std::string& what);
/// "a scalar", "a vector of 3 components", "a matrix of 3 x 3".
std::string NameOf(const Tensor& tensor);

/// Builds the nodes of operations on tensors. All functions throw InvalidData where shapes do not
/// fit together. A vector of two components (a field of the plane) gets a third one of 0 where it
/// meets a vector of three.
class TensorAlgebra
{
public:
  explicit TensorAlgebra(Graph& graph)
    : Scalars(graph)
  {
  }

  /// The operator of the text, of two operands or of one.
  Tensor Operate(const std::string& sign, const Tensor& a, const Tensor& b);
  Tensor Operate(const std::string& sign, const Tensor& a);
  /// v[i], m[i, j], m[i]: a row.
  Tensor Index(const Tensor& tensor, std::span<const int> index);
  /// A function of the language; names that are none, and numbers of arguments that do not fit,
  /// throw as well.
  Tensor Call(const std::string& function, std::span<const Tensor> arguments);
  /// Names of all functions, for messages.
  static std::string Functions();

  // Elementary operations.
  Tensor Add(const Tensor& a, const Tensor& b, Operation operation = Operation::Add);
  Tensor Scale(const Tensor& a, int factor);
  Tensor Product(const Tensor& a, const Tensor& b);
  Tensor Transpose(const Tensor& a);
  int Dot(const Tensor& a, const Tensor& b); ///< of matrices, of all entries
  int Trace(const Tensor& a);
  int Determinant(const Tensor& a);
  Tensor Cross(const Tensor& a, const Tensor& b);
  /// A vector for a scalar, and for a vector the matrix of d v_i / d x_j.
  Tensor Gradient(const Tensor& a);
  Tensor Curl(const Tensor& a);
  Tensor Symmetric(const Tensor& a);
  Tensor Eigenvalues(const Tensor& a);

  [[nodiscard]] Graph& GetGraph() { return Scalars; }

private:
  int Number(double value) { return Scalars.Constant(value); }
  Tensor Widened(const Tensor& a, int rows);

  Graph& Scalars;
};
} // namespace pixelexact
