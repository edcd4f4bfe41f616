// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/FontOptions.h"
#include "Input/Input.h"
#include "Picture/Figure.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
} // namespace CLI

namespace pixelexact
{
/// Options of the comparison with other solutions, and of its output.
class DifferenceOptions
{
public:
  void AddTo(CLI::App& command);

  /// Whether solutions are compared instead of ways to make a picture.
  [[nodiscard]] bool IsAsked() const { return !Groups.empty(); }
  /// Throws UsageError for options of the other kind of comparison. `size`: of the figure.
  void Check(const CLI::App& command, const ImageSize& size) const;

  /// The input of each other solution. Where a group contains fields only, its mesh is that of
  /// `first`.
  [[nodiscard]] std::vector<InputRequest> Requests(const InputRequest& first) const;
  /// The field of the other solutions; empty: the field with the name of the first solution's, or
  /// else the only one.
  [[nodiscard]] const std::string& FieldName() const { return field_; }
  [[nodiscard]] const std::string& BufferFile() const { return buffers_; }
  [[nodiscard]] const FigureOptions& Figure() const { return figure_; }
  [[nodiscard]] const FontOptions& Font() const { return font_; }
  /// Requests a figure without the option --figure.
  void AskForFigure() { figure_.Ask(); }

private:
  std::vector<std::vector<std::string>> Groups;
  std::string field_;
  std::optional<int> Step;
  std::optional<double> Time;
  std::string buffers_;
  FigureOptions figure_;
  FontOptions font_;
};
} // namespace pixelexact
