// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

class vtkDataObject;
class vtkMultiProcessController;
class vtkScalarsToColors;

namespace pixelexact
{
class HighOrderModel;

/// Compares the range that a colour map has to span with the range that ParaView sets.
class ShownRange
{
public:
  using Range = std::array<double, 2>;

  /// The range over the mesh of the field component that a table shows; kept while data, field and
  /// component stay the same. None where there is no such field or component, or none of its values
  /// is finite.
  std::optional<Range> OfField(
    vtkDataObject* data, const std::string& field, vtkScalarsToColors* table);

  /// A warning where the table has the range of an array's values at the cells' points, as ParaView
  /// sets it, and this omits more of the field's range than one of 256 colours. Empty otherwise,
  /// and for tables with another range. `processes`: those whose parts are included, all of which
  /// must call it; `data` may be null then.
  std::string Complaint(vtkDataObject* data, const std::string& field, vtkScalarsToColors* table,
    vtkMultiProcessController* processes);

  /// The field's range over the parts of all processes at the last call of Complaint.
  [[nodiscard]] std::optional<Range> OfAll() const { return Whole; }

private:
  std::shared_ptr<HighOrderModel> Model;
  std::string Name;
  int Component = 0;
  std::optional<Range> Known;
  std::optional<Range> Whole;
};
} // namespace pixelexact
