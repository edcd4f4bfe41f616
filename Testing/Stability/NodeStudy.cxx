// SPDX-License-Identifier: BSD-3-Clause
#include "Stability/NodeStudy.h"

#include "MeshBuilder.h"
#include "Stability/Reference.h"

#include "Core/Math/Rounding.h"

#include <tbb/parallel_for.h>

#include <chrono>
#include <numeric>

namespace pixelexact::testing
{
namespace
{
/// Legendre's series with decaying random coefficients.
class Series
{
public:
  Series(int order, std::uint64_t seed)
  {
    Random random(seed);
    for (int k = 0; k <= order; ++k)
    {
      Weight.push_back(random(0.5, 1.0) * (k % 3 == 1 ? -1.0 : 1.0) * std::pow(0.7, k));
    }
  }

  [[nodiscard]] Quad operator()(Quad z) const
  {
    Quad before = 0;
    Quad at = 1;
    Quad sum = 0;
    for (int k = 0; k < static_cast<int>(Weight.size()); ++k)
    {
      sum = sum + Quad(Weight[k]) * at;
      const Quad next = (Quad(2 * k + 1) * z * at - Quad(k) * before) / Quad(k + 1);
      before = at;
      at = next;
    }
    return sum;
  }

private:
  std::vector<double> Weight;
};

/// The interpolation problem of one shape.
class Problem
{
public:
  virtual ~Problem() = default;
  [[nodiscard]] virtual Quad Exact(const QuadVec3& xi) const = 0;
  /// sum over the nodes of |value| |Lagrange function|.
  [[nodiscard]] virtual Quad Sensitivity(const QuadVec3& xi) const = 0;
  std::vector<double> values; ///< at the nodes, rounded
};

class HexahedronProblem final : public Problem
{
public:
  HexahedronProblem(Nodes nodes, int order)
    : Points(
        nodes == Nodes::Equispaced ? ClosedUniformPoints(order + 1) : GaussLobattoPoints(order + 1))
    , F{ Series(order, 81), Series(order, 82), Series(order, 83) }
  {
    std::array<std::vector<Quad>, 3> line;
    for (std::size_t d = 0; d < 3; ++d)
    {
      for (const long double z : Points)
      {
        line[d].push_back(F[d](z));
      }
    }
    for (const Quad a : line[0])
    {
      for (const Quad b : line[1])
      {
        for (const Quad c : line[2])
        {
          values.push_back(static_cast<double>(a * b * c));
        }
      }
    }
  }

  [[nodiscard]] Quad Exact(const QuadVec3& xi) const override
  {
    return F[0](xi[0]) * F[1](xi[1]) * F[2](xi[2]);
  }

  [[nodiscard]] Quad Sensitivity(const QuadVec3& xi) const override
  {
    Quad product = 1;
    for (std::size_t d = 0; d < 3; ++d)
    {
      Quad sum = 0;
      for (const long double node : Points)
      {
        Quad lagrange = 1;
        for (const long double other : Points)
        {
          if (other != node)
          {
            lagrange = lagrange * (xi[d] - Quad(other)) / (Quad(node) - Quad(other));
          }
        }
        sum = sum + Abs(lagrange * F[d](node));
      }
      product = product * sum;
    }
    return product;
  }

private:
  std::vector<long double> Points;
  std::array<Series, 3> F;
};

class TetrahedronProblem final : public Problem
{
public:
  explicit TetrahedronProblem(int order)
    : Order(order)
    , F(order, 84)
  {
    ForEachNode(
      [&](int i, int j, int k)
      {
        const auto at = [order](int index) { return Quad(2 * index) / Quad(order) - 1; };
        values.push_back(static_cast<double>(Exact({ at(i), at(j), at(k) })));
      });
  }

  /// A series in a linear function that runs from -1 to 1.
  [[nodiscard]] Quad Exact(const QuadVec3& xi) const override
  {
    const auto [a, b, c] = xi;
    return F(a + (b + 1) * Quad(0.6) + (c + 1) * Quad(0.3));
  }

  [[nodiscard]] Quad Sensitivity(const QuadVec3& xi) const override
  {
    const Quad half = 0.5;
    const std::array<Quad, 4> l{ half * (1 + xi[0]), half * (1 + xi[1]), half * (1 + xi[2]),
      -half * (1 + xi[0] + xi[1] + xi[2]) };
    Quad sum = 0;
    std::size_t node = 0;
    ForEachNode(
      [&](int i, int j, int k)
      {
        const Quad lagrange =
          Factor(i, l[0]) * Factor(j, l[1]) * Factor(k, l[2]) * Factor(Order - i - j - k, l[3]);
        sum = sum + Abs(lagrange * Quad(values[node++]));
      });
    return sum;
  }

private:
  template <class Visit>
  void ForEachNode(Visit&& visit) const
  {
    for (int i = 0; i <= Order; ++i)
    {
      for (int j = 0; j <= Order - i; ++j)
      {
        for (int k = 0; k <= Order - i - j; ++k)
        {
          visit(i, j, k);
        }
      }
    }
  }

  /// The factor that is one at l = i / n and zero at the smaller multiples of 1 / n.
  [[nodiscard]] Quad Factor(int i, Quad l) const
  {
    Quad product = 1;
    for (int m = 0; m < i; ++m)
    {
      product = product * (Quad(Order) * l - Quad(m)) / Quad(i - m);
    }
    return product;
  }

  int Order;
  Series F;
};

ChangeOfBasis MakeChange(const Space& space, Nodes nodes)
{
  std::vector<int> source(static_cast<std::size_t>(space.Modes()));
  std::iota(source.begin(), source.end(), 0);
  if (space.shape == Shape::Tetrahedron)
  {
    return ChangeOfBasis::Tetrahedron(space, Family::EquispacedLagrange, source);
  }
  if (nodes == Nodes::Equispaced)
  {
    return ChangeOfBasis::Hexahedron(space, Family::EquispacedLagrange, source);
  }
  std::array<LineFunctions, 3> lines;
  lines.fill(Lagrange(GaussLobattoPoints(space.order[0] + 1)));
  return ChangeOfBasis::FromLines(space, lines, source);
}

/// Points of the shape, most of them close to its boundary; equispaced nodes do worst about halfway
/// from a vertex to the nodes next to it.
Vec3 NearTheBoundary(Shape shape, int order, Random& random)
{
  Vec3 eta;
  for (int d = 0; d < 3; ++d)
  {
    eta[d] =
      random() < 0.0 ? random() : (random() < 0.0 ? 1.0 : -1.0) * (1.0 - random(0.5, 1.5) / order);
  }
  return TensorToReference(shape, eta);
}
} // namespace

const char* Name(Nodes nodes)
{
  return nodes == Nodes::Equispaced ? "equispaced nodes" : "Gauss-Lobatto nodes";
}

Row StudyNodes(Shape shape, Nodes nodes, int order, int points)
{
  const auto start = std::chrono::steady_clock::now();
  Row row;
  row.sweep = Name(nodes);
  row.shape = Name(shape);
  row.order = order;
  row.parameter = "order";
  row.at = order;
  std::unique_ptr<Problem> problem;
  if (shape == Shape::Tetrahedron)
  {
    problem = std::make_unique<TetrahedronProblem>(order);
  }
  else
  {
    problem = std::make_unique<HexahedronProblem>(nodes, order);
  }
  const Space space = UniformSpace(shape, order);
  std::vector<double> modes(static_cast<std::size_t>(space.Modes()));
  MakeChange(space, nodes).Apply(problem->values, 0.0, modes);
  double largest = 0.0;
  for (const double value : problem->values)
  {
    largest = std::max(largest, std::fabs(value));
  }
  struct Measured
  {
    double error;
    double sensitivity;
    double magnitude;
  };
  std::vector<Measured> measured(static_cast<std::size_t>(points));
  tbb::parallel_for(0, points,
    [&](int i)
    {
      Random random(90 + static_cast<std::uint64_t>(i));
      const QuadVec3 xi = ToQuad(NearTheBoundary(shape, order, random));
      measured[static_cast<std::size_t>(i)] = {
        static_cast<double>(Evaluate(space, modes.data(), xi).value - problem->Exact(xi)),
        static_cast<double>(problem->Sensitivity(xi)),
        static_cast<double>(Magnitude(space, modes.data(), xi))
      };
    });
  // The error is largest near a vertex.
  double worst = 0.0;
  for (const Measured& at : measured)
  {
    worst = std::max(worst, at.sensitivity);
  }
  const double conversion = std::ldexp(24.0 * (order + 1), -64) * worst;
  for (const Measured& at : measured)
  {
    Raise(row.condition, at.sensitivity / largest);
    row.value.Add(at.error, largest, at.magnitude,
      kUnitRoundoff * (at.sensitivity + at.magnitude) + conversion);
  }
  row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return row;
}
} // namespace pixelexact::testing
