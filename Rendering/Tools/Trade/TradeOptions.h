// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trade/Recommendation.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
} // namespace CLI

namespace pixelexact
{
/// Options of a comparison: settings, number of repeats, and target.
class TradeOptions
{
public:
  void AddTo(CLI::App& command);

  /// Resolutions for vtkHighOrderLinearCut, ascending. The default is lower for surfaces other than
  /// planes, for which a volume is sampled.
  [[nodiscard]] std::vector<int> Resolutions(bool ofPlane) const;
  /// Numbers of nodes along the longest side.
  [[nodiscard]] const std::vector<int>& Grids() const { return grids_; }
  [[nodiscard]] const std::vector<int>& Levels() const { return levels_; }
  /// Orders to which fields are truncated, ascending. By default some orders below the field's.
  [[nodiscard]] std::vector<int> Orders(int ofField) const;
  [[nodiscard]] int Repeat() const { return repeat_; }
  [[nodiscard]] int Bins() const { return bins_; }
  /// Share of the shown pixels, 0 to 1.
  [[nodiscard]] double Share() const { return Percent / 100.0; }
  [[nodiscard]] bool OfNext() const { return Next; }
  [[nodiscard]] const std::string& Output() const { return output_; }
  /// None: no target is given.
  [[nodiscard]] std::optional<TradeTarget> Target() const;

private:
  std::optional<std::vector<int>> resolutions_;
  std::vector<int> grids_{ 16, 32, 64, 128 };
  std::optional<std::vector<int>> orders_;
  std::vector<int> levels_{ 0, 1, 2, 3 };
  int repeat_ = 0;
  int bins_ = 0;
  double Percent = 0.0;
  bool Next = false;
  std::optional<double> TargetError;
  std::optional<double> TargetTime;
  std::string output_;
};
} // namespace pixelexact
