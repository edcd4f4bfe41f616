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
/// Other solutions that a comparison is with, and what is written of the differences.
class DifferenceOptions
{
public:
  void AddTo(CLI::App& command);

  /// Whether solutions are compared, and not ways to make a picture.
  [[nodiscard]] bool IsAsked() const { return !Groups.empty(); }
  /// Throws UsageError for options of the other kind of comparison. `pictureSize`: of the figure.
  void Check(const CLI::App& command, const ImageSize& size) const;

  /// What is to be read of each other solution. Where a group holds fields alone, the mesh is that
  /// of `first`.
  [[nodiscard]] std::vector<InputRequest> Requests(const InputRequest& first) const;
  /// Of the other solutions; empty: that of the first one where it is there, else the only one.
  [[nodiscard]] const std::string& FieldName() const { return field_; }
  [[nodiscard]] const std::string& BufferFile() const { return buffers_; }
  [[nodiscard]] const FigureOptions& Figure() const { return figure_; }
  [[nodiscard]] const FontOptions& Font() const { return font_; }
  /// Also without --figure.
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
