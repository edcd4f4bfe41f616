// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/GraphIntegral.h"

#include "Core/Bernstein/BoxAlgebra.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
constexpr int kNewtonSteps = 16;
/// Of them, those that correct the slope's inverse.
constexpr int kSlopeSteps = 3;
constexpr std::array<std::array<std::size_t, 2>, 6> kPairs{ { { 0, 0 }, { 1, 1 }, { 2, 2 },
  { 0, 1 }, { 1, 2 }, { 0, 2 } } };

/// The root x(s, t) of f along one of its variables, proven to be in the box, from a first guess.
/// `place` puts the variable where f is asked for. `slope` is f's derivative by the box's own
/// [0, 1].
template <class Place>
std::optional<ChebyshevModel> Solve(
  const BoxModel& f, const BoxModel& slope, ChebyshevModel x, const Place& place)
{
  const double least = slope.Range().Mignitude();
  if (!(least > 0.0))
  {
    return std::nullopt;
  }
  double before = std::numeric_limits<double>::infinity();
  ChebyshevModel inverse; // of the slope, about
  for (int step = 0; step < kNewtonSteps; ++step)
  {
    const PointedModels at = place(x);
    if (!at.IsWithin())
    {
      return std::nullopt;
    }
    const ChebyshevModel left = at.Of(f);
    const double miss = left.Norm();
    if (!(miss < 0.5 * before))
    {
      break;
    }
    before = miss;
    if (step < kSlopeSteps)
    {
      const ChebyshevModel by = at.Of(slope).Polynomial();
      inverse = step == 0 ? ChebyshevModel(1.0 / by.c[0]) : inverse;
      inverse = (inverse + inverse * (ChebyshevModel(1.0) - by * inverse)).Polynomial();
    }
    x = (x - 2.0 * (left.Polynomial() * inverse)).Polynomial();
  }
  const PointedModels at = place(x);
  if (!at.IsWithin())
  {
    return std::nullopt;
  }
  // By [-1, 1] the slope is half of what it is by [0, 1].
  x.error = at.Of(f).Range().Magnitude() / (0.5 * least) * (1.0 + 0x1p-40) + 0x1p-1000;
  return x.TightRange().Magnitude() <= BoxModel::kReach ? std::optional(x) : std::nullopt;
}

/// Where an affine form vanishes along a direction, of the other ones as models.
ChebyshevModel RootOf(const AffineForm& f, const std::array<int, 3>& axes, std::size_t variable,
  const std::array<ChebyshevModel, 3>& others)
{
  ChebyshevModel sum(f.a);
  for (std::size_t v = 0; v < 3; ++v)
  {
    if (v != variable)
    {
      sum = sum + f.b[static_cast<std::size_t>(axes[v])] * others[v];
    }
  }
  const double slope = f.b[static_cast<std::size_t>(axes[variable])];
  return slope != 0.0 ? ((-1.0 / slope) * sum).Polynomial() : ChebyshevModel();
}

class GraphTask
{
public:
  GraphTask(ElementFunctions& functions, const CutGraph& graph)
    : Functions(functions)
    , Graph(graph)
  {
  }

  std::optional<GraphSums> Run()
  {
    const auto& axes = Graph.axes;
    const BoxPolynomial cut = Functions.Cut(Graph.box);
    const auto low = Limit(cut, Graph.low, -1.0);
    const auto high = low ? Limit(cut, Graph.high, 1.0) : std::nullopt;
    if (!high)
    {
      return std::nullopt;
    }
    const ChebyshevModel half = 0.5 * (*high - *low);
    const bool plain = Graph.low == GraphLimit::BoxEnd && Graph.high == GraphLimit::BoxEnd;
    const ChebyshevModel b =
      plain ? ChebyshevModel::Second() : 0.5 * (*high + *low) + half * ChebyshevModel::Second();
    const auto placed = [&](const ChebyshevModel& x)
    { return plain ? PointedModels(x) : PointedModels(b, x); };
    const BoxModel f(cut, axes, !plain);
    const BoxModel slope(Derivative(cut, axes[2]), axes, !plain);
    const auto c = Solve(f, slope,
      RootOf(cut.Affine(), axes, 2, { ChebyshevModel::First(), b, ChebyshevModel() }), placed);
    if (!c)
    {
      return std::nullopt;
    }
    const PointedModels place = placed(*c);
    const SurfaceModels models(Functions, Graph.box, axes, place);
    const Interval sign = models.determinant.Range();
    const Interval slopes = slope.Range();
    if (sign.Contains(0.0))
    {
      return std::nullopt;
    }
    const ChebyshevModel weight =
      (slopes.lower > 0.0 ? 1.0 : -1.0) * (half * Reciprocal(place.Of(slope)) * Collapses(b, *c));
    return Sum(models, place, weight, sign.lower > 0.0 ? 1.0 : -1.0);
  }

private:
  /// b at an end of the graph.
  std::optional<ChebyshevModel> Limit(const BoxPolynomial& cut, GraphLimit limit, double end)
  {
    if (limit == GraphLimit::BoxEnd)
    {
      return ChebyshevModel(end);
    }
    const auto& axes = Graph.axes;
    const BoxPolynomial phi = cut.AtEnd(axes[2], limit == GraphLimit::ThroughUpper);
    return Solve(BoxModel(phi, axes, true), BoxModel(Derivative(phi, axes[1]), axes, true),
      RootOf(phi.Affine(), axes, 1, { ChebyshevModel::First(), {}, {} }),
      [](const ChebyshevModel& x) { return PointedModels(x, ChebyshevModel()); });
  }

  /// det dxi / deta.
  [[nodiscard]] ChebyshevModel Collapses(const ChebyshevModel& b, const ChebyshevModel& c) const
  {
    const auto eta = EtaModels(Functions, Graph.box, Graph.axes, b, c);
    const ChebyshevModel third = Collapse(eta[2]);
    switch (Functions.GetShape())
    {
      case Shape::Hexahedron:
        return 1.0;
      case Shape::Prism:
        return third;
      case Shape::Pyramid:
        return third * third;
      default:
        return Collapse(eta[1]) * (third * third);
    }
  }

  /// The gradient of the quadric.
  std::array<ChebyshevModel, 3> Gradient(const PointedModels& place)
  {
    const QuadricForm& form = *Functions.Question().cut;
    std::array<ChebyshevModel, 3> gradient{ form.g.x, form.g.y, form.g.z };
    if (form.IsPlane())
    {
      return gradient;
    }
    std::array<ChebyshevModel, 3> z;
    for (std::size_t d = 0; d < 3; ++d)
    {
      z[d] = ChebyshevModel(Functions.Shift(static_cast<int>(d))) +
        Functions.Radius() *
          place.Of(
            BoxModel(Functions.Map3(Graph.box, static_cast<int>(d)), Graph.axes, place.IsWideB()));
    }
    for (std::size_t k = 0; k < 6; ++k)
    {
      const auto [a, b] = kPairs[k];
      if (form.q[k] != 0.0)
      {
        gradient[a] = gradient[a] + form.q[k] * z[b];
        gradient[b] = gradient[b] + form.q[k] * z[a];
      }
    }
    return gradient;
  }

  std::optional<GraphSums> Sum(const SurfaceModels& models, const PointedModels& place,
    const ChebyshevModel& weight, double orientation)
  {
    const IntegralQuestion& question = Functions.Question();
    const auto gradient = Gradient(place);
    // Of a plane the same everywhere.
    const ChebyshevModel length = question.cut->IsPlane()
      ? ChebyshevModel(Sqrt(Square(Interval(question.cut->g.x)) +
          Square(Interval(question.cut->g.y)) + Square(Interval(question.cut->g.z))))
      : SquareRoot(Dot(gradient, gradient));
    // Widths in eta; derivatives of the cut are by [0, 1].
    Interval volume = Interval(Functions.Unit());
    for (int d = 0; d < 3; ++d)
    {
      volume *= Functions.HalfWidth(Graph.box, d);
    }
    const double radius = Functions.Radius();
    const auto power = [radius](int n) { return Interval(std::pow(radius, n)); };
    volume *= Interval(2.0);
    GraphSums result{ .sums = Sums(question.Quantities()), .magnitudes = {}, .roughest = 0 };
    const ChebyshevModel lengthWeight = length * weight;
    // What is left of |det J| where a field is weighed with det J.
    const ChebyshevModel area = orientation * (models.determinant * lengthWeight);
    if (!std::isfinite(area.error))
    {
      return std::nullopt;
    }
    result.magnitudes.resize(question.Quantities());
    std::array<double, 2> rough{ 0.0, 0.0 };
    const auto add = [&](std::size_t q, const ChebyshevModel& density, const Interval& unit)
    {
      AddRoughness(density, rough);
      result.sums[q] = density.Integral() * unit;
      // That of a model of degree 0 is four times its value.
      result.magnitudes[q] = 4.0 * density.Norm() * unit.Magnitude();
    };
    add(0, area, volume * power(3));
    if (question.field != nullptr)
    {
      const WeighedField field = Weigh(models, question.field->mapping);
      const Interval unit =
        volume * power(field.power) * Interval(std::ldexp(1.0, Functions.FieldExponent()));
      for (std::size_t k = 0; k < field.values.size(); ++k)
      {
        add(k + 1, orientation * (field.values[k] * lengthWeight), unit);
      }
      if (question.HasFlux())
      {
        const ChebyshevModel normal =
          Dot({ field.values[0], field.values[1], field.values[2] }, gradient);
        add(result.sums.size() - 1, orientation * (normal * weight), unit);
      }
    }
    result.roughest = rough[1] > rough[0] ? Graph.axes[1] : Graph.axes[0];
    return result;
  }

  ElementFunctions& Functions;
  const CutGraph& Graph;
};

using Intervals3 = std::array<std::array<Interval, 3>, 3>;

/// Ranges over a box, in world units, without the collapse of the shape, which is at most 1.
struct BoxRanges
{
  BoxRanges(ElementFunctions& functions, const PieceBox& box)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t d = 0; d < 3; ++d)
      {
        jacobian[i][d] = functions.Slope(box, static_cast<int>(i), static_cast<int>(d)).Hull() *
          Interval(functions.Radius());
      }
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t d = 0; d < 3; ++d)
      {
        const std::size_t k = (i + 1) % 3;
        const std::size_t l = (i + 2) % 3;
        const std::size_t m = (d + 1) % 3;
        const std::size_t n = (d + 2) % 3;
        cofactor[i][d] = jacobian[k][m] * jacobian[l][n] - jacobian[k][n] * jacobian[l][m];
      }
    }
    determinant = jacobian[0][0] * cofactor[0][0] + jacobian[0][1] * cofactor[0][1] +
      jacobian[0][2] * cofactor[0][2];
  }
  Intervals3 jacobian;
  Intervals3 cofactor;
  Interval determinant;
};

/// Of a component of the field, in world units.
Interval FieldRange(ElementFunctions& functions, const PieceBox& box, int component)
{
  const auto values = [&](int c) {
    return functions.Values(box, c).Hull() * Interval(std::ldexp(1.0, functions.FieldExponent()));
  };
  const Mapping mapping = functions.Question().field->mapping;
  if (mapping == Mapping::Identity)
  {
    return values(component);
  }
  const BoxRanges ranges(functions, box);
  if (mapping == Mapping::Density)
  {
    return values(component) / ranges.determinant;
  }
  const auto& matrix = mapping == Mapping::Contravariant ? ranges.jacobian : ranges.cofactor;
  Interval sum = 0.0;
  for (int d = 0; d < 3; ++d)
  {
    sum += matrix[static_cast<std::size_t>(component)][static_cast<std::size_t>(d)] * values(d);
  }
  return sum / ranges.determinant;
}

/// Of all quantities, where the area is at most this.
Sums BoundsOfArea(ElementFunctions& functions, const PieceBox& box, double area)
{
  const IntegralQuestion& question = functions.Question();
  Sums sums(question.Quantities());
  sums[0] = Interval(0.0, area);
  Interval largest = 0.0;
  for (int c = 0; c < question.Components(); ++c)
  {
    const Interval value = FieldRange(functions, box, c);
    sums[static_cast<std::size_t>(c) + 1] = value * sums[0];
    largest += Square(value);
  }
  if (question.HasFlux())
  {
    const double flux = (Sqrt(largest) * Interval(area)).upper;
    sums.back() = Interval(-flux, flux);
  }
  return sums;
}
} // namespace

std::array<Interval, 3> GradientRange(ElementFunctions& functions, const PieceBox& box)
{
  const QuadricForm& form = *functions.Question().cut;
  std::array<Interval, 3> gradient{ form.g.x, form.g.y, form.g.z };
  if (form.IsPlane())
  {
    return gradient;
  }
  std::array<Interval, 3> z;
  for (int d = 0; d < 3; ++d)
  {
    z[static_cast<std::size_t>(d)] =
      functions.Shift(d) + functions.Map3(box, d).Hull() * Interval(functions.Radius());
  }
  for (std::size_t k = 0; k < 6; ++k)
  {
    const auto [a, b] = kPairs[k];
    gradient[a] += Interval(form.q[k]) * z[b];
    gradient[b] += Interval(form.q[k]) * z[a];
  }
  return gradient;
}

std::optional<GraphSums> Integrate(ElementFunctions& functions, const CutGraph& graph)
{
  return GraphTask(functions, graph).Run();
}

Sums BoundIn(ElementFunctions& functions, const PieceBox& box)
{
  std::array<Interval, 3> side;
  for (int d = 0; d < 3; ++d)
  {
    side[static_cast<std::size_t>(d)] =
      Interval(functions.Map3(box, d).Hull().Width()) * Interval(functions.Radius());
  }
  const double sheets = functions.Question().cut->IsPlane() ? 1.0 : 2.0;
  const double area =
    (Interval(sheets) * (side[0] * side[1] + side[1] * side[2] + side[2] * side[0])).upper;
  return BoundsOfArea(functions, box, area);
}

Sums BoundOn(ElementFunctions& functions, const CutGraph& graph)
{
  const auto gradient = GradientRange(functions, graph.box);
  const Interval length = Sqrt(Square(gradient[0]) + Square(gradient[1]) + Square(gradient[2]));
  const BoxRanges ranges(functions, graph.box);
  const Interval slope = Derivative(functions.Cut(graph.box), graph.axes[2]).Hull();
  Interval area = Abs(ranges.determinant) * length * Interval(functions.Unit()) / Abs(slope);
  for (int d = 0; d < 3; ++d)
  {
    area *= Interval(2.0) * functions.HalfWidth(graph.box, d);
  }
  return BoundsOfArea(functions, graph.box, area.upper);
}
} // namespace pixelexact
