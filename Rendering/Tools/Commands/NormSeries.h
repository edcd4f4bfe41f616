// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Commands/NormFacts.h"
#include "Drawing/Plot.h"
#include "Trade/Convergence.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

// Norms of the same fields or errors of several solutions: info --norms with --with.
namespace pixelexact
{
class OtherInputs;
struct InputRequest;

/// A solution of a series and its norms.
struct NormedSolution
{
  std::string name;
  SolutionSize size;
  NormFacts facts;
};

/// The orders of L1, L2 and Linf of a field; none where they have no slope.
using NormOrders = std::array<std::optional<SeriesOrder>, 3>;

/// A series from coarse to fine.
struct NormSeries
{
  std::vector<NormedSolution> solutions;
  SeriesAxis axis = SeriesAxis::Modes;
  std::vector<NormOrders> orders; ///< by field
};

/// Adds the norms of the other inputs to those of the first one. `names`: of the fields or
/// expressions; the norms of others are those of their field of this name, or else their only one.
/// Parallel, with progress on stderr. Throws Error as FindNormFacts, and where an input has no
/// field whose order it could be sorted by.
NormSeries FindNormSeries(const LoadedModel& first, const NormFacts& facts,
  const InputRequest& request, const OtherInputs& with, const std::vector<std::string>& names);

void AddTo(Table& table, const NormSeries& series);
/// Adds the member "series" to the member "norms".
void AddTo(nlohmann::ordered_json& summary, const NormSeries& series);
/// The norms over the elements' length, or over the modes, on logarithmic axes.
Plot PlotOfNorms(const NormSeries& series);
} // namespace pixelexact
