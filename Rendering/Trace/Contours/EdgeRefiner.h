// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Contours/LayerSight.h"
#include "Trace/Modules/ContourCertifier.h"

#include <cstdint>
#include <span>
#include <vector>

namespace pixelexact
{
/// The verdict of what consists of two parts, without branches.
inline ContourVerdict JoinVerdicts(ContourVerdict a, ContourVerdict b)
{
  const auto joined = b == ContourVerdict::Out ? a : ContourVerdict::Undecided;
  return a == ContourVerdict::In || b == ContourVerdict::In ? ContourVerdict::In : joined;
}

/// Settles a tile's edges, and halves those that are open.
class EdgeRefiner
{
public:
  /// `states`: of all edges; those that are in stay so. All must outlive it.
  EdgeRefiner(LayerSight& sight, const EdgeClassifier& classifier, const ContourMethod& method,
    std::span<ContourVerdict> states, ContourCounters& counted);

  /// Edges of a row or a column, one after the other. `peeks`: a corner of a pixel at the edge
  /// shows the layer, so that it is looked for between samples that do not.
  void Add(std::size_t edge, const EdgeEnd& a, const EdgeEnd& b, bool peeks);
  /// After a row or a column, or where edges were left out.
  void EndRow();
  /// Edges that are open become undecided here.
  void MarkOpen(std::span<ContourVerdict> states) const;
  /// Children what is open.
  void Refine();

private:
  struct Part
  {
    std::size_t edge;
    EdgeEnd a;
    EdgeEnd b;
    bool peeks = false;
  };

  /// Of its ends that are on the layer; see EdgeClassifier.
  [[nodiscard]] int SideOf(const Part& part) const;
  /// Whether the values of two elements lie on either side of one: it is between them even if none
  /// takes it.
  [[nodiscard]] bool MayJump(const Part& part) const;
  [[nodiscard]] EdgeFinding ClassifyWithin(const Part& part) const;
  /// Of one that is Uncovered: Out where all that it may meet stays on its side.
  [[nodiscard]] EdgeFinding ClassifyBeyond(const Part& part) const;
  /// Whether none of all that its rays may meet takes a value, so that it is out whatever they see:
  /// beside silhouettes, and where the surface ends.
  [[nodiscard]] bool ShowsNoValue(const Part& part) const;
  /// Consecutive edges that are Uncovered.
  void SettleRun(std::span<const Part> run);
  void Settle(const Part& part, EdgeFinding finding, int level);

  LayerSight& Sight;
  const EdgeClassifier& Classifier;
  ContourMethod Method;
  bool IsPlane;
  std::span<ContourVerdict> States;
  ContourCounters& Counted;
  std::vector<int> Parts;   ///< open, of each edge
  std::vector<int> Samples; ///< of each edge, so far
  bool IsLimited;           ///< these are; on curved surfaces silhouettes take many
  std::vector<Part> Run;
  std::vector<Part> Open;
};
} // namespace pixelexact
