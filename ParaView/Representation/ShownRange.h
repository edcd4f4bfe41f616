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

/// The values that a colour map has to span, against those that ParaView makes it span.
class ShownRange
{
public:
  using Range = std::array<double, 2>;

  /// Of the component of a field that a table shows, over the mesh; kept while data, field and
  /// component stay the same. None where there is no such field or component, or none of its values
  /// is finite.
  std::optional<Range> OfField(
    vtkDataObject* data, const std::string& field, vtkScalarsToColors* table);

  /// What to tell of a table whose range is that of an array's values at the cells' points, as
  /// ParaView sets it, and which leaves out more of the field's range than one of 256 colours
  /// shows; empty where there is nothing to tell, as of tables that somebody gave another range.
  /// `processes`: of the parts of all of these, each of which calls it; `data` may be null then.
  std::string Complaint(vtkDataObject* data, const std::string& field, vtkScalarsToColors* table,
    vtkMultiProcessController* processes);

  /// What Complaint found last of the field over the parts of all processes.
  [[nodiscard]] std::optional<Range> OfAll() const { return Whole; }

private:
  std::shared_ptr<HighOrderModel> Model;
  std::string Name;
  int Component = 0;
  std::optional<Range> Known;
  std::optional<Range> Whole;
};
} // namespace pixelexact
