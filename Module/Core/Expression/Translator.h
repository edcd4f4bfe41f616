// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Expression/Expression.h"
#include "Core/Expression/Tensor.h"
#include "Core/Expression/Term.h"

#include <map>
#include <string>
#include <vector>

namespace pixelexact
{
/// Translates an expression's text into nodes of a graph.
class Translator
{
public:
  Translator(Graph& graph, const ExpressionScope& scope);

  /// Throws as MakeExpression.
  Tensor Translate(const std::string& text);

private:
  Tensor Make(const Term& term);
  Tensor MakeName(const Term& term);
  Tensor MakeCall(const Term& term);
  Tensor MakeIndex(const Term& term);
  Tensor MakeDefinition(const std::string& name);
  Tensor MakeBuiltIn(const std::string& name);
  Tensor MakeField(std::size_t field);
  [[nodiscard]] std::size_t FindField(const std::string& name) const;
  [[nodiscard]] std::string KnownNames() const;
  template <class Function>
  auto AtTerm(const Term& term, const Function& function);

  Graph& Scalars;
  TensorAlgebra Algebra;
  const ExpressionScope& Scope;
  std::vector<std::string> Texts;     ///< that are being translated, the innermost last
  std::vector<std::string> Defined;   ///< names of those behind the first
  std::map<std::string, Tensor> Made; ///< of definitions
};
} // namespace pixelexact
