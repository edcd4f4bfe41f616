// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace pixelexact
{
/// The operation that computes a node of a Graph. Operations before Negate have no arguments.
enum class Operation : std::uint8_t
{
  Constant,
  Pi,
  Coordinate,      ///< x_a
  Reference,       ///< xi_a
  InverseJacobian, ///< d xi_a / d x_b
  Determinant,     ///< det J, J = d Phi / d xi in world units
  ScaledJacobian,  ///< det J over the product of the lengths of J's columns
  ElementNumber,
  Normal,    ///< n_a, of the surface
  Order,     ///< of field f (-1: of all fields) in the element, along xi_{a-1}; a = 0: the highest
  Value,     ///< component c of field f
  Slope,     ///< its derivative by x_a
  Curvature, ///< its second derivative by x_a and x_b, a <= b
  // Derivatives by xi, of bounds alone (BoxLeaves). Those without a second direction have -1.
  CoordinateByXi, ///< of x_a, by xi_b and xi_c
  ValueByXi,      ///< of component c of field f, by xi_a and xi_b
  SlopeByXi,      ///< of its derivative by x_a, by xi_b and xi_c
  Behind, ///< node a in the element behind the face that the point is on; NaN where there is none
  Negate,
  Not,
  Sqrt,
  Exp,
  Log,
  Sin,
  Cos,
  Tan,
  Asin,
  Acos,
  Atan,
  Sinh,
  Cosh,
  Tanh,
  Erf,
  Abs,
  Sign, ///< -1, 0 or 1; NaN of NaN
  Floor,
  Ceil,
  Add,
  Subtract,
  Multiply,
  Divide,
  Power,
  Atan2,
  Min, ///< NaN where one is
  Max,
  Less, ///< comparisons and logic: 1 or 0
  AtMost,
  Equal,
  NotEqual,
  And,
  Or,
  Select,      ///< of three: the second where the first is not 0, else the third; NaN of NaN
  Eigenvalue,  ///< number a, 0 the largest, of the symmetric matrix xx, yy, zz, xy, yz, xz
  Eigenvector, ///< component b of unit eigenvector number a of the same
};

/// A directed acyclic graph of scalars at a point. Each node is computed from its arguments, and
/// equal nodes exist once. Nodes are referred to by index; arguments have lower indices.
class Graph
{
public:
  static constexpr int kMaxArguments = 6;
  /// A graph with more nodes throws InvalidData.
  static constexpr std::size_t kMaxNodes = 20'000;

  struct Node
  {
    Operation operation = Operation::Constant;
    double constant = 0.0;
    std::array<int, kMaxArguments> arguments{ -1, -1, -1, -1, -1, -1 };
    int field = -1;
    int component = 0;
    int a = 0;
    int b = 0;
    int c = 0;

    /// Nodes are equal where all bits are: -0 is not 0.
    bool operator<(const Node& other) const;
  };

  [[nodiscard]] const Node& At(int node) const { return Nodes[static_cast<std::size_t>(node)]; }
  [[nodiscard]] int Size() const { return static_cast<int>(Nodes.size()); }

  int Constant(double value);
  /// Adds a node that has no arguments.
  int Leaf(const Node& node);
  /// Constants are folded where that is exact, factors of one and added zeros left out.
  int Of(Operation operation, int a);
  int Of(Operation operation, int a, int b);
  int Select(int condition, int yes, int no);
  int Eigen(Operation operation, const std::array<int, 6>& matrix, int number, int component = 0);
  /// Returns the difference of a node's values behind the point's face and at the point.
  int Jump(int node);

  /// Returns d node / d x_d by the chain rule. Functions with steps (sign, floor, comparisons) are
  /// differentiated away from the steps. Throws Unsupported for third derivatives of fields and for
  /// derivatives of det J, of normals, of eigenvectors and of jumps.
  int Derivative(int node, int d);
  /// Returns d node / d xi_k in the same way. There are second ones of coordinates, fields and of
  /// their first derivatives by x; others throw Unsupported.
  int DerivativeByXi(int node, int k) { return Derivative(node, kByXi + k); }

  /// Returns `nodes` and all nodes that they are computed from, each after its arguments.
  [[nodiscard]] std::vector<int> NeededFor(std::span<const int> nodes) const;

  [[nodiscard]] bool IsConstant(int node, double value) const
  {
    return At(node).operation == Operation::Constant && At(node).constant == value;
  }

private:
  int Insert(const Node& node);
  int Product(int a, int b);
  /// `d`: number of x, or kByXi and the number of xi.
  static constexpr int kByXi = 3;
  int MakeDerivative(int self, int d);
  int DerivativeOfLeafByXi(const Node& leaf, int k);
  int OfFunction(const Node& node, int self);
  int OfEigenvalue(const Node& node, int d);

  std::vector<Node> Nodes;
  std::map<Node, int> Known;
  std::map<std::array<int, 2>, int> Derivatives;
};

/// Whether the operation's values are 1 and 0: comparisons and logic.
[[nodiscard]] constexpr bool IsTruth(Operation operation)
{
  return operation == Operation::Not ||
    (operation >= Operation::Less && operation <= Operation::Or);
}

/// Computes an operation on numbers; arguments that it does not have are ignored. Leaves,
/// Eigenvalue and Eigenvector give NaN.
[[nodiscard]] double Apply(Operation operation, double a, double b = 0.0, double c = 0.0);
} // namespace pixelexact
