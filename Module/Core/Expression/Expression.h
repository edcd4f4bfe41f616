// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/FieldFunction.h"
#include "Core/Element/Mesh.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace pixelexact
{
class Locator;
class Program;

/// Maps the names in an expression to fields, definitions and numbers.
struct ExpressionScope
{
  std::span<const Field> fields;
  /// Names that stand for expressions: their text.
  std::map<std::string, std::string> definitions{};
  std::map<std::string, double> parameters{};
  std::optional<double> time{};
  /// The elements' numbers, for `element`; none: they count from 0.
  std::span<const std::int64_t> numbers{};
  /// Returns the locator of the fields' mesh, for `jump`, which alone calls it; empty: there are no
  /// jumps.
  std::function<const Locator&()> locator{};
};

/// The function of an expression, with the program that computes it: the same program takes the
/// values and derivatives that another method gives at a point.
class FieldExpression : public FieldFunction
{
public:
  /// The outputs are the components.
  [[nodiscard]] virtual const Program& GetProgram() const = 0;
  /// Graph::Node::field of the program's leaves is an index into these.
  [[nodiscard]] virtual std::span<const Field* const> GetFields() const = 0;
};

/// Returns the function that an expression of fields defines (Documentation/expressions.md
/// describes the language). At each point it is computed from the fields' values and derivatives
/// there, by the chain rule; nothing is sampled. Errors are the rounding of the kernels and of each
/// operation.
///
/// `scope`'s fields, numbers and locator must outlive it. Throws InvalidData for text that is no
/// expression, for unknown names and for shapes that do not fit, with the place in the text;
/// Unsupported for derivatives that are not available: third ones of fields, second ones of mapped
/// fields (H(curl), H(div), densities), and those of det J.
[[nodiscard]] std::shared_ptr<const FieldExpression> MakeExpression(
  const std::string& text, const ExpressionScope& scope);

/// Throws Unsupported where the range of a field over the elements of a surface in space would be
/// that of the solids beneath: for expressions of coordinates or normals.
void RequireSurfaceRange(const Mesh& mesh, const Field& field);

/// A number as an expression reads it back, in brackets: the shortest digits that round to it.
[[nodiscard]] std::string NumberText(double number);

/// Whether a text contains operators, brackets or quotes, and so is not meant as a plain name.
[[nodiscard]] bool IsMoreThanName(const std::string& text);
} // namespace pixelexact
