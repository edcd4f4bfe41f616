// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Contours/LayerSight.h"
#include "Trace/Modules/ContourCertifier.h"

#include <cstdint>
#include <span>
#include <vector>

namespace pixelexact
{
/// Joins the verdicts of two parts of an edge or pixel, without branches.
inline ContourVerdict JoinVerdicts(ContourVerdict a, ContourVerdict b)
{
  const auto joined = b == ContourVerdict::Out ? a : ContourVerdict::Undecided;
  return a == ContourVerdict::In || b == ContourVerdict::In ? ContourVerdict::In : joined;
}

/// Classifies a tile's edges, and subdivides those that stay open.
class EdgeRefiner
{
public:
  /// `states`: verdicts of all edges; In is kept. All arguments must outlive the object.
  EdgeRefiner(LayerSight& sight, const EdgeClassifier& classifier, const ContourMethod& method,
    std::span<ContourVerdict> states, ContourCounters& counted);

  /// Adds an edge; edges of a row or column follow each other. `peeks`: a corner of one of the
  /// edge's pixels shows the layer, so the edge is subdivided even if both ends do not show it.
  void Add(std::size_t edge, const EdgeEnd& a, const EdgeEnd& b, bool peeks);
  /// Ends a row or a column, or a run before omitted edges.
  void EndRow();
  /// Makes open edges Undecided in `states`.
  void MarkOpen(std::span<ContourVerdict> states) const;
  /// Subdivides open parts until they are decided or limits are reached.
  void Refine();

private:
  struct Part
  {
    std::size_t edge;
    EdgeEnd a;
    EdgeEnd b;
    bool peeks = false;
  };

  /// The side of the first end that shows the layer; see EdgeClassifier.
  [[nodiscard]] int SideOf(const Part& part) const;
  /// An iso-value lies between the values of two elements. The field may jump across it, so that no
  /// element takes it.
  [[nodiscard]] bool MayJump(const Part& part) const;
  [[nodiscard]] EdgeFinding ClassifyWithin(const Part& part) const;
  /// Classifies an Uncovered part by all elements that it may meet: Out if they stay on its side.
  [[nodiscard]] EdgeFinding ClassifyBeyond(const Part& part) const;
  /// Nothing that the part's rays may meet takes an iso-value, so the part is Out in any case. Used
  /// beside silhouettes and where the surface ends.
  [[nodiscard]] bool ShowsNoValue(const Part& part) const;
  /// Classifies consecutive Uncovered edges together.
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
  bool IsLimited; ///< `Samples` has a limit; not on curved surfaces with their silhouettes
  std::vector<Part> Run;
  std::vector<Part> Open;
};
} // namespace pixelexact
