// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Expression/Graph.h"

#include <vtkSmartPointer.h>

#include <cstddef>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDoubleArray;
class vtkPointSet;

namespace pixelexact
{
class FieldExpression;

/// An expression as VTK's Gradient filter and Calculator compute it: at each point of a grid, from
/// the fields' point data and their derivatives by vtkGradientFilter, which averages those of the
/// cells around a point. Second derivatives are those of the filter's first ones. In place of
/// vtkArrayCalculator, which has neither matrices nor eigenvalues, the expression's program
/// computes the rest.
class NodalExpression
{
public:
  /// `expression` must outlive it.
  explicit NodalExpression(const FieldExpression& expression);

  /// Whether it contains derivatives of fields or of xi.
  [[nodiscard]] bool HasDerivatives() const;
  /// Throws Unsupported for what is not defined at points of a grid, as it depends on the element
  /// or on the cut-surface: xi, detJ, scaledJacobian, element, order, n.
  void RequireNodal() const;
  /// Names of the fields that it contains, each once: the point data that Compute takes.
  [[nodiscard]] std::vector<std::string> FieldNames() const;

  /// A tuple of the components for each point. Parallel, but for VTK's part. Throws as
  /// RequireNodal, and Error where an array is missing or memory is short.
  [[nodiscard]] vtkSmartPointer<vtkDoubleArray> Compute(vtkPointSet* grid) const;

private:
  /// A component of an array; null: the number pi.
  struct Column
  {
    vtkDataArray* array = nullptr;
    int component = 0;
    bool operator==(const Column&) const = default;
  };
  /// Columns of a grid and their derivatives.
  struct Differentiated
  {
    std::vector<Column> columns{}; ///< of the grid
    vtkSmartPointer<vtkDataArray> first{};
    vtkSmartPointer<vtkDataArray> second{};
  };

  [[nodiscard]] Column ValueOf(vtkPointSet* grid, const Graph::Node& leaf) const;
  [[nodiscard]] Differentiated Differentiate(vtkPointSet* grid) const;
  [[nodiscard]] Column ColumnOf(
    vtkPointSet* grid, const Differentiated& derivatives, const Graph::Node& leaf) const;

  const FieldExpression& Expression;
};
} // namespace pixelexact
