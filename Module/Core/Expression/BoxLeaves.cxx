// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/BoxLeaves.h"

#include "Core/Expression/PointLeaves.h"
#include "Core/Math/Rounding.h"
#include "Core/Shape/Shape.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace pixelexact
{
namespace
{
// Places in the list of HessianFunction::Polynomials.
constexpr std::size_t kSecondsOfMap = 12;
constexpr std::size_t kSecondsOfField = 30;
constexpr std::size_t kFactors4 = 36;

bool IsOfFields(const Graph::Node& leaf)
{
  return leaf.operation == Operation::Value || leaf.operation == Operation::Slope ||
    leaf.operation == Operation::Curvature || leaf.operation == Operation::ValueByXi ||
    leaf.operation == Operation::SlopeByXi;
}

/// xi_direction over a part of a piece: as a function of each eta it is of degree 1.
BoxPolynomial ReferenceOver(
  Shape shape, int direction, int level, const PieceForm::Piece& piece, const Box3& within)
{
  const double pieces = 1 << level;
  BoxPolynomial xi{ { 1, 1, 1 }, {}, 0x1p-50 };
  for (int corner = 0; corner < 8; ++corner)
  {
    Vec3 eta;
    for (int d = 0; d < 3; ++d)
    {
      const double middle = (2.0 * piece[static_cast<std::size_t>(d)] + 1.0) / pieces - 1.0;
      const bool upper = (corner >> (2 - d) & 1) != 0;
      eta[d] = middle + (upper ? within.upper : within.lower)[d] / pieces;
    }
    xi.b.push_back(TensorToReference(shape, eta)[direction]);
  }
  return xi;
}

/// Bounds the rounding of the kernels' second derivatives by xi of some components, by Markov's
/// inequality for each mode: of degree n it is 4 n^2 times as steep as it is large, at most (D.
/// Wilhelmsen, J. Approx. Theory 11, 1974; the shapes are more than 1 wide). Modes of pyramids are
/// no polynomials in xi.
double SecondsError(const ScaledModes& modes, int first, int count)
{
  constexpr double kSafety = 16.0;
  if (modes.space.shape == Shape::Pyramid)
  {
    return kInfinity;
  }
  const double n = modes.space.MaxOrder();
  double error = 0.0;
  for (int c = first; c < first + count; ++c)
  {
    error = std::max(error, RangeIngredient{ &modes, c, Part::Value }.RoundingInKernels(0, {}));
  }
  return kSafety * (4.0 * n * n) * (4.0 * n * n) * error;
}
} // namespace

BoxLeaves::BoxLeaves(std::span<const Graph::Node> leaves, std::span<const Field* const> fields,
  std::span<const std::int64_t> numbers, const Mesh& mesh, int element)
  : Leaves(leaves.begin(), leaves.end())
  , mesh_(mesh)
  , Element(element)
  , Map(mesh.map.SpaceOf(element), mesh.map.Coefficients(element), 3)
{
  for (const Field* field : fields)
  {
    NeededField& needed = Fields.emplace_back();
    needed.field = field;
    needed.components.resize(static_cast<std::size_t>(field->values.components));
  }
  for (Graph::Node& leaf : Leaves)
  {
    switch (leaf.operation)
    {
      // Numbers of the element become constants.
      case Operation::ElementNumber:
        leaf = { .constant = static_cast<double>(
                   numbers.empty() ? element : numbers[static_cast<std::size_t>(element)]) };
        break;
      case Operation::Order:
        leaf = { .constant = static_cast<double>(OrderOf(leaf, Fields, element)) };
        break;
      default:
        Need(leaf);
    }
  }
  Finite = Map.finite;
  for (const NeededField& needed : Fields)
  {
    Finite = Finite && (!needed.modes || needed.modes->finite);
  }
  if (Finite)
  {
    level_ = LevelFor(Ingredients);
  }
}

void BoxLeaves::Need(const Graph::Node& leaf)
{
  switch (leaf.operation)
  {
    case Operation::Reference:
      NeedsXi = true;
      return;
    case Operation::Coordinate:
      Choose(Map, leaf.a, false, OfMap[static_cast<std::size_t>(leaf.a)]);
      return;
    case Operation::InverseJacobian:
    case Operation::Determinant:
    case Operation::ScaledJacobian:
      NeedJacobian();
      return;
    case Operation::CoordinateByXi:
      NeedJacobian();
      NeedsSeconds = NeedsSeconds || leaf.c >= 0;
      return;
    default:
      break;
  }
  if (!IsOfFields(leaf))
  {
    return;
  }
  NeededField& needed = Fields[static_cast<std::size_t>(leaf.field)];
  const Expansion& values = needed.field->values;
  if (!needed.modes)
  {
    needed.modes = std::make_unique<const ScaledModes>(
      values.SpaceOf(Element), values.Coefficients(Element), values.components);
  }
  const bool isMapped = needed.field->mapping != Mapping::Identity;
  const bool isSlope = leaf.operation != Operation::Value;
  if (isMapped || isSlope)
  {
    NeedJacobian();
  }
  const bool isCurvature = leaf.operation == Operation::Curvature;
  const bool isTurned = leaf.operation == Operation::SlopeByXi;
  const bool isThird = isTurned && leaf.c >= 0;
  const bool isSecond =
    isCurvature || isTurned || (leaf.operation == Operation::ValueByXi && leaf.b >= 0);
  NeedsSeconds = NeedsSeconds || isSecond;
  NeedsThirds = NeedsThirds || isThird;
  for (int c = 0; c < values.components; ++c)
  {
    if (isMapped || c == leaf.component)
    {
      Places& places = needed.components[static_cast<std::size_t>(c)];
      Choose(*needed.modes, c, false, places);
      if (isSlope && !isMapped)
      {
        Choose(*needed.modes, c, true, places);
        places.hasSeconds = places.hasSeconds || isSecond;
        places.hasThirds = places.hasThirds || isThird;
        places.hasCurvatures = places.hasCurvatures || isCurvature;
        places.hasTurned = places.hasTurned || isTurned;
      }
    }
  }
}

void BoxLeaves::NeedJacobian()
{
  for (int c = 0; c < 3; ++c)
  {
    Choose(Map, c, true, OfMap[static_cast<std::size_t>(c)]);
  }
  NeedsJacobian = true;
}

/// Adds a function's polynomials if they are not in the list yet.
void BoxLeaves::Choose(const ScaledModes& modes, int component, bool slopes, Places& places)
{
  int& place = slopes ? places.slope : places.value;
  if (place >= 0)
  {
    return;
  }
  place = static_cast<int>(Ingredients.size());
  if (slopes)
  {
    AddDerivatives(modes, component, 1, Ingredients);
  }
  else
  {
    Ingredients.push_back({ &modes, component, Part::Value });
  }
}

void BoxLeaves::NeedJet(const Vec3& coordinateErrors)
{
  NeedJacobian();
  OfCoordinates = coordinateErrors;
  if (!Finite)
  {
    return;
  }
  level_ = LevelFor(Ingredients);
  for (const RangeIngredient& ingredient : Ingredients)
  {
    OfKernels.push_back(ingredient.RoundingInKernels(0, {}));
  }
  const std::size_t xi = NeedsXi ? 3 : 0;
  OfKernels.resize(Ingredients.size() + xi);
  OfBends = SecondsError(Map, 0, 3);
  for (NeededField& needed : Fields)
  {
    for (std::size_t c = 0; c < needed.components.size(); ++c)
    {
      Places& places = needed.components[c];
      places.secondsError =
        places.hasSeconds ? SecondsError(*needed.modes, static_cast<int>(c), 1) : 0.0;
    }
  }
}

ElementJet::Work BoxLeaves::WorkOf(int level) const
{
  // Sums and products of Evaluate.
  constexpr std::int64_t kOfInverse = 60;
  constexpr std::int64_t kOfBends = 36;
  constexpr std::int64_t kOfSlopes = 15;
  constexpr std::int64_t kOfTurned = 80;
  constexpr std::int64_t kOfCurvatures = 30;
  constexpr std::int64_t kOfThirds = 520;
  const auto termsOf = [level](const ScaledModes& modes, std::int64_t count)
  {
    const PieceForm& form = PieceForm::Of(modes.space, level);
    return count * static_cast<std::int64_t>(form.Size()) * (1 + std::ranges::max(form.Degree()));
  };
  ElementJet::Work work;
  for (const RangeIngredient& ingredient : Ingredients)
  {
    work.terms += termsOf(*ingredient.modes, 1);
  }
  work.terms += termsOf(Map, (NeedsSeconds ? 18 : 0) + (NeedsThirds ? 30 : 0));
  work.operations = (NeedsJacobian ? kOfInverse : 0) + (NeedsSeconds ? kOfBends : 0);
  ForEachDifferentiated(
    [&](const NeededField& needed, int /*component*/, const Places& places)
    {
      work.terms +=
        termsOf(*needed.modes, (places.hasSeconds ? 6 : 0) + (places.hasThirds ? 10 : 0));
      work.operations += kOfSlopes + (places.hasTurned || places.hasCurvatures ? kOfTurned : 0) +
        (places.hasCurvatures ? kOfCurvatures : 0) + (places.hasThirds ? kOfThirds : 0);
    });
  return work;
}

std::vector<BoxPolynomial> BoxLeaves::Polynomials(
  int level, const PieceForm::Piece& piece, const Box3& within) const
{
  std::vector<BoxPolynomial> list;
  for (const RangeIngredient& ingredient : Ingredients)
  {
    list.push_back(ingredient.Over(level, piece, within));
  }
  const Shape shape = Map.space.shape;
  for (int d = 0; d < 3 && NeedsXi; ++d)
  {
    list.push_back(ReferenceOver(shape, d, level, piece, within));
  }
  if (!NeedsSeconds)
  {
    return list;
  }
  const auto add = [&](std::vector<BoxPolynomial>& all, std::size_t first, std::size_t count)
  {
    for (std::size_t k = first; k < first + count; ++k)
    {
      list.push_back(std::move(all[k]));
      RestrictTo(within, list.back());
    }
  };
  std::vector<BoxPolynomial> ofMap = HessianFunction::Polynomials(Map, Map, 0, level, piece);
  add(ofMap, kFactors4, 4);
  add(ofMap, kSecondsOfMap, 18);
  for (const NeededField& needed : Fields)
  {
    for (std::size_t c = 0; c < needed.components.size(); ++c)
    {
      if (needed.components[c].hasSeconds)
      {
        std::vector<BoxPolynomial> all =
          HessianFunction::Polynomials(Map, *needed.modes, static_cast<int>(c), level, piece);
        add(all, kSecondsOfField, 6);
      }
    }
  }
  const auto addThirds = [&](const ScaledModes& modes, int component)
  {
    std::vector<BoxPolynomial> thirds = HessianFunction::Thirds(modes, component, level, piece);
    add(thirds, 0, kThirds);
  };
  for (int c = 0; c < 3 && NeedsThirds; ++c)
  {
    addThirds(Map, c);
  }
  for (const NeededField& needed : Fields)
  {
    for (std::size_t c = 0; c < needed.components.size(); ++c)
    {
      if (needed.components[c].hasThirds)
      {
        addThirds(*needed.modes, static_cast<int>(c));
      }
    }
  }
  return list;
}
} // namespace pixelexact
