// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/Questions.h"

#include "Core/Base/Error.h"
#include "Core/Bernstein/RootFinder.h"
#include "Core/Math/Rounding.h"
#include "Core/Questions/CrossingList.h"
#include "Core/Questions/NodePart.h"
#include "Core/Questions/SegmentFrame.h"
#include "Core/Tree/NodePolynomials.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace pixelexact
{
namespace
{
/// A node is not split more often than this below the pieces that the tree begins with.
constexpr int kDeepest = 12;
/// Boxes in which the referee is to settle a node that could still be split.
constexpr int kTry = 32;
/// The referee is asked where the frame's deviation is at most this part of the node.
constexpr double kAffine = 0.5;

constexpr ShapeFace kFaces[] = { { 2, false }, { 0, false }, { 0, true }, { 1, false }, { 1, true },
  { 2, true } };
/// A tetrahedron's eta2 = 1 is collapsed.
constexpr ShapeFace kTetrahedronFaces[] = { { 2, false }, { 0, false }, { 0, true }, { 1, false } };
} // namespace

std::span<const ShapeFace> FacesOf(Shape shape)
{
  switch (shape)
  {
    case Shape::Hexahedron:
      return kFaces;
    case Shape::Tetrahedron:
      return kTetrahedronFaces;
    default:
      return std::span(kFaces).first(5);
  }
}

struct ElementQuestions::Internals
{
  Internals(const ElementIndex& index, int itsElement, NodePolynomials itsPolynomials)
    : element(itsElement)
    , tree(index.TreeOf(itsElement))
    , polynomials(std::move(itsPolynomials))
  {
  }
  int element;
  std::shared_ptr<ElementTree> tree;
  NodePolynomials polynomials;
};

/// One question.
class ElementQuestions::Search
{
public:
  Search(Internals& data, const Segment& segment, const QuestionEffort& effort)
    : Data(data)
    , TheShape(data.tree->Problem().space.shape)
    , Effort(effort)
    , Line(data.tree->Problem(), segment)
  {
    Data.polynomials.Trim();
  }

  Crossings RunFace(const ShapeFace& face)
  {
    Face = &face;
    return Run();
  }

  Crossings RunValue(double value)
  {
    Sought = Scaled(Interval(value), -Data.polynomials.FieldExponent());
    return Run();
  }

private:
  Crossings Run()
  {
    for (const auto& piece : Data.tree->Pieces())
    {
      Visit(*piece, 0);
    }
    Crossings result = List.Take();
    result.nodes = Nodes;
    result.boxes = Boxes;
    return result;
  }

  void Visit(ElementTree::Node& node, int depth)
  {
    const NodePart part(node, Face);
    if (part.IsEmpty())
    {
      return;
    }
    const Interval t = Line.Clip(TheShape, node.Frame());
    if (t.IsEmpty())
    {
      return;
    }
    if (Nodes >= Effort.nodes || Boxes >= Effort.boxes)
    {
      List.AddUndecided(t, part.Box());
      return;
    }
    ++Nodes;
    const bool askable =
      Data.polynomials.CanMakeMap(node) && (Face || Data.polynomials.CanMakeField(node));
    if (!Face && askable && MissesValue(node))
    {
      return;
    }
    const bool last = depth == kDeepest || !IsSound();
    if (askable && (last || node.Frame().IsNearlyAffine(kAffine)) && Ask(node, part, t, last))
    {
      return;
    }
    if (last || !Data.tree->Split(node))
    {
      List.AddUndecided(t, part.Box());
      return;
    }
    Visit(node.Child(0), depth + 1);
    Visit(node.Child(1), depth + 1);
  }

  /// Whether there are equations to solve.
  [[nodiscard]] bool IsSound() const { return Line.HasDirection() && Sought.IsFinite(); }

  [[nodiscard]] bool MissesValue(const ElementTree::Node& node)
  {
    return Intersect(Data.polynomials.FieldOver(node).Hull(), Sought).IsEmpty();
  }

  /// The referee. False where it cannot tell, and a smaller node may.
  bool Ask(const ElementTree::Node& node, const NodePart& part, const Interval& t, bool last)
  {
    if (!IsSound())
    {
      return false;
    }
    const auto map = Data.polynomials.MapOver(node);
    std::array<BoxPolynomial, 3> y;
    for (std::size_t c = 0; c < 3; ++c)
    {
      y[c] = part.Over(map[c]);
    }
    const auto line = Line.Eliminate(y);
    std::vector<TensorPolynomial> equations(line.begin(), line.end());
    if (!Face)
    {
      equations.push_back(LessSought(Data.polynomials.FieldOver(node)));
    }
    const auto left = static_cast<int>(Effort.boxes - Boxes);
    RootSearch options;
    options.budget = last ? left : std::min(kTry, left);
    const PolynomialSystem system(part.Variables(), equations);
    const RootSearchResult result = FindRoots(system, options);
    Boxes += result.boxes;
    if (result.budgetSpent && !last)
    {
      return false;
    }
    const BoxPolynomial& along = y[static_cast<std::size_t>(Line.Axis())];
    for (const IsolatedRoot& root : result.roots)
    {
      AddRoot(part, root, Line.ParameterOf(ValueOver(along, root.enclosure)));
    }
    for (const ParameterBox& box : result.undecided)
    {
      const Interval where = Intersect(t, Line.ParameterOf(HullOver(along, box)));
      if (!where.IsEmpty())
      {
        List.AddUndecided(where, part.Outer(box));
      }
    }
    return true;
  }

  [[nodiscard]] TensorPolynomial LessSought(const BoxPolynomial& field) const
  {
    const double middle = Sought.Middle();
    TensorPolynomial result{ field.degree, field.b, 0.0 };
    double largest = 0.0;
    for (double& b : result.coefficients)
    {
      b -= middle;
      largest = std::max(largest, std::fabs(b));
    }
    result.error =
      (field.error + Sought.RadiusAround(middle) + Gamma(1) * largest) * (1.0 + Gamma(8)) +
      0x1p-1000;
    return result;
  }

  void AddRoot(const NodePart& part, const IsolatedRoot& root, const Interval& t)
  {
    const Interval all{ 0.0, 1.0 };
    if (Intersect(t, all).IsEmpty())
    {
      return;
    }
    Crossing crossing;
    crossing.element = Data.element;
    crossing.t = t;
    crossing.middle = std::clamp(t.Middle(), 0.0, 1.0);
    crossing.eta = part.Outer(root.enclosure);
    Vec3 eta;
    for (int d = 0; d < 3; ++d)
    {
      eta[d] = std::clamp(crossing.eta[static_cast<std::size_t>(d)].Middle(), -1.0, 1.0);
    }
    crossing.xi = TensorToReference(TheShape, eta);
    crossing.status = !part.IsInside(crossing.eta) ? CrossingStatus::OnBoundary
      : all.Contains(t)                            ? CrossingStatus::Certain
                                                   : CrossingStatus::AtEnd;
    List.Add(crossing, part.Inner(root.alone));
  }

  Internals& Data;
  Shape TheShape;
  const QuestionEffort& Effort;
  SegmentFrame Line;
  const ShapeFace* Face = nullptr;
  Interval Sought; ///< in the field's units
  CrossingList List;
  std::int64_t Nodes = 0;
  std::int64_t Boxes = 0;
};

ElementQuestions::ElementQuestions(const ElementIndex& index, int element)
  : Data(std::make_unique<Internals>(index, element, NodePolynomials(index.GetMesh(), element)))
{
}

ElementQuestions::ElementQuestions(
  const ElementIndex& index, int element, const Field& field, int component)
{
  if (field.mapping != Mapping::Identity)
  {
    throw Unsupported("Crossings of field '" + field.name +
      "', an H(curl), H(div) or density field, with a value cannot be certified.");
  }
  Data = std::make_unique<Internals>(
    index, element, NodePolynomials(index.GetMesh(), element, field.values, component));
}

ElementQuestions::~ElementQuestions() = default;

Crossings ElementQuestions::WithFace(
  const Segment& segment, const ShapeFace& face, const QuestionEffort& effort)
{
  return Search(*Data, segment, effort).RunFace(face);
}

Crossings ElementQuestions::WithValue(
  const Segment& segment, double value, const QuestionEffort& effort)
{
  if (!Data->polynomials.HasField())
  {
    throw InvalidData("A value was asked for, and no field was given.");
  }
  return Search(*Data, segment, effort).RunValue(value);
}
} // namespace pixelexact
