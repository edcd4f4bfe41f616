// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/Expression.h"

#include "Core/Base/Error.h"
#include "Core/Expression/BoxExpression.h"
#include "Core/Expression/CompiledGraph.h"
#include "Core/Expression/IntervalProgram.h"
#include "Core/Expression/OuterFunctions.h"
#include "Core/Expression/Program.h"
#include "Core/Expression/Translator.h"

#include <tbb/collaborative_call_once.h>

#include <algorithm>
#include <array>
#include <charconv>
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
    for (const int node : Outputs)
    {
      OfComponent.push_back(std::make_shared<const NodeList>(Scalars, std::span(&node, 1)));
    }
    All = std::make_shared<const NodeList>(Scalars, Outputs);
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

  [[nodiscard]] std::unique_ptr<ElementQuantity> OnElement(
    const Mesh& mesh, int element, int component) const override
  {
    const auto& list = component == kNorm ? All : OfComponent[static_cast<std::size_t>(component)];
    return std::make_unique<BoxExpression>(list, Fields, Numbers, mesh, element);
  }

  [[nodiscard]] bool HasJets() const override
  {
    tbb::collaborative_call_once(Differentiated, [this] { Differentiate(); });
    return !Jets.empty() && !NeedsNormals() && !NeedsNeighbours();
  }

  [[nodiscard]] std::unique_ptr<ElementJet> JetOnElement(
    const Mesh& mesh, int element, int component, const Vec3& coordinateErrors) const override
  {
    if (!HasJets())
    {
      return nullptr;
    }
    const Jet& jet = JetOf(component);
    return std::make_unique<BoxJet>(
      jet.list, *jet.code, jet.outer, Fields, Numbers, mesh, element, coordinateErrors);
  }

  [[nodiscard]] bool HasModels(Shape shape) const override
  {
    const bool hasSeconds = std::ranges::any_of(
      All->leaves, [](const Graph::Node& leaf) { return leaf.operation == Operation::Curvature; });
    return !NeedsNormals() && !NeedsNeighbours() && (!hasSeconds || shape == Shape::Hexahedron);
  }

  [[nodiscard]] std::unique_ptr<ElementModels> ModelsOnElement(
    const Mesh& mesh, int element) const override
  {
    return HasModels(mesh.ShapeOf(element))
      ? std::make_unique<ExpressionModels>(All, Fields, Numbers, mesh, element)
      : nullptr;
  }

  [[nodiscard]] double JetValue(int component, double value) const override
  {
    return HasJets() ? JetOf(component).outer.Invert(value) : value;
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
      return;
    }
    try
    {
      for (const int node : Outputs)
      {
        AddJet(node);
      }
      AddJet(MakeNorm());
    }
    catch (const Error&)
    {
      Jets.clear();
    }
  }

  /// A component or the norm, as functions of a scalar, and the scalar with its derivatives by x.
  struct Jet
  {
    OuterFunctions outer;
    std::shared_ptr<const NodeList> list;
    std::unique_ptr<const CompiledGraph> code;
  };
  [[nodiscard]] const Jet& JetOf(int component) const
  {
    return component == kNorm ? Jets.back() : Jets[static_cast<std::size_t>(component)];
  }
  void AddJet(int node) const
  {
    OuterFunctions outer(Scalars, node);
    std::vector<int> outputs{ outer.Inner() };
    for (int d = 0; d < 3; ++d)
    {
      outputs.push_back(Scalars.Derivative(outer.Inner(), d));
    }
    auto code = std::make_unique<const CompiledGraph>(Scalars, outputs, Fields, Numbers, Places);
    std::vector<int> withSeconds = outputs;
    if (AddByXi(withSeconds) && IsBounded(withSeconds))
    {
      outputs = std::move(withSeconds);
    }
    if (!IsBounded(outputs))
    {
      throw Unsupported("derivatives of H(curl), H(div) and density fields are not bounded");
    }
    Jets.push_back(
      { std::move(outer), std::make_shared<const NodeList>(Scalars, outputs), std::move(code) });
  }
  /// Adds first and second derivatives by xi; false where there are none.
  bool AddByXi(std::vector<int>& outputs) const
  {
    try
    {
      std::array<int, 3> slopes{};
      for (int j = 0; j < 3; ++j)
      {
        slopes[static_cast<std::size_t>(j)] = Scalars.DerivativeByXi(outputs.front(), j);
      }
      std::ranges::copy(slopes, std::back_inserter(outputs));
      for (int j = 0; j < 3; ++j)
      {
        for (int k = j; k < 3; ++k)
        {
          outputs.push_back(Scalars.DerivativeByXi(slopes[static_cast<std::size_t>(j)], k));
        }
      }
    }
    catch (const Unsupported&)
    {
      return false;
    }
    return true;
  }
  /// Whether BoxLeaves supports all leaves of the nodes.
  [[nodiscard]] bool IsBounded(const std::vector<int>& nodes) const
  {
    const NodeList list(Scalars, nodes);
    return std::ranges::none_of(list.leaves,
      [this](const Graph::Node& leaf)
      {
        const bool isDerivative = leaf.operation == Operation::Slope ||
          leaf.operation == Operation::Curvature || leaf.operation == Operation::ValueByXi ||
          leaf.operation == Operation::SlopeByXi;
        return leaf.operation == Operation::Normal || leaf.operation == Operation::Behind ||
          (isDerivative &&
            Fields[static_cast<std::size_t>(leaf.field)]->mapping != Mapping::Identity);
      });
  }
  /// The Euclidean norm of all components.
  int MakeNorm() const
  {
    int sum = Scalars.Constant(0.0);
    for (const int node : Outputs)
    {
      sum = Scalars.Of(Operation::Add, sum, Scalars.Of(Operation::Multiply, node, node));
    }
    return Outputs.size() == 1 ? Outputs.front() : Scalars.Of(Operation::Sqrt, sum);
  }

  std::string Text;
  std::vector<const Field*> Fields;
  std::span<const std::int64_t> Numbers;
  LocatorSource Places;
  std::vector<int> Outputs;
  std::optional<CompiledGraph> Values;
  std::optional<IntervalProgram> Bounds;
  std::vector<std::shared_ptr<const NodeList>> OfComponent; ///< for OnElement
  std::shared_ptr<const NodeList> All;                      ///< for OnElement and ModelsOnElement
  // Computed on first use.
  mutable tbb::collaborative_once_flag Differentiated;
  mutable Graph Scalars;
  mutable std::optional<CompiledGraph> WithGradient;
  mutable std::vector<Jet> Jets; ///< of the components, then of their norm
  mutable std::string Missing;
};
} // namespace

std::shared_ptr<const FieldExpression> MakeExpression(
  const std::string& text, const ExpressionScope& scope)
{
  return std::make_shared<const ExpressionFunction>(text, scope);
}

void RequireSurfaceRange(const Mesh& mesh, const Field& field)
{
  const auto* const expression = dynamic_cast<const FieldExpression*>(field.function.get());
  if (!mesh.isShell || expression == nullptr)
  {
    return;
  }
  const auto isAcross = [](const Graph::Node& leaf)
  {
    return leaf.operation == Operation::Coordinate || leaf.operation == Operation::Reference ||
      leaf.operation == Operation::Normal;
  };
  if (std::ranges::any_of(expression->GetProgram().Leaves(), isAcross))
  {
    throw Unsupported("'" + field.name +
      "' uses coordinates, and the mesh is a surface in space: ranges and extremes are available "
      "for expressions of fields alone; integrate --extremes finds those of all others");
  }
}

std::string NumberText(double number)
{
  std::array<char, 32> text{};
  const auto length =
    std::to_chars(text.data(), text.data() + text.size(), number).ptr - text.data();
  return "(" + std::string(text.data(), static_cast<std::size_t>(length)) + ")";
}

bool IsMoreThanName(const std::string& text)
{
  return std::ranges::any_of(text,
    [](char c)
    { return std::string_view("()[]+-*/^<>=!&|,'\"").find(c) != std::string_view::npos; });
}
} // namespace pixelexact
