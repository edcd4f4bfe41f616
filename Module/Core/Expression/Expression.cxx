// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/Expression.h"

#include "Core/Base/Error.h"
#include "Core/Expression/IntervalProgram.h"
#include "Core/Expression/PointLeaves.h"
#include "Core/Expression/Program.h"
#include "Core/Expression/Translator.h"

#include <tbb/collaborative_call_once.h>

#include <algorithm>
#include <array>
#include <utility>

namespace pixelexact
{
namespace
{
/// A program and the leaves that it needs.
class Compiled
{
public:
  Compiled(const Graph& graph, std::vector<int> outputs, std::span<const Field* const> fields,
    std::span<const std::int64_t> numbers)
    : Code(graph, std::move(outputs))
    , Leaves(Code.Leaves(), fields, numbers)
  {
    for (const Graph::Node& leaf : Code.Leaves())
    {
      if (leaf.operation == Operation::Curvature &&
        fields[static_cast<std::size_t>(leaf.field)]->mapping != Mapping::Identity)
      {
        throw Unsupported("second derivatives of '" +
          fields[static_cast<std::size_t>(leaf.field)]->name +
          "' are not available: it is a field of H(curl), H(div) or a density");
      }
    }
  }

  /// `out`: of each output.
  void Evaluate(
    const Mesh& mesh, int element, const FunctionPoints& points, std::span<double* const> out) const
  {
    thread_local PointLeaves::Scratch leaves;
    thread_local std::vector<double> registers;
    std::vector<double*> some(out.size());
    std::array<const double*, 3> x{};
    std::array<const double*, 3> normal{};
    for (int begin = 0; begin < points.xi.count; begin += PointLeaves::kTogether)
    {
      const auto from = [begin](const double* const* arrays, std::array<const double*, 3>& part)
      {
        for (std::size_t d = 0; arrays != nullptr && d < 3; ++d)
        {
          part[d] = arrays[d] + begin;
        }
        return arrays != nullptr ? part.data() : nullptr;
      };
      const double* const* xi = points.xi.x;
      const FunctionPoints part{ { { xi[0] + begin, xi[1] + begin, xi[2] + begin },
                                   std::min(PointLeaves::kTogether, points.xi.count - begin) },
        from(points.x, x), from(points.normal, normal) };
      std::ranges::transform(out, some.begin(), [begin](double* array) { return array + begin; });
      Code.Run(Leaves.Evaluate(mesh, element, part, leaves), part.xi.count, some.data(), registers);
    }
  }

  [[nodiscard]] bool NeedsNormals() const { return Leaves.NeedsNormals(); }
  [[nodiscard]] const Program& GetProgram() const { return Code; }

private:
  Program Code;
  PointLeaves Leaves;
};

class ExpressionFunction final : public FieldExpression
{
public:
  ExpressionFunction(const std::string& text, const ExpressionScope& scope)
    : Text(text)
    , Numbers(scope.numbers)
  {
    std::ranges::transform(
      scope.fields, std::back_inserter(Fields), [](const Field& field) { return &field; });
    Outputs = Translator(Scalars, scope).Translate(text).nodes;
    Values.emplace(Scalars, Outputs, Fields, Numbers);
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
      WithGradient.emplace(Scalars, std::move(outputs), Fields, Numbers);
    }
    catch (const Error& error)
    {
      Missing = error.what();
    }
  }

  std::string Text;
  std::vector<const Field*> Fields;
  std::span<const std::int64_t> Numbers;
  std::vector<int> Outputs;
  std::optional<Compiled> Values;
  std::optional<IntervalProgram> Bounds;
  // Made when somebody first asks.
  mutable tbb::collaborative_once_flag Differentiated;
  mutable Graph Scalars;
  mutable std::optional<Compiled> WithGradient;
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
