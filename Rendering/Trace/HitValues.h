// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/HitResults.h"
#include "Trace/RunsByKey.h"

#include <vector>

namespace pixelexact
{
/// Verdicts, places in the mesh and values of hits, and the arrays that hold them.
class HitValues
{
public:
  /// Locates `count` hits, whose layer, t and positions are there, and evaluates the layer's field:
  /// what the buffers `wanted` take. Sets the spans of `found`. Hits that know their element are
  /// not located; of those that are undecided the verdict is Unknown, unless they are outside.
  void Evaluate(const Locator& locator, const SampleBuffers& wanted, std::size_t count,
    HitResults& found, PrecisionCheck& check);

private:
  void Locate(
    const Locator& locator, const Field* field, const HitResults& found, PrecisionCheck& check);
  void EvaluateKnown(const Mesh& mesh, const Field* field, const HitResults& found);
  void Reduce(const Layer& layer, HitResults& found);
  /// The hits' normals, where the field needs them; else none.
  [[nodiscard]] std::span<const Vec3> NormalsFor(const Field* field, const HitResults& found);

  std::vector<std::int32_t> Elements;
  std::vector<Verdict> Verdicts;
  std::vector<Vec3> Xis;
  std::vector<double> Values;
  std::vector<double> Lowers;
  std::vector<double> Uppers;
  std::vector<Vec3> Positions;
  std::vector<Vec3> Normals;
  std::vector<SurfacePoint> Points;
  // Of one element's hits.
  std::vector<KeyRun> Runs;
  std::vector<Vec3> XiOfElement;
  std::vector<Vec3> PositionsOfElement;
  std::vector<Vec3> NormalsOfElement;
  std::vector<double> ValuesOfElement;
  std::vector<double> UppersOfElement;
  // Of these as many as are wanted; components for each hit.
  std::span<std::int32_t> Element;
  std::span<Verdict> TheVerdict;
  std::span<Vec3> Xi;
  std::span<double> Value;
  std::span<double> Lower;
  std::span<double> Upper;
};
} // namespace pixelexact
