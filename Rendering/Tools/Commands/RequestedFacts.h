// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Commands/CertifiedFacts.h"
#include "Commands/ExtremeFacts.h"
#include "Commands/JumpFacts.h"
#include "Commands/NormSeries.h"
#include "Commands/ValuePlots.h"
#include "Commands/WarpFacts.h"
#include "Input/OtherInputs.h"

#include <optional>
#include <string>
#include <vector>

// Facts that `info` computes on request, because they take time.
namespace pixelexact
{
struct LoadedModel;

struct RequestedFacts
{
  std::optional<CertifiedFacts> certified;
  std::optional<ExtremeFacts> extremes;
  std::optional<JumpFacts> jumps;
  std::optional<NormFacts> norms;
  std::optional<NormSeries> series; ///< of several solutions
  std::optional<WarpFacts> warp;
};

/// Options that request facts.
class FactRequests
{
public:
  void AddTo(CLI::App& command);
  /// Throws UsageError for options without effect, and as CheckOutput.
  void Check(const InputRequest& input, bool json) const;
  /// Finds the facts and writes the files that are requested. Throws Error as each of them.
  [[nodiscard]] RequestedFacts Find(const LoadedModel& input, const InputRequest& request) const;

private:
  bool certify_ = false;
  std::vector<std::string> Certified; ///< fields and expressions; none: all fields
  std::vector<std::string> Extremes;  ///< fields and expressions
  std::vector<std::string> Jumps;     ///< fields and expressions
  std::vector<std::string> Norms;     ///< fields and expressions
  std::string NormTable;              ///< file; empty: none
  OtherInputs With;                   ///< solutions whose norms make a series with INPUT's
  PlotOptions PlotOfSeries;
  std::optional<WarpRequest> WarpLimit; ///< the displacement of which a limit is sought
};

void AddTo(Table& table, const LoadedModel& input, const RequestedFacts& facts);
/// Adds a member for each kind of facts, other than those of certified fields (ToJson).
void AddTo(nlohmann::ordered_json& summary, const LoadedModel& input, const RequestedFacts& facts);
} // namespace pixelexact
