// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/ElementBasis.h"
#include "Formats/Gmsh/Basis.h"
#include "Formats/Gmsh/MeshFile.h"
#include "Formats/Gmsh/Scanner.h"
#include "Formats/SolverModel.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// The views of Gmsh files: values at nodes, on elements, or at elements' nodes, at steps.

namespace pixelexact::gmsh
{
enum class ViewKind : std::uint8_t
{
  Node,
  Element,
  ElementNode
};

/// The kind of a section by its name, such as "NodeData"; none where it holds no view.
std::optional<ViewKind> KindOf(const std::string& section);

/// The functions of a view's values, by dimension and shape (ElementType). Types that are missing
/// have the elements' own functions.
using Scheme = std::map<std::pair<int, Shape>, Interpolation>;

/// The head of one section.
struct ViewPart
{
  std::size_t file = 0;   ///< number of the scanner
  std::size_t values = 0; ///< where they begin
  std::size_t count = 0;
  int partition = -1;     ///< -1: all
  std::string schemeName; ///< empty: the elements' own functions
  std::shared_ptr<const Scheme> scheme;
  double time = 0.0;
  int components = 1;
};

struct View
{
  std::string name;
  ViewKind kind = ViewKind::Node;
  std::map<std::int64_t, std::vector<ViewPart>> steps; ///< by Gmsh's number of the step
};

/// All views of one or more files.
class ViewList
{
public:
  /// Reads the head of a section that holds a view. `unnamed` names views without a name. Files
  /// below `pieces` hold parts of one mesh, and of views.
  void AddHead(Scanner& scanner, std::size_t file, std::size_t pieces, ViewKind kind,
    const std::string& unnamed);
  /// $InterpolationScheme
  void AddScheme(Scanner& scanner);

  [[nodiscard]] const std::vector<View>& Views() const { return All; }

private:
  std::vector<View> All;
  /// By name; a view has the last scheme before it.
  std::map<std::string, std::shared_ptr<const Scheme>> Known;
};

/// Steps of all views, ascending, with times: the file's where they ascend with the steps, else the
/// steps' numbers. Files without a time have one step at time 0.
struct StepList
{
  std::vector<std::int64_t> numbers;
  std::vector<double> times;
  bool numbered = false; ///< the file's times do not ascend
};
StepList StepsOf(const std::vector<View>& views);

/// The values of a view at a step, by node or by element.
struct ViewValues
{
  int components = 1;
  std::vector<double> values;
  std::vector<std::int64_t> first; ///< per node or element, in values; -1: none
  std::vector<std::int32_t> count; ///< per element: tuples; empty: one each
  std::size_t strangers = 0;       ///< values of nodes or elements that are not among the mesh's
};
ViewValues ReadValues(std::vector<Scanner>& scanners, const View& view,
  const std::vector<ViewPart>& parts, const MeshFile& mesh);

/// Creates each basis once and keeps it at a fixed address.
class BasisTable
{
public:
  const ElementBasis& Nodal(const ElementType& type);
  /// The basis of a view's scheme; null where the scheme has none for the type's shape.
  const ElementBasis* Of(const Scheme& scheme, const ElementType& type);
  const ElementBasis& Constant(Shape shape);

private:
  std::map<int, ElementBasis> ByType;
  std::map<std::pair<const Scheme*, std::pair<int, Shape>>, ElementBasis> ByScheme;
  std::map<Shape, ElementBasis> Constants;
};

/// Adds a view's field at a step. A view of a single step is the same at all steps. A view that has
/// other steps but not this one is left out with a note.
void AddView(std::vector<Scanner>& scanners, const View& view, std::int64_t step,
  const MeshFile& mesh, BasisTable& bases, SolverModel& model);
} // namespace pixelexact::gmsh
