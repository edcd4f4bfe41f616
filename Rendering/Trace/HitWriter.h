// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Location/Owners.h"
#include "Trace/HitResults.h"
#include "Trace/SampleWriter.h"
#include "Trace/Sheets.h"

#include <span>
#include <vector>

namespace pixelexact
{
/// Takes what was found at hits to the sheets that they are seen on, and counts it.
class HitWriter
{
public:
  /// `place`: of each hit in the buffers; `depth`: by ray, the sheet that it has come to, empty:
  /// the nearest. Hits that are outside of the mesh are written nowhere but where owners are
  /// counted.
  void Write(const Locator& locator, HitResults found, std::span<const std::size_t> place,
    std::span<const int> depth, Sheets& sheets, FrameCounters& counters);

private:
  /// All normals at once, of a surface to which each question costs much.
  void AskNormals(HitResults& found);
  void CountOwners(const Locator& locator, const HitResults& found,
    std::span<const std::size_t> place, std::span<const int> depth, SampleBuffers& nearest);
  void WriteSheet(int sheet, const HitResults& found, std::span<const Verdict> verdicts,
    std::span<const std::size_t> place, Sheets& sheets, FrameCounters& counters);

  SampleWriter Writer;
  std::vector<Verdict> OfSheet;
  std::vector<Vec3> Positions;
  std::vector<SurfacePoint> Points;
  std::vector<Vec3> Asked;
  std::vector<Vec3> Normals; ///< of hits, by number
  std::vector<Owners> Counted;
};
} // namespace pixelexact
