// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trade/SolutionPair.h"

#include "Trace/Compare/FieldDifference.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

// Convergence of solutions to a reference solution.
namespace pixelexact
{
/// One solution of a series, and its distance from the reference.
struct SeriesRow
{
  std::string name;
  SolutionSize size;
  DifferenceNumbers numbers;
};

/// The axis over which errors are drawn and slopes computed.
enum class SeriesAxis
{
  Length, ///< of elements: if all have the same order
  Modes   ///< their number: if orders differ
};

/// Whether all solutions have the same order, one in all elements, or not.
SeriesAxis AxisOf(std::span<const SolutionSize> sizes);
/// The step that errors are compared over: h, or N^(-1/d).
double StepOf(const SolutionSize& size, SeriesAxis axis);
/// The place of a solution in plots: h, or N.
double PlaceOf(const SolutionSize& size, SeriesAxis axis);
/// The name of that axis.
const char* NameOf(SeriesAxis axis);

/// An error of a solution, which is known up to `bound`.
struct SeriesError
{
  double step = 0.0;
  double error = 0.0;
  double bound = 0.0;
};

/// The order of convergence of one error. Over a length h it is the slope of log error over log h;
/// over N modes in d dimensions that over log N^(-1/d), so that both are p + 1 for smooth fields on
/// meshes that are refined.
struct SeriesOrder
{
  double overall = 0.0; ///< by least squares
  double last = 0.0;    ///< between the two finest
  int solutions = 0;    ///< number of solutions used
};

/// The order of errors from coarse to fine, over those above their bound; none for fewer than two.
[[nodiscard]] std::optional<SeriesOrder> OrderOfErrors(std::span<const SeriesError> errors);

/// A series from coarse to fine.
class Convergence
{
public:
  /// `rows` has at least one row.
  explicit Convergence(std::vector<SeriesRow> rows);

  [[nodiscard]] const std::vector<SeriesRow>& Rows() const { return rows_; }
  [[nodiscard]] SeriesAxis Axis() const { return axis_; }

  /// The order of convergence of an error over the solutions whose error is above the proven bound;
  /// none for fewer than two. `error`: DifferenceNumbers::rootMeanSquare, mean or largest.
  [[nodiscard]] std::optional<SeriesOrder> OrderOf(double DifferenceNumbers::*error) const;
  /// The order of the root mean square between a row and the one before; none for the first row,
  /// and below the bound.
  [[nodiscard]] std::optional<double> StepOrder(std::size_t row) const;

  /// A line of names, and one for each solution; unknown fields are empty.
  [[nodiscard]] std::string ToCsv() const;
  [[nodiscard]] nlohmann::ordered_json ToJson() const;
  /// The plot as RGB, lower left first.
  [[nodiscard]] std::vector<std::uint8_t> Draw(
    const std::string& reference, int width, int height) const;

private:
  [[nodiscard]] SeriesError ErrorOf(const SeriesRow& row, double DifferenceNumbers::*error) const;

  std::vector<SeriesRow> rows_;
  SeriesAxis axis_ = SeriesAxis::Modes;
};
} // namespace pixelexact
