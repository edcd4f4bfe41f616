// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/FieldFunction.h"
#include "Core/Element/Mesh.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace pixelexact
{
/// What the names in an expression mean.
struct ExpressionScope
{
  std::span<const Field> fields;
  /// Names that stand for expressions: their text.
  std::map<std::string, std::string> definitions{};
  std::map<std::string, double> parameters{};
  std::optional<double> time{};
  /// Of elements, for `element`; none: they count from 0.
  std::span<const std::int64_t> numbers{};
};

/// The function that an expression of fields is (Documentation/expressions.md has the language):
/// at each point it is computed from the fields' values and derivatives there, by the chain rule;
/// nothing is sampled. Errors are those of the kernels and some roundings of each operation.
///
/// `scope`'s fields and numbers must outlive it. Throws InvalidData for what is no expression, for
/// names that mean nothing and for shapes that do not fit, with the place in the text; Unsupported
/// for derivatives that are not available: third ones of fields, second ones of mapped fields
/// (H(curl), H(div), densities), and those of det J.
[[nodiscard]] std::shared_ptr<const FieldFunction> MakeExpression(
  const std::string& text, const ExpressionScope& scope);

/// Whether a text is more than a name: messages about names that do not exist are other ones.
[[nodiscard]] bool IsMoreThanName(const std::string& text);
} // namespace pixelexact
