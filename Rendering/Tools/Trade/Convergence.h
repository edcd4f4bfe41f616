// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trade/SolutionPair.h"

#include "Trace/Compare/FieldDifference.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// How solutions converge to one that is taken as the truth.
namespace pixelexact
{
/// One of a series, and how far it is from the reference.
struct SeriesRow
{
  std::string name;
  SolutionSize size;
  DifferenceNumbers numbers;
};

/// What errors are drawn and slopes are taken over.
enum class SeriesAxis
{
  Length, ///< of elements: where all orders are alike
  Modes   ///< their number: where orders differ
};

/// The order of convergence of one error. Over a length h it is the slope of log error over log h;
/// over N modes in d dimensions that over log N^(-1/d), so that both are p + 1 for smooth fields on
/// meshes that are refined.
struct SeriesOrder
{
  double overall = 0.0; ///< by least squares
  double last = 0.0;    ///< between the two finest
  int solutions = 0;    ///< that it is made of
};

/// A series from coarse to fine.
class Convergence
{
public:
  /// At least one row.
  explicit Convergence(std::vector<SeriesRow> rows);

  [[nodiscard]] const std::vector<SeriesRow>& Rows() const { return rows_; }
  [[nodiscard]] SeriesAxis Axis() const { return axis_; }

  /// Of solutions whose error is above the proven bound, two at least; else none. The error is one
  /// of DifferenceNumbers::rootMeanSquare, mean, largest.
  [[nodiscard]] std::optional<SeriesOrder> OrderOf(double DifferenceNumbers::*error) const;
  /// Of the root mean square between a row and the one before; none for the first, and below the
  /// bound.
  [[nodiscard]] std::optional<double> StepOrder(std::size_t row) const;

  /// A line of names, and one for each solution; empty where something is not known.
  [[nodiscard]] std::string ToCsv() const;
  [[nodiscard]] nlohmann::ordered_json ToJson() const;
  /// RGB, lower left first.
  [[nodiscard]] std::vector<std::uint8_t> Draw(
    const std::string& reference, int width, int height) const;

private:
  /// h, or N^(-1/d).
  [[nodiscard]] double Step(const SeriesRow& row) const;

  std::vector<SeriesRow> rows_;
  SeriesAxis axis_ = SeriesAxis::Modes;
};
} // namespace pixelexact
