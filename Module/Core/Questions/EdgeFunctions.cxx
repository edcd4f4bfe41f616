// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/EdgeFunctions.h"

#include "Core/Element/Ranges.h"
#include "Core/Math/Rounding.h"
#include "Core/Questions/EdgeArithmetic.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pixelexact
{
using edges::LargestOf;
using edges::SumOf;

namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Halvings of boxes on which the map is not regular, and of those where it is: of functions with
/// few coefficients. Nodes of many cost more, and there are fewer of them.
constexpr int kMostHalvings[2] = { 15, 17 };
constexpr double kFewCoefficients = 216.0;
/// What all elements' polynomials may take; of others they are made each time.
constexpr std::int64_t kMostBytes = std::int64_t{ 256 } << 20;
std::atomic<std::int64_t> bytesKept{ 0 };
constexpr Part kBy[3] = { Part::ByXi1, Part::ByXi2, Part::ByXi3 };
} // namespace

EdgeFunctions::EdgeFunctions(const Mesh& mesh, const ElementBounds& bounds, int element,
  const Field& field, int component, double rounding)
  : EdgeFunctions(mesh, bounds, element,
      ScaledModes(field.values.SpaceOf(element),
        field.values.Coefficients(element) +
          static_cast<std::ptrdiff_t>(std::max(component, 0)) *
            field.values.SpaceOf(element).Modes(),
        component < 0 ? field.values.components : 1),
      component < 0 ? field.values.components : 1, rounding)
{
}

EdgeFunctions::EdgeFunctions(const Mesh& mesh, const ElementBounds& bounds, int element)
  : EdgeFunctions(mesh, bounds, element,
      ScaledModes(mesh.map.SpaceOf(element), mesh.map.Coefficients(element), 0), 0, 0.0)
{
}

EdgeFunctions::EdgeFunctions(const Mesh& mesh, const ElementBounds& bounds, int element,
  ScaledModes component, int count, double rounding)
  : Map(mesh.map.SpaceOf(element), mesh.map.Coefficients(element), 3)
  , Component(std::move(component))
  , MapKernels(KernelsFor(Map.space))
  , ComponentKernels(KernelsFor(Component.space))
  , Count(count)
  , Centre(mesh.centre[3 * static_cast<std::size_t>(element)],
      mesh.centre[3 * static_cast<std::size_t>(element) + 1],
      mesh.centre[3 * static_cast<std::size_t>(element) + 2])
  , Unit(mesh.size[static_cast<std::size_t>(element)])
  , Unsure{ bounds.uncertainty[0], bounds.uncertainty[1], bounds.uncertainty[2] }
  , Range(Interval::Everything())
{
  if (!IsFinite())
  {
    Error = kInfinity;
    return;
  }
  ChooseLevel();
  Kept = std::make_unique<MadeOnDemand<EdgePolynomials>>(std::size_t{ 1 } << (3 * Level));
  Range = ValuesOver({});
  Error = ErrorOf(Component, Count, Part::Value) * (1.0 + rounding / kUnitRoundoff);
  MapError = ErrorOf(Map, 3, Part::Value);
  for (const Part part : kBy)
  {
    SlopeError = std::max(SlopeError, ErrorOf(Component, Count, part));
    MapSlopeError = std::max(MapSlopeError, ErrorOf(Map, 3, part));
  }
}

EdgeFunctions::~EdgeFunctions()
{
  bytesKept -= Bytes.load();
}

void EdgeFunctions::ChooseLevel()
{
  std::vector<RangeIngredient> all;
  all.reserve(4 * (static_cast<std::size_t>(Count) + 3));
  for (int c = 0; c < Count; ++c)
  {
    all.push_back({ &Component, c, Part::Value });
  }
  for (int c = 0; c < 3; ++c)
  {
    all.push_back({ &Map, c, Part::Value });
  }
  AddDerivatives(Map, 0, 3, all);
  AddDerivatives(Component, 0, Count, all);
  Level = LevelFor(all);
  const auto fewer = [](std::size_t coefficients)
  {
    return std::max(
      0, static_cast<int>(std::log2(static_cast<double>(coefficients) / kFewCoefficients)));
  };
  const int besides[2] = { fewer(PieceForm::Of(Map.space, Level).Size()),
    fewer(PieceForm::Of(Component.space, Level).Size()) };
  for (std::size_t k = 0; k < 2; ++k)
  {
    Halvings[k] = kMostHalvings[k] - besides[k];
  }
}

Vec3 EdgeFunctions::RoundingInUnits(const Vec3& x) const
{
  return edges::kRoundoffs * (glm::abs(x) + glm::abs(Centre)) / Unit;
}

PointValues EdgeFunctions::ImagesAt(std::span<const Vec3> xi) const
{
  return { MapKernels, Map.space, Map.values.data(), 3, std::ldexp(1.0, Map.exponent), xi };
}

PointValues EdgeFunctions::ValuesAt(int component, std::span<const Vec3> xi) const
{
  const RangeIngredient ingredient{ &Component, component, Part::Value };
  return { ComponentKernels, Component.space, ingredient.Modes(), 1,
    std::ldexp(1.0, Component.exponent), xi };
}

EdgeFunctions::View EdgeFunctions::ViewAt(const Vec3& xi) const
{
  const PointValues map = ImagesAt(std::span(&xi, 1));
  View view{ xi, Vec3(0.0), Mat3(0.0), Mat3(0.0) };
  for (int c = 0; c < 3; ++c)
  {
    view.y[c] = map.values[c][0];
    for (int j = 0; j < 3; ++j)
    {
      view.jacobian[j][c] = map.slopes[3 * c + j][0];
    }
  }
  view.inverse = glm::inverse(view.jacobian);
  return view;
}

Interval EdgeFunctions::LinearValues(const Vec3& xi, std::span<const Vec3> places) const
{
  constexpr std::size_t kMost = Outline::kMostCorners + Outline::kMostCuts;
  // Of all components: at each place the value, its square, and its product with the sum of all.
  std::array<double, kMost> values{};
  std::array<double, kMost> squares{};
  std::array<double, kMost> products{};
  double square = 0.0;
  double size = 0.0;
  double length = 0.0;
  for (const Vec3& place : places)
  {
    length = std::max(length, SumOf(place - xi));
  }
  for (int c = 0; c < Count; ++c)
  {
    const PointValues component = ValuesAt(c, std::span(&xi, 1));
    const Vec3 slope = component.SlopeOf(0, 0);
    double sum = 0.0;
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      const double rise = glm::dot(slope, places[k] - xi);
      values[k] = component.values[0][0] + rise;
      sum += values[k];
    }
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      squares[k] += values[k] * values[k];
      products[k] += values[k] * sum;
    }
    square += sum * sum;
    size += std::fabs(component.values[0][0]) + LargestOf(slope) * length;
  }
  const double slack = 1e-14 * size + SlopeError * length;
  if (Count == 1)
  {
    const auto [least, most] =
      std::minmax_element(values.begin(), values.begin() + std::ssize(places));
    return { *least - slack, *most + slack };
  }
  // |v| >= v . n of the unit vector n along the sum, which is least at a corner.
  const auto least = *std::min_element(products.begin(), products.begin() + std::ssize(places));
  const auto most = *std::max_element(squares.begin(), squares.begin() + std::ssize(places));
  return { square > 0.0 ? std::max(0.0, least / std::sqrt(square) - 16.0 * slack) : 0.0,
    std::sqrt(most) + slack };
}

double EdgeFunctions::ErrorOf(const ScaledModes& modes, int components, Part part) const
{
  double error = 0.0;
  ForEachPiece({},
    [&](const PieceForm::Piece& piece, const Box3& /*within*/)
    {
      double sum = 0.0;
      for (int c = 0; c < components; ++c)
      {
        const RangeIngredient ingredient{ &modes, c, part };
        sum += PieceForm::Of(modes.space, Level).ErrorBound(part, piece, ingredient.Modes());
      }
      error = std::max(error, sum);
    });
  return std::ldexp(4.0 * error, modes.exponent);
}

template <class Visit>
void EdgeFunctions::ForEachPiece(const EtaBox& box, const Visit& visit) const
{
  const int pieces = 1 << Level;
  for (int i = 0; i < pieces * pieces * pieces; ++i)
  {
    const PieceForm::Piece piece{ i / (pieces * pieces), i / pieces % pieces, i % pieces };
    const Box3 within = PartInPiece({ box.lower, box.upper }, Level, piece);
    if (within.lower.x < within.upper.x && within.lower.y < within.upper.y &&
      within.lower.z < within.upper.z)
    {
      visit(piece, within);
    }
  }
}

Interval EdgeFunctions::RangeOver(
  const EtaBox& box, const ScaledModes& modes, int component, Part part) const
{
  Interval range(kInfinity, -kInfinity);
  ForEachPiece(box,
    [&](const PieceForm::Piece& piece, const Box3& within)
    {
      range =
        Join(range, RangeIngredient{ &modes, component, part }.Over(Level, piece, within).Hull());
    });
  return Scaled(range, modes.exponent);
}

Interval EdgeFunctions::ValuesOf(std::span<const Interval> components) const
{
  if (Count == 1)
  {
    return components.front();
  }
  Interval square(0.0);
  for (const Interval& component : components)
  {
    square += Square(component);
  }
  return Sqrt(square);
}

Interval EdgeFunctions::ValuesOver(const EtaBox& box) const
{
  std::vector<Interval> components;
  for (int c = 0; c < Count; ++c)
  {
    components.push_back(RangeOver(box, Component, c, Part::Value));
  }
  return ValuesOf(components);
}

template <class Visit>
void EdgeFunctions::WithPolynomials(const PieceForm::Piece& piece, const Visit& visit) const
{
  const auto at =
    static_cast<std::size_t>((((piece[0] << Level) + piece[1]) << Level) + piece[2]);
  const auto make = [&]
  {
    return std::make_unique<const EdgePolynomials>(
      Map, Count == 0 ? Map : Component, Count, Level, piece);
  };
  const EdgePolynomials* made = Kept->IfMade(at);
  if (!made && bytesKept.load(std::memory_order_relaxed) < kMostBytes)
  {
    made = &Kept->Get(at, make);
    // Once more, where two threads made them: a bound all the same, until it is all given back.
    bytesKept += static_cast<std::int64_t>(made->Bytes());
    Bytes += static_cast<std::int64_t>(made->Bytes());
  }
  visit(made ? *made : *make());
}

EdgeFunctions::MapRanges EdgeFunctions::MapOver(const EtaBox& box) const
{
  MapRanges ranges;
  std::array<Interval, 3> image;
  ForEachPiece(box,
    [&](const PieceForm::Piece& piece, const Box3& within)
    {
      WithPolynomials(piece,
        [&](const EdgePolynomials& polynomials)
        { ranges.ofPieces.push_back(polynomials.MapOver(within)); });
      const EdgePolynomials::MapHulls& here = ranges.ofPieces.back();
      const bool first = ranges.ofPieces.size() == 1;
      const auto add = [&](Interval& to, const Interval& hull)
      {
        const Interval range = Scaled(hull, Map.exponent);
        to = first ? range : Join(to, range);
      };
      for (std::size_t c = 0; c < 3; ++c)
      {
        add(image[c], here.image[c]);
        for (std::size_t k = 0; k < 3; ++k)
        {
          add(ranges.slopes[c][k], here.slopes[c][k]);
        }
      }
    });
  for (std::size_t c = 0; c < 3; ++c)
  {
    const int d = static_cast<int>(c);
    const double slack = Unsure[c];
    const Interval x =
      Interval(Unit) * (image[c] + Interval(-slack, slack)) + Interval(Centre[d]);
    ranges.image.lower[d] = x.lower;
    ranges.image.upper[d] = x.upper;
  }
  return ranges;
}

EdgeFunctions::Derivatives EdgeFunctions::DerivativesOver(
  const EtaBox& box, const MapRanges& map) const
{
  Derivatives ranges;
  std::vector<Interval> values(static_cast<std::size_t>(Count));
  ranges.components.resize(static_cast<std::size_t>(Count));
  std::size_t number = 0;
  ForEachPiece(box,
    [&](const PieceForm::Piece& piece, const Box3& within)
    {
      const bool first = number == 0;
      EdgePolynomials::Hulls here;
      WithPolynomials(piece,
        [&](const EdgePolynomials& polynomials)
        { here = polynomials.Over(within, map.ofPieces[number]); });
      ++number;
      const auto add = [&](Interval& to, const Interval& hull, int exponent)
      { to = first ? Scaled(hull, exponent) : Join(to, Scaled(hull, exponent)); };
      const auto addAll = [&](HessianFunction::XiRanges& to, const HessianFunction::XiRanges& hulls,
                            int exponent)
      {
        for (std::size_t k = 0; k < 3; ++k)
        {
          add(to.first[k], hulls.first[k], exponent);
        }
        for (std::size_t k = 0; k < 6; ++k)
        {
          add(to.second[k], hulls.second[k], exponent);
        }
      };
      for (std::size_t c = 0; c < 3; ++c)
      {
        addAll(ranges.map[c], here.map[c], Map.exponent);
      }
      for (std::size_t c = 0; c < values.size(); ++c)
      {
        addAll(ranges.components[c], here.components[c], Component.exponent);
        add(values[c], here.values[c], Component.exponent);
      }
    });
  ranges.values = ValuesOf(values);
  return ranges;
}
} // namespace pixelexact
