// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/ElementQuantity.h"
#include "Core/Element/Mesh.h"
#include "Core/Expression/BoxLeaves.h"
#include "Core/Expression/CompiledGraph.h"
#include "Core/Expression/NodeList.h"
#include "Core/Expression/OuterFunctions.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace pixelexact
{
/// A node of a graph on one element.
class BoxExpression final : public ElementQuantity
{
public:
  /// `list` has one output, or several: their Euclidean norm is meant. What BoxLeaves refers to
  /// must outlive it.
  BoxExpression(std::shared_ptr<const NodeList> list, std::span<const Field* const> fields,
    std::span<const std::int64_t> numbers, const Mesh& mesh, int element);

  [[nodiscard]] bool IsFinite() const override { return Leaves.IsFinite(); }
  [[nodiscard]] int Level() const override { return Leaves.Level(); }
  [[nodiscard]] int Exponent() const override { return 0; }
  [[nodiscard]] std::vector<BoxPolynomial> Polynomials(
    const PieceForm::Piece& piece, const Box3& within) const override
  {
    return Leaves.Polynomials(Leaves.Level(), piece, within);
  }
  [[nodiscard]] Interval Enclose(std::span<const BoxPolynomial> polynomials) const override;
  [[nodiscard]] Interval AtCorner(
    std::span<const BoxPolynomial> polynomials, unsigned corner) const override;
  [[nodiscard]] int TellingDifference() const override { return 1; }

private:
  [[nodiscard]] BoxValue ValueWith(std::span<const BoxValue> polynomials) const;

  std::shared_ptr<const NodeList> List;
  BoxLeaves Leaves;
};

/// Several nodes of a graph on one element, for integrals.
class ExpressionModels final : public ElementModels
{
public:
  /// The fields, the numbers and the mesh must outlive it.
  ExpressionModels(std::shared_ptr<const NodeList> list, std::span<const Field* const> fields,
    std::span<const std::int64_t> numbers, const Mesh& mesh, int element);

  [[nodiscard]] bool IsFinite() const override { return Leaves.IsFinite(); }
  [[nodiscard]] int Level() const override { return Leaves.Level(); }
  [[nodiscard]] std::vector<BoxPolynomial> Polynomials(
    int level, const PieceForm::Piece& piece) const override
  {
    return Leaves.Polynomials(level, piece, { Vec3(-1.0), Vec3(1.0) });
  }
  [[nodiscard]] std::vector<ChebyshevModel> Over(
    std::span<const ChebyshevModel> polynomials) const override;
  [[nodiscard]] std::vector<Interval> Ranges(
    std::span<const BoxPolynomial> polynomials) const override;

private:
  std::shared_ptr<const NodeList> List;
  BoxLeaves Leaves;
};

/// A node with its gradient.
class BoxJet final : public ElementJet
{
public:
  /// The outputs of the list are the scalar, its derivatives by x, and, where they are available,
  /// those by xi, and second ones, 11, 12, 13, 22, 23, 33; those of the code the first four. What
  /// is referred to must outlive it. `outer`: the functions between the scalar and the values that
  /// a proof is about.
  BoxJet(std::shared_ptr<const NodeList> list, const CompiledGraph& code,
    const OuterFunctions& outer, std::span<const Field* const> fields,
    std::span<const std::int64_t> numbers, const Mesh& mesh, int element,
    const Vec3& coordinateErrors);

  [[nodiscard]] bool IsFinite() const override { return Leaves.IsFinite(); }
  [[nodiscard]] int Level() const override { return Leaves.Level(); }
  [[nodiscard]] std::vector<BoxPolynomial> Polynomials(
    int level, const PieceForm::Piece& piece) const override;
  [[nodiscard]] JetBounds Over(
    std::span<const AffineForm> forms, std::span<const Interval> hulls) const override;
  [[nodiscard]] Work WorkOf(int level) const override
  {
    const auto [terms, operations] = Leaves.WorkOf(level);
    return { terms, operations + static_cast<std::int64_t>(List->nodes.size()) };
  }
  [[nodiscard]] std::int64_t PointOperations() const override
  {
    return static_cast<std::int64_t>(List->nodes.size());
  }
  void Evaluate(
    std::span<const Vec3> xi, std::span<double> values, std::span<Vec3> gradients) const override;

private:
  [[nodiscard]] bool HasSeconds() const { return List->outputs.size() > 4; }

  std::shared_ptr<const NodeList> List;
  const CompiledGraph& Code;
  const OuterFunctions& Outer;
  BoxLeaves Leaves;
  Mesh mesh_;
  int Element;
};
} // namespace pixelexact
