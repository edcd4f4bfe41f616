// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Frames/FrameSource.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <tuple>

class vtkScalarsToColors;

namespace pixelexact
{
/// The ranges of values that layers with a table in common have together.
class ColorRanges
{
public:
  using Range = std::optional<std::array<double, 2>>;

  /// Over all of the model, of the layers' fields; none where no layer has the table, or none of
  /// them has finite values. Keeps what it finds for as long as the model stays the same. Throws
  /// Error for fields or components that the model does not have.
  Range OfFields(const FrameRequest& request, vtkScalarsToColors* table);

  /// Gives a table its range; a logarithmic one none that is not above 0, which it refuses. Whether
  /// the range is another one than before.
  static bool Set(vtkScalarsToColors* table, const std::array<double, 2>& range);

  /// Of the finite values that a frame shows on these layers, sheets behind others included; none
  /// where there are none.
  static Range OfFrame(const Frame& frame, const FrameRequest& request, vtkScalarsToColors* table);

private:
  std::weak_ptr<HighOrderModel> Model;
  std::map<std::tuple<const Field*, int>, Range> Known;
};
} // namespace pixelexact
