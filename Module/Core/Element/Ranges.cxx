// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Element/Ranges.h"

#include "Core/Base/Error.h"
#include "Core/Element/FieldFunction.h"
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
bool AsksForMap(const RangeQuestion& question)
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

/// A quantity of polynomials: of the map's derivatives and of one field.
class FieldQuantity final : public QuantityFunction
{
public:
  FieldQuantity(const Mesh& mesh, int element, const RangeQuestion& question);

  [[nodiscard]] bool IsFinite() const override
  {
    return (!Map || Map->finite) && (!Field || Field->finite);
  }
  [[nodiscard]] int Level() const override { return level_; }
  [[nodiscard]] int Exponent() const override { return exponent_; }
  [[nodiscard]] std::vector<BoxPolynomial> Polynomials(
    const PieceForm::Piece& piece, const Box3& within) const override;

private:
  std::optional<ScaledModes> Map;
  std::optional<ScaledModes> Field;
  std::vector<RangeIngredient> Ingredients;
  int exponent_ = 0;
  int level_ = 0;
};

FieldQuantity::FieldQuantity(const Mesh& mesh, int element, const RangeQuestion& question)
  : QuantityFunction(question)
{
  int mapExponent = 0;
  if (AsksForMap(question))
  {
    auto& map = Map.emplace(mesh.map.SpaceOf(element), mesh.map.Coefficients(element), 3);
    mapExponent = map.exponent + std::ilogb(mesh.size[static_cast<std::size_t>(element)]);
    AddDerivatives(map, 0, 3, Ingredients);
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
    // Other components need not be finite, and do not influence the scale.
    const Space& space = values.SpaceOf(element);
    auto& field = Field.emplace(space,
      values.Coefficients(element) +
        static_cast<std::size_t>(all ? 0 : question.component) *
          static_cast<std::size_t>(space.Modes()),
      count);
    fieldExponent = field.exponent;
    if (derivatives)
    {
      AddDerivatives(field, 0, 1, Ingredients);
    }
    else
    {
      for (int c = 0; c < count; ++c)
      {
        Ingredients.push_back({ &field, c, Part::Value });
      }
    }
  }
  exponent_ = fieldExponent + PowerOfLength() * mapExponent;
  level_ = IsFinite() ? LevelFor(Ingredients) : 0;
}

std::vector<BoxPolynomial> FieldQuantity::Polynomials(
  const PieceForm::Piece& piece, const Box3& within) const
{
  std::vector<BoxPolynomial> polynomials;
  for (const RangeIngredient& ingredient : Ingredients)
  {
    polynomials.push_back(ingredient.Over(level_, piece, within));
  }
  ToWorld(polynomials);
  return polynomials;
}

std::unique_ptr<ElementQuantity> QuantityOn(
  const Mesh& mesh, int element, const RangeQuestion& question)
{
  if (question.field != nullptr && question.field->function != nullptr)
  {
    return question.field->function->OnElement(mesh, element,
      question.quantity == Quantity::Magnitude ? FieldFunction::kNorm : question.component);
  }
  return std::make_unique<FieldQuantity>(mesh, element, question);
}
} // namespace

bool IsAnswerable(const RangeQuestion& question)
{
  const bool gradient = question.quantity == Quantity::GradientComponent ||
    question.quantity == Quantity::GradientMagnitude;
  if (question.field != nullptr && question.field->function != nullptr)
  {
    const FieldFunction& function = *question.field->function;
    return !gradient && !function.NeedsNormals() && !function.NeedsNeighbours();
  }
  return !gradient || question.field->mapping == Mapping::Identity;
}

void RequireAnswer(const RangeQuestion& question)
{
  if (IsAnswerable(question))
  {
    return;
  }
  const Field& field = *question.field;
  if (field.function == nullptr)
  {
    throw Unsupported("The gradient of field '" + field.name +
      "', an H(curl), H(div) or density field, cannot be certified.");
  }
  throw Unsupported("No range of '" + field.name + "' is proven: " +
    (field.function->NeedsNormals()         ? "it needs the normal of a surface."
        : field.function->NeedsNeighbours() ? "it has jumps between elements."
                                            : "a gradient of an expression; write grad(...)."));
}

ElementRange::ElementRange(
  const Mesh& mesh, int element, const RangeQuestion& question, const Box3& part)
  : Part(part)
{
  RequireAnswer(question);
  quantity_ = QuantityOn(mesh, element, question);
}

void ElementRange::ForEachBox(const std::function<void(RangeBox)>& visit) const
{
  const int level = quantity_->Level();
  const int pieces = 1 << level;
  for (int i = 0; i < pieces * pieces * pieces; ++i)
  {
    const PieceForm::Piece piece{ i / (pieces * pieces), i / pieces % pieces, i % pieces };
    const Box3 within = PartInPiece(Part, level, piece);
    if (!(within.lower.x <= within.upper.x && within.lower.y <= within.upper.y &&
          within.lower.z <= within.upper.z))
    {
      continue;
    }
    RangeBox box;
    box.polynomials = quantity_->Polynomials(piece, within);
    box.place = BoxOfPart(within, level, piece);
    if (pieces > 2)
    {
      box.remake = [this, piece, within] { return quantity_->Polynomials(piece, within); };
    }
    visit(std::move(box));
  }
}

std::unique_ptr<RangeSearch> ElementRange::Begin(const Interval& known) const
{
  auto search = std::make_unique<RangeSearch>(*quantity_, known);
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
