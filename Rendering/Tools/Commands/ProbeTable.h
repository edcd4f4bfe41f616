// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Location/Owners.h"
#include "Core/Location/Sample.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace pixelexact
{
/// Columns of `probe` in addition to values.
struct ProbeColumns
{
  bool gradient = false;
  bool enclosures = false;
  bool owners = false;
};

/// The location of each point and the field's values there.
struct ProbeSamples
{
  /// `componentCount`: of the field; 0: there is no field.
  ProbeSamples(std::size_t points, int componentCount, const ProbeColumns& columns)
    : components(static_cast<std::size_t>(componentCount))
    , element(points)
    , xi(points)
    , verdict(points)
    , value(points * components)
    , gradient(columns.gradient ? 3 * value.size() : 0)
    , lower(columns.enclosures ? value.size() : 0)
    , upper(lower.size())
    , owners(columns.owners ? points : 0)
  {
  }
  [[nodiscard]] SampleTarget Target()
  {
    return { element, xi, verdict, {}, value, gradient, lower, upper };
  }

  std::size_t components;
  std::vector<std::int32_t> element;
  std::vector<Vec3> xi;
  std::vector<Verdict> verdict;
  std::vector<double> value;
  std::vector<double> gradient;
  std::vector<double> lower;
  std::vector<double> upper;
  std::vector<Owners> owners;
};

/// The points of a `probe`.
struct ProbePoints
{
  std::vector<Vec3> x;
  std::vector<double> distance; ///< from the first one, along a line; empty: not on a line
};
/// `count` points, evenly spaced, the first and the last at the line's ends.
ProbePoints PointsOnLine(const Vec3& from, const Vec3& to, int count);

/// The results of a field.
struct ProbedField
{
  std::string name; ///< of its columns: "value" where there is but one
  ProbeSamples samples;
};

/// The results of a time step of an input.
struct ProbedStep
{
  std::string input; ///< its name; empty: there is one input
  int step = 0;
  double time = 0.0;
  std::vector<ProbedField> fields; ///< at least one entry
  std::vector<std::int64_t> sourceCells;
};

/// Writes a row per point, step by step. Locations and coverage are those of the first field. There
/// must be at least one step, and all must have the same columns. Where there are several inputs,
/// the column `solution` is the first one. `withTime`: the columns `step` and `time` precede the
/// others. Throws Error naming the file.
void WriteProbeTable(const std::string& file, const ProbePoints& points,
  std::span<const ProbedStep> steps, bool withTime);

struct ProbeCounts
{
  std::size_t inside = 0;
  std::size_t outside = 0;
  std::size_t unknown = 0;
  std::size_t nonFinite = 0;
};
ProbeCounts CountProbes(const ProbeSamples& samples);

/// Widths of the enclosures of points inside, relative to the range of the values, component by
/// component; NaN where there are no values or no range.
struct EnclosureWidths
{
  double median = std::numeric_limits<double>::quiet_NaN();
  double largest = std::numeric_limits<double>::quiet_NaN(); ///< of the bounded ones
  std::size_t unbounded = 0; ///< infinite enclosures, which are not among the widths
};
EnclosureWidths MeasureEnclosures(const ProbeSamples& samples);

/// Numbers of points, indexed by Coverage.
using CoverageCounts = std::array<std::size_t, 4>;
CoverageCounts CountCoverage(const ProbeSamples& samples);
} // namespace pixelexact
