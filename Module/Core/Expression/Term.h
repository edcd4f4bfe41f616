// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pixelexact
{
/// A part of an expression's text.
struct Term
{
  enum class Kind : std::uint8_t
  {
    Number,     ///< `text`
    Name,       ///< `text`
    QuotedName, ///< `text`, without quotes
    Call,       ///< of the function `text`; children: arguments
    Component,  ///< .x, .y, .z: `text`, of the child
    Index,      ///< [i] or [i, j] of the first child; the others are the numbers
    Unary,      ///< `text` is - or !
    Binary      ///< `text` is the operator
  };
  Kind kind = Kind::Number;
  std::string text;
  std::size_t at = 0; ///< where it begins; of binary ones, the operator
  std::vector<Term> children{};
};

/// Reads an expression. Throws InvalidData, with the place (AtPlace), for text that is no
/// expression, for more than 4096 characters and more than 64 brackets or powers within each other.
///
/// Operators from the weakest to the strongest: || && comparisons + - * / unary-minus-and-! ^ (or
/// **, from the right), then [i], [i,j], .x, .y, .z. Names are letters, digits and _; others stand
/// in double or single quotes.
[[nodiscard]] Term ParseExpression(const std::string& text);

/// The message, and below it the text with a caret below the character at `at`.
[[nodiscard]] std::string AtPlace(
  const std::string& message, const std::string& text, std::size_t at);
} // namespace pixelexact
