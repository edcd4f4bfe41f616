// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/GraphIntegral.h"

#include "Core/Bernstein/BoxAlgebra.h"
#include "Core/Integral/BoxRanges.h"
#include "Core/Integral/IntegralCut.h"
#include "Core/Shape/ShapeFace.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
constexpr int kRootSteps = 16;
/// The number of these steps that also correct the slope's inverse.
constexpr int kSlopeSteps = 3;

/// The root x(s, t) of f along one of its variables, proven to be in the box, from a first guess.
/// `place` returns the models of the place for a value of the variable. `slope` is f's derivative
/// by the box's own [0, 1].
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
  for (int step = 0; step < kRootSteps; ++step)
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
  // The slope by [-1, 1] is half of that by [0, 1].
  x.error = at.Of(f).Range().Magnitude() / (0.5 * least) * (1.0 + 0x1p-40) + 0x1p-1000;
  return x.TightRange().Magnitude() <= BoxModel::kReach ? std::optional(x) : std::nullopt;
}

/// The components of the field in world units. Their errors are infinite where a mapped field
/// divides by a det J that may vanish.
std::vector<ChebyshevModel> WorldValues(
  const ElementFunctions& functions, const SurfaceModels& models)
{
  const Mapping mapping = functions.Question().field->mapping;
  const double unit = std::ldexp(1.0, functions.FieldExponent());
  std::vector<ChebyshevModel> values = models.field;
  if (mapping != Mapping::Identity)
  {
    const WeighedField field = Weigh(models, mapping);
    const ChebyshevModel inverse = Reciprocal(models.determinant);
    const Interval power(std::pow(functions.Radius(), field.power - 3));
    for (std::size_t k = 0; k < values.size(); ++k)
    {
      values[k] = ChebyshevModel(power) * (field.values[k] * inverse);
    }
  }
  for (ChebyshevModel& value : values)
  {
    value = unit * value;
  }
  return values;
}

/// The zero of an affine form along one variable, as a function of the models of the other ones.
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
    const auto found = Parametrise();
    if (!found)
    {
      return std::nullopt;
    }
    const auto part = ClippedPart(Functions, Graph.box, Graph.axes, found->place);
    if (!part)
    {
      return std::nullopt;
    }
    if (part->IsEmpty())
    {
      const std::size_t quantities = Functions.Question().Quantities();
      return GraphSums{ Sums(quantities), std::vector<double>(quantities), Graph.axes[0], false };
    }
    SurfaceModels models(Functions, Graph.box, Graph.axes, found->place, Graph.box);
    const Interval slopes = found->slope.Range();
    const double sign = TakeMagnitude(models.determinant);
    if (!std::isfinite(models.determinant.error))
    {
      return std::nullopt;
    }
    const ChebyshevModel weight = (slopes.lower > 0.0 ? 1.0 : -1.0) *
      (found->half * Reciprocal(found->place.Of(found->slope)) * Collapses(found->b, found->c));
    return Sum(models, found->place, *part, weight, sign);
  }

  std::optional<SurfaceValues> Values()
  {
    const auto found = Parametrise();
    if (!found)
    {
      return std::nullopt;
    }
    const auto& axes = Graph.axes;
    const SurfaceModels models(Functions, Graph.box, axes, found->place, Graph.box);
    return SurfaceValues{ WorldValues(Functions, models),
      EtaModels(Functions, Graph.box, axes, found->b, found->c),
      ClipModels(Functions, Graph.box, axes, found->place), { axes[0], axes[1] } };
  }

private:
  /// The graph's parameters: b(s, t), c(s, t), half of the extent of b, and the cut's slope by c.
  struct Parameters
  {
    ChebyshevModel b;
    ChebyshevModel c;
    ChebyshevModel half;
    PointedModels place;
    BoxModel slope;
  };
  std::optional<Parameters> Parametrise()
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
    return Parameters{ b, *c, half, placed(*c), slope };
  }

  /// Widens det J so that, times the returned sign, it holds |det J|. Where det J may have either
  /// sign by more than rounding (at a collapsed edge it vanishes), only integrals with the factor
  /// |det J| are known; others get an infinite error.
  double TakeMagnitude(ChebyshevModel& determinant) const
  {
    const Interval range = determinant.TightRange();
    const double sign = range.upper >= -range.lower ? 1.0 : -1.0;
    const double opposite = sign > 0.0 ? -range.lower : range.upper;
    if (opposite >= 0.0)
    {
      const IntegralQuestion& question = Functions.Question();
      const bool isFactor = question.field == nullptr ||
        (question.field->mapping == Mapping::Identity &&
          (question.cut->MadeOf() == nullptr || !question.HasFlux()));
      determinant.Widen(isFactor ? 2.0 * opposite : std::numeric_limits<double>::infinity());
    }
    return sign;
  }

  /// The model of b at an end of the graph.
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

  /// The field over the surface, times the unit of its mapping, with or without the factor det J.
  static WeighedField FieldOf(const SurfaceModels& models, Mapping mapping, bool withDeterminant)
  {
    if (!withDeterminant && mapping == Mapping::Identity)
    {
      return { models.field, 0 };
    }
    WeighedField field = Weigh(models, mapping);
    if (!withDeterminant)
    {
      const ChebyshevModel inverse = Reciprocal(models.determinant);
      for (ChebyshevModel& value : field.values)
      {
        value = value * inverse;
      }
      field.power -= 3;
    }
    return field;
  }

  std::optional<GraphSums> Sum(const SurfaceModels& models, const PointedModels& place,
    const ClippedSquare& part, const ChebyshevModel& weight, double orientation)
  {
    const IntegralQuestion& question = Functions.Question();
    const CutGradient cut = question.cut->Gradient(Functions, Graph.box, Graph.axes, place, models);
    const auto& gradient = cut.gradient;
    const ChebyshevModel length = cut.constant
      ? ChebyshevModel(Length({ gradient[0].Range(), gradient[1].Range(), gradient[2].Range() }))
      : SquareRoot(Dot(gradient, gradient));
    // Widths are in eta; derivatives of the cut are by [0, 1].
    Interval volume = Interval(Functions.Unit());
    for (int d = 0; d < 3; ++d)
    {
      volume *= Functions.HalfWidth(Graph.box, d);
    }
    const double radius = Functions.Radius();
    const auto power = [radius](int n) { return Interval(std::pow(radius, n)); };
    volume *= Interval(2.0);
    GraphSums result{ .sums = Sums(question.Quantities()), .magnitudes = {}, .roughest = 0 };
    // The power of the radius from |det J| that the gradient does not contain.
    const int left = cut.timesDeterminant ? 2 : 0;
    const ChebyshevModel lengthWeight = length * weight;
    const ChebyshevModel area =
      cut.timesDeterminant ? lengthWeight : orientation * (models.determinant * lengthWeight);
    if (!std::isfinite(area.error))
    {
      return std::nullopt;
    }
    result.magnitudes.resize(question.Quantities());
    std::array<double, 2> rough{ 0.0, 0.0 };
    const double share = part.Part();
    const auto add = [&](std::size_t q, const ChebyshevModel& density, const Interval& unit)
    {
      AddRoughness(density, rough);
      result.anyRange = result.anyRange || IsRange(density);
      result.sums[q] = part.Integral(density) * unit;
      // The integral of a model of degree 0 is four times its value.
      result.magnitudes[q] = 4.0 * share * density.Norm() * unit.Magnitude();
    };
    add(0, area, volume * power(cut.timesDeterminant ? 2 : 3));
    if (question.field != nullptr)
    {
      const WeighedField field = FieldOf(models, question.field->mapping, !cut.timesDeterminant);
      const Interval unit =
        volume * power(field.power + left) * Interval(std::ldexp(1.0, Functions.FieldExponent()));
      const double sense = cut.timesDeterminant ? 1.0 : orientation;
      for (std::size_t k = 0; k < field.values.size(); ++k)
      {
        add(k + 1, sense * (field.values[k] * lengthWeight), unit);
      }
      if (question.HasFlux())
      {
        const ChebyshevModel normal =
          Dot({ field.values[0], field.values[1], field.values[2] }, gradient);
        add(result.sums.size() - 1, orientation * (normal * weight), unit);
      }
    }
    const auto width = [this](int d) { return Functions.HalfWidth(Graph.box, d).upper; };
    const bool second =
      result.anyRange ? width(Graph.axes[1]) > width(Graph.axes[0]) : rough[1] > rough[0];
    result.roughest = Graph.axes[second ? 1 : 0];
    return result;
  }

  ElementFunctions& Functions;
  const CutGraph& Graph;
};

} // namespace

std::optional<GraphSums> Integrate(ElementFunctions& functions, const CutGraph& graph)
{
  return GraphTask(functions, graph).Run();
}

std::optional<SurfaceValues> ValuesOn(ElementFunctions& functions, const CutGraph& graph)
{
  return GraphTask(functions, graph).Values();
}

SurfaceValues ValuesOnFace(ElementFunctions& functions, int face, const PieceBox& box)
{
  const ShapeFace& end = FacesOf(functions.GetShape())[static_cast<std::size_t>(face)];
  const std::array<int, 3> axes{ (end.direction + 1) % 3, (end.direction + 2) % 3, end.direction };
  // The box takes the piece's whole thickness, for the model at its end.
  PieceBox thick = box;
  thick.lower[end.direction] = -1.0;
  thick.upper[end.direction] = 1.0;
  const ChebyshevModel c(end.upper ? 1.0 : -1.0);
  const PointedModels place(c);
  const SurfaceModels models(functions, thick, axes, place, box);
  return { WorldValues(functions, models),
    EtaModels(functions, thick, axes, ChebyshevModel::Second(), c),
    ClipModels(functions, thick, axes, place), { axes[0], axes[1] } };
}

} // namespace pixelexact
