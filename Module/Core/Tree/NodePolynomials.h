// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/RangeIngredients.h"
#include "Core/Tree/ElementTree.h"

#include <array>
#include <memory>
#include <unordered_map>

namespace pixelexact
{
/// Phi (in the element's units) and a component of a field over nodes of an element's tree, in
/// Bernstein form. Each is made from the modes when a node is first asked for: the conversion to
/// the piece and its restriction cost about what halving the parent's would, and need no parent,
/// whose coefficients the tree drops when it splits.
class NodePolynomials
{
public:
  NodePolynomials(const Mesh& mesh, int element);
  NodePolynomials(const Mesh& mesh, int element, const Expansion& values, int component);

  /// Whether the coefficients are finite, and the node does not stretch over several of the pieces
  /// on which they are converted. Where it does, smaller nodes are to be asked.
  [[nodiscard]] bool CanMakeMap(const ElementTree::Node& node) const;
  [[nodiscard]] bool CanMakeField(const ElementTree::Node& node) const;
  /// Three polynomials; errors include the mesh's uncertainty.
  std::span<const BoxPolynomial, 3> MapOver(const ElementTree::Node& node);
  /// Scaled by 2^-FieldExponent().
  const BoxPolynomial& FieldOver(const ElementTree::Node& node);
  [[nodiscard]] int FieldExponent() const { return Field->exponent; }
  [[nodiscard]] bool HasField() const { return Field != nullptr; }

  /// Drops what is kept if it is much. Not to be called while references are in use.
  void Trim();

private:
  using Nodes = const ElementTree::Node*;

  ScaledModes Map;
  std::array<double, 3> Uncertainty;
  std::unique_ptr<const ScaledModes> Field;
  int Component = 0;
  int MapLevel;
  int FieldLevel = 0;
  std::unordered_map<Nodes, std::array<BoxPolynomial, 3>> Maps;
  std::unordered_map<Nodes, BoxPolynomial> Fields;
  std::size_t Held = 0; ///< coefficients
};
} // namespace pixelexact
