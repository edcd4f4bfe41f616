// SPDX-License-Identifier: BSD-3-Clause
#include "ElementMeasures.h"

#include "Core/Base/Error.h"
#include "Core/Element/Ranges.h"
#include "Core/Expression/Expression.h"
#include "Core/Integral/FieldNorms.h"
#include "HighOrderArrays.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkUnstructuredGrid.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <memory>
#include <string_view>

namespace pixelexact
{
namespace
{
constexpr const char* kAttribute = "attribute";
constexpr const char* kElementSize = "elementSize";
constexpr const char* kMinDetJ = "minDetJ";
constexpr const char* kMinScaledJacobian = "minScaledJacobian";
constexpr std::array<std::string_view, 4> kMeasures{ kAttribute, kElementSize, kMinDetJ,
  kMinScaledJacobian };

/// CellData of solvers' grids (SolverGrid.h).
constexpr const char* kAttributeArray = "Attribute";

bool IsLetter(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// The text without its quoted names, except those that are a measure's.
std::string WithoutQuotedNames(const std::string& text)
{
  std::string rest;
  for (std::size_t at = 0; at < text.size();)
  {
    const std::size_t end =
      text[at] == '"' || text[at] == '\'' ? text.find(text[at], at + 1) : std::string::npos;
    if (end == std::string::npos)
    {
      rest += text[at++];
      continue;
    }
    const std::string name = text.substr(at + 1, end - at - 1);
    rest += ' ';
    if (std::ranges::find(kMeasures, name) != kMeasures.end())
    {
      rest += name;
    }
    rest += ' ';
    at = end + 1;
  }
  return rest;
}

/// Whether a text contains a name that is no part of a longer one.
bool ContainsWord(const std::string& text, std::string_view name)
{
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1))
  {
    const std::size_t end = at + name.size();
    if ((at == 0 || !IsLetter(text[at - 1])) && (end == text.size() || !IsLetter(text[end])))
    {
      return true;
    }
  }
  return false;
}

/// A field with a value for each element. The values must outlive it; `storage` keeps the rest.
Field FieldOf(
  const std::string& name, const Mesh& mesh, std::span<const double> values, ViewStorage& storage)
{
  std::vector<Space>& spaces = storage.spaces.emplace_back();
  std::vector<std::int32_t>& spaceOf = storage.ints.emplace_back();
  std::vector<std::int64_t>& offset = storage.longs.emplace_back();
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    const Space space = UniformSpace(mesh.ShapeOf(e), 0);
    const auto at = std::ranges::find(spaces, space);
    spaceOf.push_back(static_cast<std::int32_t>(at - spaces.begin()));
    offset.push_back(e);
    if (at == spaces.end())
    {
      spaces.push_back(space);
    }
  }
  Field field{ .name = name, .values = { spaces, spaceOf, offset, values, 1 } };
  Validate(field, mesh);
  return field;
}
/// A proven lower bound of a scalar in an element, at least `floor`, which is one; NaN where none
/// is finite, or coefficients are not. The other end of the range is not searched.
double LowerBoundOf(const Mesh& mesh, const Field& field, int element, double floor)
{
  constexpr double kTolerance = 1e-2;
  constexpr int kMaxBoxes = 3000;
  constexpr int kBoxesBetweenChecks = 16;
  const ElementRange searched(mesh, element, { Quantity::Component, &field });
  if (!searched.IsFinite())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  CertifiedRange range;
  const std::unique_ptr<RangeSearch> search = searched.Begin();
  bool isSharp = false;
  while (!isSharp)
  {
    for (int k = 0; k < kBoxesBetweenChecks && !isSharp; ++k)
    {
      isSharp = !search->Refine(RangeSearch::End::Lower);
    }
    range = search->Current();
    const double width = range.attained.upper - range.attained.lower;
    isSharp = isSharp || range.GapBelow() <= kTolerance * width || range.boxes >= kMaxBoxes;
  }
  const double found = Scaled(range, searched.Exponent()).outer.lower;
  const double lower = found > floor ? found : floor;
  return std::isfinite(lower) ? lower : std::numeric_limits<double>::quiet_NaN();
}
} // namespace

void ElementMeasures::Read(vtkUnstructuredGrid* grid)
{
  vtkDataArray* const array = grid->GetCellData()->GetArray(kAttributeArray);
  HasAttributes =
    HasAttributes && array != nullptr && array->GetNumberOfValues() == grid->GetNumberOfCells();
  for (vtkIdType cell = 0; HasAttributes && cell < grid->GetNumberOfCells(); ++cell)
  {
    Attributes.push_back(array->GetComponent(cell, 0));
  }
  vtkDataArray* const slab = grid->GetFieldData()->GetArray(kSlab);
  Thickness = slab != nullptr && slab->GetNumberOfValues() == 2 ? slab->GetComponent(0, 1) : 0.0;
}

void ElementMeasures::Append(const ElementMeasures& other)
{
  HasAttributes = HasAttributes && other.HasAttributes;
  Attributes.insert(Attributes.end(), other.Attributes.begin(), other.Attributes.end());
  Thickness = other.Thickness;
}

std::set<std::string> ElementMeasures::NamedIn(
  const std::string& text, const std::map<std::string, std::string>& definitions)
{
  std::set<std::string> names;
  std::set<std::string> used;
  std::vector<const std::string*> texts{ &text };
  while (!texts.empty())
  {
    const std::string& next = *texts.back();
    texts.pop_back();
    const std::string words = WithoutQuotedNames(next);
    for (const std::string_view name : kMeasures)
    {
      if (ContainsWord(words, name))
      {
        names.emplace(name);
      }
    }
    for (const auto& [name, definition] : definitions)
    {
      if (ContainsWord(next, name) && used.insert(name).second)
      {
        texts.push_back(&definition);
      }
    }
  }
  return names;
}

std::span<const Field> ElementMeasures::With(
  std::span<const Field> fields, const std::set<std::string>& names)
{
  std::vector<Field>& list = Lists.emplace_back(fields.begin(), fields.end());
  for (const std::string& name : names)
  {
    list.push_back(Measure(name));
  }
  return list;
}

const Field& ElementMeasures::Measure(const std::string& name)
{
  const auto found = Measures.find(name);
  if (found != Measures.end())
  {
    return found->second;
  }
  // A thread that waits for the values must not begin other work, which may name a measure.
  std::vector<double>& values =
    Storage.doubles.emplace_back(tbb::this_task_arena::isolate([&] { return ValuesOf(name); }));
  return Measures.emplace(name, FieldOf(name, mesh_, values, Storage)).first->second;
}

std::vector<double> ElementMeasures::ValuesOf(const std::string& name)
{
  if (name == kAttribute)
  {
    if (!HasAttributes)
    {
      throw InvalidData("'attribute': the source gives elements no attributes; use element, their "
                        "number");
    }
    return Attributes;
  }
  if (mesh_.isShell)
  {
    throw Unsupported("'" + name +
      "' is a measure of solids, and the mesh is a surface in space; use attribute, element or "
      "order");
  }
  if (name == kElementSize)
  {
    return Sizes();
  }
  constexpr double kLowest = -1.0; // Hadamard's inequality
  return name == kMinDetJ ? LowerBounds("detJ", -std::numeric_limits<double>::infinity())
                          : LowerBounds("scaledJacobian", kLowest);
}

std::vector<double> ElementMeasures::Sizes() const
{
  ViewStorage storage;
  const std::vector<double> ones(static_cast<std::size_t>(mesh_.Elements()), 1.0);
  const FieldNorms norms =
    FindNorms(mesh_, FieldOf("1", mesh_, ones, storage), Thickness, NormEffort{});
  std::vector<double> sizes;
  sizes.reserve(norms.elements.size());
  for (const ElementNorms& element : norms.elements)
  {
    const double volume = element.volume.value;
    sizes.push_back(Thickness > 0.0 ? std::sqrt(volume) : std::cbrt(volume));
  }
  return sizes;
}

std::vector<double> ElementMeasures::LowerBounds(const std::string& expression, double floor) const
{
  Field field;
  field.name = expression;
  field.function = MakeExpression(expression, ExpressionScope{});
  std::vector<double> bounds(static_cast<std::size_t>(mesh_.Elements()));
  tbb::parallel_for(0, mesh_.Elements(),
    [&](int e) { bounds[static_cast<std::size_t>(e)] = LowerBoundOf(mesh_, field, e, floor); });
  return bounds;
}
} // namespace pixelexact
