// SPDX-License-Identifier: BSD-3-Clause
#ifndef ElementMeasures_h
#define ElementMeasures_h

#include "CellElements.h"
#include "Core/Element/Mesh.h"

#include <cstdint>
#include <deque>
#include <list>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

class vtkUnstructuredGrid;

namespace pixelexact
{
/// Numbers of elements as fields of order 0, which are computed when an expression first names
/// them:
///
/// - attribute: the source's number for the element's group.
/// - elementSize: the third root of the volume, of a plane mesh the root of the area; numeric.
/// - minDetJ: a proven lower bound of det J in the element, NaN where none was found.
/// - minScaledJacobian: a proven lower bound of det J over the product of the lengths of J's
///   columns, -1 where none above it was found.
///
/// Both bounds aim at a hundredth of the range. The mesh must outlive the object.
class ElementMeasures
{
public:
  explicit ElementMeasures(const Mesh& mesh)
    : mesh_(mesh)
  {
  }

  /// Takes the attributes and the slab's thickness from a grid whose cells are the next elements.
  void Read(vtkUnstructuredGrid* grid);
  /// Takes those of the next elements from another object.
  void Append(const ElementMeasures& other);

  /// The names among those above that a text contains as words, itself or by definitions, which
  /// are texts by name.
  [[nodiscard]] static std::set<std::string> NamedIn(
    const std::string& text, const std::map<std::string, std::string>& definitions);

  /// Returns `fields` and after them the measures. The result, and what its fields view, live as
  /// long as this object. Throws InvalidData where the source has no attributes, Unsupported on a
  /// surface in space.
  [[nodiscard]] std::span<const Field> With(
    std::span<const Field> fields, const std::set<std::string>& names);

private:
  [[nodiscard]] const Field& Measure(const std::string& name);
  [[nodiscard]] std::vector<double> ValuesOf(const std::string& name);
  [[nodiscard]] std::vector<double> Sizes() const;
  [[nodiscard]] std::vector<double> LowerBounds(const std::string& expression, double floor) const;

  const Mesh& mesh_;
  std::vector<double> Attributes; ///< by element
  bool HasAttributes = true;
  double Thickness = 0.0; ///< of the slab; 0: the mesh is not plane
  ViewStorage Storage;
  std::map<std::string, Field> Measures;
  std::list<std::vector<Field>> Lists; ///< results of With
};
} // namespace pixelexact
#endif
