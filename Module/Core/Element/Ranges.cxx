// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/Ranges.h"

#include "Core/Base/Error.h"
#include "Core/Element/QuantityFunction.h"
#include "Core/Element/RangeIngredients.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pixelexact
{
namespace
{
bool NeedsMap(const RangeQuestion& question)
{
  switch (question.quantity)
  {
    case Quantity::Component:
    case Quantity::Magnitude:
      return question.field->mapping != Mapping::Identity;
    default:
      return true;
  }
}
} // namespace

struct ElementRange::Internals
{
  Internals(const RangeQuestion& question, const Box3& part)
    : function(question)
    , box(part)
  {
  }
  [[nodiscard]] std::vector<BoxPolynomial> Polynomials(
    const PieceForm::Piece& piece, const Box3& within) const;

  QuantityFunction function;
  Box3 box;
  std::optional<ScaledModes> map;
  std::optional<ScaledModes> field;
  std::vector<RangeIngredient> ingredients;
  int exponent = 0;
  int level = 0;
};

bool IsAnswerable(const RangeQuestion& question)
{
  if (question.field != nullptr && question.field->function != nullptr)
  {
    return false;
  }
  const bool gradient = question.quantity == Quantity::GradientComponent ||
    question.quantity == Quantity::GradientMagnitude;
  return !gradient || question.field->mapping == Mapping::Identity;
}

ElementRange::ElementRange(
  const Mesh& mesh, int element, const RangeQuestion& question, const Box3& part)
  : Data(std::make_unique<Internals>(question, part))
{
  if (!IsAnswerable(question))
  {
    RequirePolynomials(*question.field, "proven ranges");
    throw Unsupported("The gradient of field '" + question.field->name +
      "', an H(curl), H(div) or density field, cannot be certified.");
  }
  int mapExponent = 0;
  if (NeedsMap(question))
  {
    auto& map = Data->map.emplace(mesh.map.SpaceOf(element), mesh.map.Coefficients(element), 3);
    mapExponent = map.exponent + std::ilogb(mesh.size[static_cast<std::size_t>(element)]);
    AddDerivatives(map, 0, 3, Data->ingredients);
  }
  int fieldExponent = 0;
  if (question.quantity != Quantity::Jacobian)
  {
    const Expansion& values = question.field->values;
    const bool derivatives = question.quantity == Quantity::GradientComponent ||
      question.quantity == Quantity::GradientMagnitude;
    const bool all = !derivatives &&
      (question.quantity == Quantity::Magnitude || question.field->mapping == Mapping::Covariant ||
        question.field->mapping == Mapping::Contravariant);
    const int count = all ? values.components : 1;
    // Those of other components neither need to be finite nor to be of its size.
    const Space& space = values.SpaceOf(element);
    auto& field = Data->field.emplace(space,
      values.Coefficients(element) +
        static_cast<std::size_t>(all ? 0 : question.component) *
          static_cast<std::size_t>(space.Modes()),
      count);
    fieldExponent = field.exponent;
    if (derivatives)
    {
      AddDerivatives(field, 0, 1, Data->ingredients);
    }
    else
    {
      for (int c = 0; c < count; ++c)
      {
        Data->ingredients.push_back({ &field, c, Part::Value });
      }
    }
  }
  Data->exponent = fieldExponent + Data->function.PowerOfLength() * mapExponent;
  Data->level = IsFinite() ? LevelFor(Data->ingredients) : 0;
}

ElementRange::~ElementRange() = default;

bool ElementRange::IsFinite() const
{
  return (!Data->map || Data->map->finite) && (!Data->field || Data->field->finite);
}

int ElementRange::Exponent() const
{
  return Data->exponent;
}

std::vector<BoxPolynomial> ElementRange::Internals::Polynomials(
  const PieceForm::Piece& piece, const Box3& within) const
{
  std::vector<BoxPolynomial> polynomials;
  for (const RangeIngredient& ingredient : ingredients)
  {
    polynomials.push_back(ingredient.Over(level, piece, within));
  }
  function.ToWorld(polynomials);
  return polynomials;
}

const RangeFunction& ElementRange::Function() const
{
  return Data->function;
}

void ElementRange::ForEachBox(const std::function<void(RangeBox)>& visit) const
{
  const int pieces = 1 << Data->level;
  for (int i = 0; i < pieces * pieces * pieces; ++i)
  {
    const PieceForm::Piece piece{ i / (pieces * pieces), i / pieces % pieces, i % pieces };
    const Box3 within = PartInPiece(Data->box, Data->level, piece);
    if (!(within.lower.x <= within.upper.x && within.lower.y <= within.upper.y &&
          within.lower.z <= within.upper.z))
    {
      continue;
    }
    RangeBox box;
    box.polynomials = Data->Polynomials(piece, within);
    if (pieces > 2)
    {
      box.remake = [this, piece, within] { return Data->Polynomials(piece, within); };
    }
    visit(std::move(box));
  }
}

std::unique_ptr<RangeSearch> ElementRange::Begin(const Interval& known) const
{
  auto search = std::make_unique<RangeSearch>(Data->function, known);
  ForEachBox([&search](RangeBox box) { search->Add(std::move(box)); });
  return search;
}

CertifiedRange RangeOf(const Mesh& mesh, int element, const RangeQuestion& question,
  const RangeEffort& effort, const Box3& part)
{
  const ElementRange range(mesh, element, question, part);
  if (!range.IsFinite())
  {
    CertifiedRange nothing;
    nothing.finite = false;
    return nothing;
  }
  const auto search = range.Begin();
  return Scaled(SearchRange(*search, effort.tolerance, 0.0, effort.boxes), range.Exponent());
}

Interval Scaled(const Interval& value, int exponent)
{
  const Interval scaled{ std::ldexp(value.lower, exponent), std::ldexp(value.upper, exponent) };
  // Exact, but for over- and underflow.
  const Interval outward = rounding::Outward(scaled.lower, scaled.upper);
  return { std::ldexp(scaled.lower, -exponent) == value.lower ? scaled.lower : outward.lower,
    std::ldexp(scaled.upper, -exponent) == value.upper ? scaled.upper : outward.upper };
}

CertifiedRange Scaled(const CertifiedRange& range, int exponent)
{
  CertifiedRange scaled = range;
  scaled.outer = Scaled(range.outer, exponent);
  scaled.attained = { Scaled(range.attained.lower, exponent).upper,
    Scaled(range.attained.upper, exponent).lower };
  return scaled;
}
} // namespace pixelexact
