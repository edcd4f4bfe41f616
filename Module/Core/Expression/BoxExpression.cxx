// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/BoxExpression.h"

#include "Core/Element/LaneBuffer.h"
#include "Core/Expression/ModelValue.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace pixelexact
{
namespace
{
/// Unbounded where the scalar may be NaN.
AffineForm FormOfDefined(const BoxValue& value)
{
  AffineForm form = value.form;
  if (value.known.mayBeNaN)
  {
    form.e = Interval::Everything();
  }
  return form;
}

/// The wanted nodes, from enclosures of the polynomials of the leaves.
template <class T, class Apply>
std::vector<T> OutputsOf(const NodeList& list, const BoxLeaves& boxLeaves,
  std::span<const T> polynomials, const Apply& apply)
{
  std::vector<T> leaves(list.leaves.size());
  boxLeaves.Evaluate<T>(polynomials, leaves);
  std::vector<T> values;
  list.Compute([&](std::size_t k) { return leaves[k]; }, apply, values);
  std::vector<T> outputs;
  std::ranges::transform(
    list.outputs, std::back_inserter(outputs), [&](std::size_t place) { return values[place]; });
  return outputs;
}

std::vector<BoxValue> BoxValuesOf(std::span<const BoxPolynomial> polynomials)
{
  std::vector<BoxValue> values;
  for (const BoxPolynomial& polynomial : polynomials)
  {
    values.emplace_back(polynomial.Affine(), KnownInterval{ polynomial.Hull(), false });
  }
  return values;
}
} // namespace

BoxExpression::BoxExpression(std::shared_ptr<const NodeList> list,
  std::span<const Field* const> fields, std::span<const std::int64_t> numbers, const Mesh& mesh,
  int element)
  : List(std::move(list))
  , Leaves(List->leaves, fields, numbers, mesh, element)
{
}

BoxValue BoxExpression::ValueWith(std::span<const BoxValue> polynomials) const
{
  const std::vector<BoxValue> outputs =
    OutputsOf<BoxValue>(*List, Leaves, polynomials, ApplyToBoxes);
  return outputs.size() == 1 ? outputs.front() : NormOf(outputs);
}

Interval BoxExpression::Enclose(std::span<const BoxPolynomial> polynomials) const
{
  return ValueWith(BoxValuesOf(polynomials)).Range();
}

Interval BoxExpression::AtCorner(std::span<const BoxPolynomial> polynomials, unsigned corner) const
{
  std::vector<BoxValue> values;
  for (const BoxPolynomial& polynomial : polynomials)
  {
    values.emplace_back(KnownInterval{ polynomial.AtCorner(corner), false });
  }
  return ValueWith(values).Range();
}

ExpressionModels::ExpressionModels(std::shared_ptr<const NodeList> list,
  std::span<const Field* const> fields, std::span<const std::int64_t> numbers, const Mesh& mesh,
  int element)
  : List(std::move(list))
  , Leaves(List->leaves, fields, numbers, mesh, element)
{
}

std::vector<ChebyshevModel> ExpressionModels::Over(
  std::span<const ChebyshevModel> polynomials) const
{
  const std::vector<ModelValue> values(polynomials.begin(), polynomials.end());
  const std::vector<ModelValue> outputs =
    OutputsOf<ModelValue>(*List, Leaves, values, ApplyToModels);
  std::vector<ChebyshevModel> models;
  std::ranges::transform(outputs, std::back_inserter(models), &ModelValue::model);
  return models;
}

std::vector<Interval> ExpressionModels::Ranges(std::span<const BoxPolynomial> polynomials) const
{
  const std::vector<BoxValue> outputs =
    OutputsOf<BoxValue>(*List, Leaves, BoxValuesOf(polynomials), ApplyToBoxes);
  std::vector<Interval> ranges;
  std::ranges::transform(outputs, std::back_inserter(ranges), &BoxValue::Range);
  return ranges;
}

BoxJet::BoxJet(std::shared_ptr<const NodeList> list, const CompiledGraph& code,
  const OuterFunctions& outer, std::span<const Field* const> fields,
  std::span<const std::int64_t> numbers, const Mesh& mesh, int element,
  const Vec3& coordinateErrors)
  : List(std::move(list))
  , Code(code)
  , Outer(outer)
  , Leaves(List->leaves, fields, numbers, mesh, element)
  , mesh_(mesh)
  , Element(element)
{
  Leaves.NeedJet(coordinateErrors);
}

std::vector<BoxPolynomial> BoxJet::Polynomials(int level, const PieceForm::Piece& piece) const
{
  return Leaves.Polynomials(level, piece, { Vec3(-1.0), Vec3(1.0) });
}

JetBounds BoxJet::Over(std::span<const AffineForm> forms, std::span<const Interval> hulls) const
{
  std::vector<BoxValue> polynomials;
  for (std::size_t k = 0; k < forms.size(); ++k)
  {
    BoxValue& value = polynomials.emplace_back(forms[k], KnownInterval{ hulls[k], false });
    value.error = k < Leaves.Errors().size() ? Leaves.Errors()[k] : 0.0;
  }
  std::vector<BoxValue> leaves(List->leaves.size());
  std::array<BoxValue, 9> map;
  Leaves.Evaluate<BoxValue>(polynomials, leaves, &map);
  std::vector<BoxValue> nodes;
  List->Compute([&](std::size_t k) { return leaves[k]; }, ApplyToBoxes, nodes);
  const auto output = [&](std::size_t k) -> const BoxValue& { return nodes[List->outputs[k]]; };
  JetBounds bounds;
  const double error = output(0).error;
  const double outer = Outer.ErrorOver(output(0).Range() + Interval(-error, error));
  // Once for computed values, once for the values that the proof is about.
  bounds.values = outer > 0.0 ? output(0).Range() + Interval(-outer, outer) : output(0).Range();
  bounds.isContinuous = !output(0).mayJump;
  bounds.valueError = error + 2.0 * outer;
  for (std::size_t j = 0; j < 3; ++j)
  {
    BoxValue slope(0.0);
    for (std::size_t d = 0; d < 3; ++d)
    {
      slope = slope + map[3 * d + j] * output(1 + d);
    }
    bounds.slopes[j] = FormOfDefined(slope);
    bounds.slopeError = std::max(bounds.slopeError, slope.error);
  }
  if (!HasSeconds())
  {
    return bounds;
  }
  // Derivatives by xi are sharper than those by x, turned back. Where one may jump, there are no
  // second ones.
  std::array<const BoxValue*, 9> byXi{};
  for (std::size_t k = 0; k < byXi.size(); ++k)
  {
    byXi[k] = &output(4 + k);
  }
  if (std::ranges::any_of(byXi,
        [](const BoxValue* one) { return one->mayJump || !FormOfDefined(*one).e.IsFinite(); }))
  {
    return bounds;
  }
  bounds.seconds.emplace();
  for (std::size_t k = 0; k < byXi.size(); ++k)
  {
    (k < 3 ? bounds.slopes[k] : (*bounds.seconds)[k - 3]) = FormOfDefined(*byXi[k]);
  }
  return bounds;
}

void BoxJet::Evaluate(
  std::span<const Vec3> xi, std::span<double> values, std::span<Vec3> gradients) const
{
  const LaneBuffer lanes(xi);
  const auto stride = static_cast<std::size_t>(PaddedCount(static_cast<int>(xi.size())));
  std::vector<double> storage(4 * stride);
  const std::array<double*, 4> out{ storage.data(), storage.data() + stride,
    storage.data() + 2 * stride, storage.data() + 3 * stride };
  Code.Evaluate(mesh_, Element, { lanes.View() }, out);
  for (std::size_t i = 0; i < xi.size(); ++i)
  {
    values[i] = out[0][i];
    gradients[i] = { out[1][i], out[2][i], out[3][i] };
  }
}
} // namespace pixelexact
