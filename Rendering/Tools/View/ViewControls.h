// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "View/ShownCommand.h"
#include "View/ViewPanel.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
/// The panel's fields and sliders, as changes of the command line that a window shows.
class ViewControls
{
public:
  /// Lists the fields of the input and that of the command line, and makes the sliders of what the
  /// command line has: time steps, an iso-surface, --warp.
  explicit ViewControls(const ShownCommand& command);

  [[nodiscard]] ViewPanel& Panel() { return Panel_; }
  [[nodiscard]] const ViewPanel& Panel() const { return Panel_; }
  /// Shows the fields and values of a command line. While it has contours, their number has a
  /// slider.
  void Show(const ShownCommand& command);

  /// Chooses the field of a row of the list, without the range of colours of the field before.
  void ChooseField(std::size_t row, ShownState& state) const;
  /// The row that is so many rows after the shown one; none: there are no fields.
  [[nodiscard]] std::optional<std::size_t> RowAfter(int rows) const;
  /// Sets the option of a slider to its value. `shot`: the one that is shown.
  void Apply(std::size_t slider, const Shot& shot, ShownState& state) const;

private:
  /// A row of the list.
  struct Choice
  {
    std::string field;
    std::optional<int> component; ///< none: the value of a scalar, the magnitude of a vector
  };

  void Add(const Field& field);
  void AddSliders(const ShownCommand& command);

  std::vector<Choice> Choices;
  ViewPanel Panel_;
};
} // namespace pixelexact
