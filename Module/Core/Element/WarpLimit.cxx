// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/WarpLimit.h"

#include "Core/Base/Error.h"
#include "Core/Bernstein/BoxAlgebra.h"
#include "Core/Bernstein/TensorPolynomial.h"
#include "Core/Element/JacobianAlgebra.h"
#include "Core/Element/ParallelProgress.h"
#include "Core/Element/RangeIngredients.h"
#include "Core/Element/Validity.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <queue>
#include <string>
#include <tuple>
#include <utility>

namespace pixelexact
{
namespace
{
/// Where no element folds below this many times the scale that moves an element by its own size,
/// the search ends.
constexpr double kMaxReach = 1e6;
/// Boxes that are subdivided in one round, in parallel.
constexpr std::size_t kRound = 32;
/// Coefficients that boxes may hold together: 512 MiB.
constexpr std::size_t kMaxCoefficients = std::size_t{ 1 } << 26U;
/// Steps of s end at this part of s.
constexpr double kSmallestStep = 0x1p-44;

/// A polynomial in the scale s, by its coefficients.
template <class Coefficient>
struct ScaleSeries
{
  std::vector<Coefficient> c;
};

Interval Product(const Interval& a, const Interval& b)
{
  return a * b;
}
BoxPolynomial Product(const BoxPolynomial& a, const BoxPolynomial& b)
{
  return Multiply(a, b);
}
Interval Added(const Interval& a, double sign, const Interval& b)
{
  return a + Interval(sign) * b;
}
BoxPolynomial Added(const BoxPolynomial& a, double sign, const BoxPolynomial& b)
{
  return Combine(1.0, a, sign, b);
}

template <class C>
ScaleSeries<C> operator*(const ScaleSeries<C>& f, const ScaleSeries<C>& g)
{
  ScaleSeries<C> product;
  for (std::size_t power = 0; power + 1 < f.c.size() + g.c.size(); ++power)
  {
    for (std::size_t i = 0; i < f.c.size(); ++i)
    {
      if (i > power || power - i >= g.c.size())
      {
        continue;
      }
      C term = Product(f.c[i], g.c[power - i]);
      if (product.c.size() == power)
      {
        product.c.push_back(std::move(term));
      }
      else
      {
        product.c[power] = Added(product.c[power], 1.0, term);
      }
    }
  }
  return product;
}

template <class C>
ScaleSeries<C> Summed(const ScaleSeries<C>& f, double sign, const ScaleSeries<C>& g)
{
  ScaleSeries<C> sum;
  for (std::size_t i = 0; i < f.c.size(); ++i)
  {
    sum.c.push_back(Added(f.c[i], sign, g.c[i]));
  }
  return sum;
}
template <class C>
ScaleSeries<C> operator+(const ScaleSeries<C>& f, const ScaleSeries<C>& g)
{
  return Summed(f, 1.0, g);
}
template <class C>
ScaleSeries<C> operator-(const ScaleSeries<C>& f, const ScaleSeries<C>& g)
{
  return Summed(f, -1.0, g);
}

/// Coefficients of s^0 to s^3.
using Cubic = std::array<double, 4>;

double MagnitudeAt(const Cubic& c, double s)
{
  return std::fabs(c[0]) + s * (std::fabs(c[1]) + s * (std::fabs(c[2]) + s * std::fabs(c[3]))) +
    kUnderflow;
}

double ValueAt(const Cubic& c, double s)
{
  return c[0] + s * (c[1] + s * (c[2] + s * c[3]));
}

/// Whether the cubic is proven positive for all s from `from` to `to`, by its Bernstein
/// coefficients there.
bool IsPositive(const Cubic& c, double from, double to)
{
  const double width = to - from;
  const double slope = width * (c[1] + from * (2.0 * c[2] + 3.0 * from * c[3]));
  const double second = width * width * (c[2] + 3.0 * from * c[3]);
  const double third = width * width * width * c[3];
  const double value = ValueAt(c, from);
  const double least = std::min({ value, value + slope / 3.0, value + (2.0 * slope + second) / 3.0,
    value + slope + second + third });
  return least > Gamma(256) * MagnitudeAt(c, to);
}

/// The end of an interval from 0 on which the cubic is proven positive; at most `most`.
double PositiveUpTo(const Cubic& c, double most)
{
  double reached = 0.0;
  double step = most;
  while (reached < most)
  {
    const double next = std::min(reached + step, most);
    if (IsPositive(c, reached, next))
    {
      reached = next;
      step *= 2.0;
      continue;
    }
    step /= 2.0;
    if (step <= kSmallestStep * std::max(reached, kSmallestStep * most))
    {
      break;
    }
  }
  return reached;
}

/// An s near the smallest one at which the cubic is proven not to be positive; infinite where none
/// up to `most` was found.
double NotPositiveAt(const Cubic& c, double most)
{
  const double positive = PositiveUpTo(c, most);
  for (double beyond = 2.0 * kSmallestStep; beyond < 1e-2; beyond *= 4.0)
  {
    const double s = positive * (1.0 + beyond);
    if (s > most)
    {
      break;
    }
    if (ValueAt(c, s) <= -Gamma(32) * MagnitudeAt(c, s))
    {
      return s;
    }
  }
  return kInfinity;
}

/// det(J of x + s u) on one element as a cubic in s, in units of its own for lengths and for s.
class ElementCubic
{
public:
  ElementCubic(const Mesh& mesh, int element, std::span<const WarpTerm> displacement)
    : Joint(JoinModes(mesh, element, displacement))
    , Map(Joint.space, Joint.map.data(), 3)
    , Displacement(Joint.space, Joint.displacement.data(), 3)
    , Exponent(Displacement.exponent - Map.exponent -
        std::ilogb(mesh.size[static_cast<std::size_t>(element)]))
  {
    AddDerivatives(Map, 0, 3, Ingredients);
    AddDerivatives(Displacement, 0, 3, Ingredients);
    level_ = LevelFor(Ingredients);
  }

  [[nodiscard]] int Level() const { return level_; }
  [[nodiscard]] Shape GetShape() const { return Joint.space.shape; }

  /// From s to the element's units, and back; exact.
  [[nodiscard]] double ToUnits(double scale) const { return std::ldexp(scale, Exponent); }
  [[nodiscard]] double FromUnits(double scale) const { return std::ldexp(scale, -Exponent); }

  /// The scale that moves the element by its own size; infinite where the displacement is constant.
  [[nodiscard]] double NaturalScale() const
  {
    const auto extent = [](const ScaledModes& modes)
    {
      double largest = 0.0;
      for (std::size_t k = 0; k < modes.values.size(); ++k)
      {
        largest = k % modes.width == 0 ? largest : std::max(largest, std::fabs(modes.values[k]));
      }
      return largest;
    };
    const double moved = extent(Displacement);
    return moved > 0.0 ? FromUnits(extent(Map) / moved) : kInfinity;
  }

  /// The eighteen derivatives over a piece: of the map, then of the displacement.
  [[nodiscard]] std::vector<BoxPolynomial> Derivatives(const PieceForm::Piece& piece) const
  {
    std::vector<BoxPolynomial> derivatives;
    for (const RangeIngredient& ingredient : Ingredients)
    {
      derivatives.push_back(ingredient.Over(level_, piece, kWholeElement));
    }
    return derivatives;
  }

private:
  JointModes Joint;
  ScaledModes Map;
  ScaledModes Displacement;
  int Exponent;
  std::vector<RangeIngredient> Ingredients;
  int level_ = 0;
};

/// det J from the eighteen derivatives.
template <class C>
ScaleSeries<C> DeterminantOf(const std::vector<C>& derivatives)
{
  std::vector<ScaleSeries<C>> J;
  for (std::size_t k = 0; k < 9; ++k)
  {
    J.push_back({ { derivatives[k], derivatives[9 + k] } });
  }
  return Determinant(std::span<const ScaleSeries<C>>(J));
}

/// The cubic below, or above, all those with these coefficients, for s >= 0.
Cubic EndOf(const ScaleSeries<Interval>& series, bool upper)
{
  Cubic c;
  for (std::size_t k = 0; k < 4; ++k)
  {
    c[k] = upper ? series.c[k].upper : series.c[k].lower;
  }
  return c;
}

/// A scale at which det J is proven not to be positive, and where.
struct InvertedAt
{
  double scale = kInfinity;
  int element = -1;
  Vec3 xi{ 0.0 };

  void Improve(const InvertedAt& other)
  {
    if (std::tie(other.scale, other.element) < std::tie(scale, element))
    {
      *this = other;
    }
  }
};

/// A part of an element, given as a box in eta.
struct ScaleBox
{
  std::shared_ptr<const ElementCubic> cubic;
  int element = -1;
  PieceForm::Piece piece{};
  Box3 eta;
  std::vector<BoxPolynomial> determinant; ///< by the power of s; empty: not computed
  double reach = 0.0;                     ///< det J is positive for scales from 0 to less than this
  std::int64_t number = 0;                ///< in the order in which boxes were made

  [[nodiscard]] Vec3 XiAt(const std::array<double, 3>& t) const
  {
    Vec3 at;
    for (int d = 0; d < 3; ++d)
    {
      at[d] = std::lerp(eta.lower[d], eta.upper[d], 0.5 + 0.5 * t[static_cast<std::size_t>(d)]);
    }
    return TensorToReference(cubic->GetShape(), at);
  }
};

std::array<double, 3> CornerOf(unsigned corner)
{
  const auto end = [corner](unsigned d) { return (corner >> d & 1U) != 0 ? 1.0 : -1.0; };
  return { end(0), end(1), end(2) };
}

/// Lowers `found` to a scale at which det J, which is `series` at the point t of the box, is not
/// positive.
void Improve(const ScaleBox& box, const ScaleSeries<Interval>& series,
  const std::array<double, 3>& t, double most, InvertedAt& found)
{
  const double scale = box.cubic->FromUnits(
    NotPositiveAt(EndOf(series, true), box.cubic->ToUnits(std::min(most, found.scale))));
  found.Improve({ scale, box.element, box.XiAt(t) });
}

/// The whole pieces of an element, bounded roughly by the ranges of the derivatives for scales up
/// to `most`. None where a derivative is not bounded.
std::vector<ScaleBox> PiecesOf(
  const std::shared_ptr<const ElementCubic>& cubic, int element, double most, InvertedAt& found)
{
  std::vector<ScaleBox> boxes;
  const int pieces = 1 << cubic->Level();
  const double width = 2.0 / pieces;
  for (int i = 0; i < pieces * pieces * pieces; ++i)
  {
    ScaleBox box{ cubic, element, { i / (pieces * pieces), i / pieces % pieces, i % pieces }, {},
      {} };
    for (int d = 0; d < 3; ++d)
    {
      box.eta.lower[d] = -1.0 + width * box.piece[static_cast<std::size_t>(d)];
      box.eta.upper[d] = box.eta.lower[d] + width;
    }
    const std::vector<BoxPolynomial> derivatives = cubic->Derivatives(box.piece);
    if (!std::ranges::all_of(
          derivatives, [](const BoxPolynomial& one) { return std::isfinite(one.error); }))
    {
      return {};
    }
    std::vector<Interval> values(derivatives.size());
    std::ranges::transform(
      derivatives, values.begin(), [](const BoxPolynomial& one) { return one.Hull(); });
    const ScaleSeries<Interval> hull = DeterminantOf(values);
    box.reach = cubic->FromUnits(PositiveUpTo(EndOf(hull, false), cubic->ToUnits(most)));
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      std::ranges::transform(derivatives, values.begin(),
        [corner](const BoxPolynomial& one) { return one.AtCorner(corner); });
      Improve(box, DeterminantOf(values), CornerOf(corner), most, found);
    }
    boxes.push_back(std::move(box));
  }
  return boxes;
}

/// Bounds a box by the Bernstein coefficients of det J, and looks for an inverted point at its
/// corners and where the bound is reached.
void Bound(ScaleBox& box, double most, InvertedAt& found)
{
  const std::vector<BoxPolynomial>& f = box.determinant;
  double reach = box.cubic->ToUnits(most);
  std::size_t at = 0;
  for (std::size_t i = 0; i < f[0].b.size(); ++i)
  {
    Cubic c;
    for (std::size_t k = 0; k < 4; ++k)
    {
      c[k] = rounding::Below(f[k].b[i] - f[k].error);
    }
    if (!IsPositive(c, 0.0, reach))
    {
      const double positive = PositiveUpTo(c, reach);
      at = positive < reach ? i : at;
      reach = std::min(reach, positive);
    }
  }
  box.reach = std::max(box.reach, box.cubic->FromUnits(reach));
  const Degrees& degree = f[0].degree;
  std::array<double, 3> t{};
  for (int d = 0; d < 3; ++d)
  {
    const auto direction = static_cast<std::size_t>(d);
    const auto index = at / StrideOf(degree, d) % static_cast<std::size_t>(degree[direction] + 1);
    t[direction] =
      degree[direction] > 0 ? 2.0 * static_cast<double>(index) / degree[direction] - 1.0 : 0.0;
  }
  ScaleSeries<Interval> series;
  for (const BoxPolynomial& power : f)
  {
    series.c.push_back(power.At(t));
  }
  Improve(box, series, t, most, found);
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    std::ranges::transform(
      f, series.c.begin(), [corner](const BoxPolynomial& power) { return power.AtCorner(corner); });
    Improve(box, series, CornerOf(corner), most, found);
  }
}

/// The direction along which det J at the scale that bounds the box is farthest from linear.
int SplitDirectionOf(const ScaleBox& box)
{
  const double s = box.cubic->ToUnits(box.reach);
  BoxPolynomial sum{ box.determinant[0].degree, {}, 0.0 };
  for (std::size_t i = 0; i < box.determinant[0].b.size(); ++i)
  {
    sum.b.push_back(ValueAt({ box.determinant[0].b[i], box.determinant[1].b[i],
                              box.determinant[2].b[i], box.determinant[3].b[i] },
      s));
  }
  const Vec3 width = box.eta.upper - box.eta.lower;
  int best = width.x >= width.y && width.x >= width.z ? 0 : width.y >= width.z ? 1 : 2;
  double most = 0.0;
  for (int d = 0; d < 3; ++d)
  {
    if (const double variation = sum.Variation(d, 2); variation > most)
    {
      most = variation;
      best = d;
    }
  }
  return best;
}

/// The result of Refine: the same box with the bounds of det J itself, or its children.
struct Refined
{
  std::vector<ScaleBox> boxes;
  InvertedAt found;
};

Refined Refine(ScaleBox box, double most)
{
  Refined refined;
  if (box.determinant.empty())
  {
    box.determinant = DeterminantOf(box.cubic->Derivatives(box.piece)).c;
    refined.boxes.push_back(std::move(box));
  }
  else
  {
    const int d = SplitDirectionOf(box);
    ScaleBox upper = box;
    box.eta.upper[d] = upper.eta.lower[d] = 0.5 * (box.eta.lower[d] + box.eta.upper[d]);
    for (std::size_t k = 0; k < box.determinant.size(); ++k)
    {
      upper.determinant[k] = box.determinant[k].Subdivide(d);
    }
    refined.boxes.push_back(std::move(box));
    refined.boxes.push_back(std::move(upper));
  }
  for (ScaleBox& one : refined.boxes)
  {
    Bound(one, most, refined.found);
  }
  return refined;
}

std::size_t HeldBy(const ScaleBox& box)
{
  std::size_t held = 0;
  for (const BoxPolynomial& power : box.determinant)
  {
    held += power.b.size();
  }
  return held;
}

/// Subdivides the boxes with the smallest scales until these are known well enough.
class LimitSearch
{
public:
  LimitSearch(const WarpEffort& effort, double most)
    : Effort(effort)
    , Most(most)
  {
  }

  void Add(ScaleBox box)
  {
    ++Count;
    if (box.reach < Upper())
    {
      box.number = Count;
      Held += HeldBy(box);
      Boxes.push(std::move(box));
    }
  }
  void Add(const InvertedAt& found) { Found.Improve(found); }

  void Run()
  {
    // Whole pieces, and these with det J, do not count.
    const std::int64_t budget = 2 * Count + Effort.boxes;
    while (!IsMet() && Count < budget && Held <= kMaxCoefficients)
    {
      std::vector<Refined> round(std::min(kRound, Boxes.size()));
      for (Refined& one : round)
      {
        one.boxes.push_back(Boxes.top());
        Held -= HeldBy(Boxes.top());
        Boxes.pop();
      }
      tbb::parallel_for(std::size_t{ 0 }, round.size(),
        [&](std::size_t k) { round[k] = Refine(std::move(round[k].boxes.front()), Upper()); });
      for (const Refined& one : round)
      {
        Add(one.found);
      }
      for (Refined& one : round)
      {
        for (ScaleBox& box : one.boxes)
        {
          Add(std::move(box));
        }
      }
    }
  }

  void PutInto(WarpLimit& limit) const
  {
    limit.positive = Lower();
    limit.inverted = Found.scale;
    limit.element = Found.element;
    limit.xi = Found.element >= 0 ? Found.xi : limit.xi;
    limit.boxes = Count;
    limit.met = IsMet();
  }

private:
  struct IsLater
  {
    bool operator()(const ScaleBox& a, const ScaleBox& b) const
    {
      return std::tie(a.reach, a.number) > std::tie(b.reach, b.number);
    }
  };

  [[nodiscard]] double Upper() const { return std::min(Most, Found.scale); }
  [[nodiscard]] double Lower() const
  {
    return Boxes.empty() ? Upper() : std::min(Boxes.top().reach, Upper());
  }
  [[nodiscard]] bool IsMet() const
  {
    return Lower() >= Upper() || Upper() - Lower() <= Effort.tolerance * Upper();
  }

  WarpEffort Effort;
  double Most;
  std::priority_queue<ScaleBox, std::vector<ScaleBox>, IsLater> Boxes;
  InvertedAt Found;
  std::int64_t Count = 0;
  std::size_t Held = 0;
};

void RequireOrders(const Mesh& mesh, std::span<const WarpTerm> displacement)
{
  int order = 0;
  for (const Space& space : mesh.map.spaces)
  {
    order = std::max(order, space.MaxOrder());
  }
  for (const WarpTerm& term : displacement)
  {
    for (const Space& space : term.field->values.spaces)
    {
      order = std::max(order, space.MaxOrder());
    }
  }
  if (3 * order > kMaxDegree)
  {
    throw Unsupported("limits of a displacement are found for orders up to " +
      std::to_string(kMaxDegree / 3) + ", and map or field has order " + std::to_string(order) +
      "; truncate the field.");
  }
}
} // namespace

WarpLimit FindWarpLimit(const Mesh& mesh, std::span<const WarpTerm> displacement,
  const WarpEffort& effort, const RangeProgress& progress)
{
  RequireOrders(mesh, displacement);
  WarpLimit limit;
  const std::vector<ElementValidity> validity = ValidityOf(
    mesh, RangeEffort{}, [&progress](double part) { progress ? progress(0.3 * part) : void(); });
  const auto elements = static_cast<std::size_t>(mesh.Elements());
  const auto cubicOf = [&](std::size_t e)
  { return std::make_shared<const ElementCubic>(mesh, static_cast<int>(e), displacement); };
  std::vector<double> natural(elements, kInfinity);
  tbb::parallel_for(std::size_t{ 0 }, elements,
    [&](std::size_t e)
    {
      if (validity[e].validity == Validity::Valid)
      {
        natural[e] = cubicOf(e)->NaturalScale();
      }
    });
  double smallest = kInfinity;
  for (const double scale : natural)
  {
    smallest = std::min(smallest, scale);
  }
  const double most = kMaxReach * smallest;
  if (!std::isfinite(most))
  {
    limit.positive = kInfinity;
    limit.met = true;
  }
  std::vector<std::vector<ScaleBox>> pieces(elements);
  std::vector<InvertedAt> found(elements);
  ParallelProgress done(progress, 0.3, 0.6, elements);
  tbb::parallel_for(std::size_t{ 0 }, std::isfinite(most) ? elements : 0,
    [&](std::size_t e)
    {
      // Elements that move as a whole do not fold.
      if (std::isfinite(natural[e]))
      {
        pieces[e] = PiecesOf(cubicOf(e), static_cast<int>(e), most, found[e]);
      }
      done.Add();
    });
  LimitSearch search(effort, most);
  for (const InvertedAt& one : found)
  {
    search.Add(one);
  }
  for (std::size_t e = 0; e < elements; ++e)
  {
    if (validity[e].validity != Validity::Valid || (std::isfinite(natural[e]) && pieces[e].empty()))
    {
      limit.leftOut.push_back(static_cast<int>(e));
    }
    for (ScaleBox& box : pieces[e])
    {
      search.Add(std::move(box));
    }
  }
  if (std::isfinite(most))
  {
    search.Run();
    search.PutInto(limit);
  }
  if (progress)
  {
    progress(1.0);
  }
  return limit;
}
} // namespace pixelexact
