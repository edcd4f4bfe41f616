// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/Expression.h"

#include "Core/Base/Error.h"
#include "Core/Expression/CompiledGraph.h"
#include "Core/Expression/IntervalProgram.h"
#include "Core/Expression/Translator.h"

#include <tbb/collaborative_call_once.h>

#include <algorithm>
#include <utility>

namespace pixelexact
{
namespace
{
class ExpressionFunction final : public FieldExpression
{
public:
  ExpressionFunction(const std::string& text, const ExpressionScope& scope)
    : Text(text)
    , Numbers(scope.numbers)
    , Places(scope.locator)
  {
    std::ranges::transform(
      scope.fields, std::back_inserter(Fields), [](const Field& field) { return &field; });
    Outputs = Translator(Scalars, scope).Translate(text).nodes;
    Values.emplace(Scalars, Outputs, Fields, Numbers, Places);
    Bounds.emplace(Scalars, Outputs, Fields, Numbers);
  }

  [[nodiscard]] int Components() const override { return static_cast<int>(Outputs.size()); }

  void RequireGradient() const override
  {
    tbb::collaborative_call_once(Differentiated, [this] { Differentiate(); });
    if (!WithGradient)
    {
      throw Unsupported("'" + Text + "' has no gradient: " + Missing);
    }
  }

  [[nodiscard]] bool NeedsNormals() const override { return Values->NeedsNormals(); }
  [[nodiscard]] bool NeedsNeighbours() const override { return Values->NeedsNeighbours(); }

  [[nodiscard]] const Program& GetProgram() const override { return Values->GetProgram(); }
  [[nodiscard]] std::span<const Field* const> GetFields() const override { return Fields; }

  void Evaluate(const Mesh& mesh, int element, const FunctionPoints& points, double* const* value,
    double* const* gradient) const override
  {
    if (points.normal == nullptr && NeedsNormals())
    {
      throw Unsupported("'" + Text +
        "' needs the normal of a surface, which only pictures of surfaces have; leave out n");
    }
    if (gradient == nullptr)
    {
      Values->Evaluate(mesh, element, points, { value, Outputs.size() });
      return;
    }
    RequireGradient();
    std::vector<double*> out(value, value + Outputs.size());
    out.insert(out.end(), gradient, gradient + 3 * Outputs.size());
    WithGradient->Evaluate(mesh, element, points, out);
  }

  void Enclose(const Mesh& mesh, int element, const LanePoints& xi, const LanePoints& x,
    const BoundArrays& values) const override
  {
    Bounds->Enclose(mesh, element, xi, x, values);
  }

private:
  void Differentiate() const
  {
    try
    {
      std::vector<int> outputs = Outputs;
      for (const int node : Outputs)
      {
        for (int d = 0; d < 3; ++d)
        {
          outputs.push_back(Scalars.Derivative(node, d));
        }
      }
      WithGradient.emplace(Scalars, std::move(outputs), Fields, Numbers, Places);
    }
    catch (const Error& error)
    {
      Missing = error.what();
    }
  }

  std::string Text;
  std::vector<const Field*> Fields;
  std::span<const std::int64_t> Numbers;
  LocatorSource Places;
  std::vector<int> Outputs;
  std::optional<CompiledGraph> Values;
  std::optional<IntervalProgram> Bounds;
  // Made when somebody first asks.
  mutable tbb::collaborative_once_flag Differentiated;
  mutable Graph Scalars;
  mutable std::optional<CompiledGraph> WithGradient;
  mutable std::string Missing;
};
} // namespace

std::shared_ptr<const FieldExpression> MakeExpression(
  const std::string& text, const ExpressionScope& scope)
{
  return std::make_shared<const ExpressionFunction>(text, scope);
}

bool IsMoreThanName(const std::string& text)
{
  return std::ranges::any_of(text,
    [](char c)
    { return std::string_view("()[]+-*/^<>=!&|,'\"").find(c) != std::string_view::npos; });
}
} // namespace pixelexact
