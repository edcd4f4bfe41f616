// SPDX-License-Identifier: BSD-3-Clause
// Any samples of a tile, in the order of memory: each is written to its own place.
#include "MeshBuilder.h"

#include "Trace/Camera.h"
#include "Trace/TileHits.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pixelexact::testing
{
TEST(SampleWriter, WritesEachSampleToItsPlace)
{
  const Camera camera(CameraView{}, 50, 37);
  TileSamples tile;
  tile.Begin(camera, { 0, 0, 32, 32 }, {}, 50);
  const std::vector<std::size_t> all(tile.place.begin(), tile.place.begin() + tile.Count());
  ASSERT_EQ(std::vector(all.begin(), all.begin() + 3), (std::vector<std::size_t>{ 0, 1, 2 }));
  Random random(5);
  SampleWriter writer;
  for (int repeat = 0; repeat < 300; ++repeat)
  {
    // Nearly all of them, some, hardly any; in rows and single ones.
    const double share = random(0.0, 1.0);
    const double together = random(0.0, 1.0);
    std::vector<std::size_t> place;
    std::vector<Verdict> verdicts;
    bool taken = true;
    for (const std::size_t at : all)
    {
      taken = random(0.0, 1.0) < together ? taken : random(0.0, 1.0) < share;
      if (taken)
      {
        place.push_back(at);
        const double kind = random(0.0, 1.0);
        verdicts.push_back(kind < 0.9 || together > 0.8 ? Verdict::Inside
            : kind < 0.95                               ? Verdict::Outside
                                                        : Verdict::Unknown);
      }
    }
    std::vector<int> inside(50 * 37, -1);
    std::vector<int> held = inside;
    std::vector<int> wantedInside = inside;
    std::vector<int> wantedHeld = inside;
    for (std::size_t i = 0; i < place.size(); ++i)
    {
      wantedInside[place[i]] = verdicts[i] == Verdict::Inside ? static_cast<int>(i) : -1;
      wantedHeld[place[i]] = verdicts[i] == Verdict::Outside ? -1 : static_cast<int>(i);
    }
    writer.Sort(verdicts, place);
    const auto number = [](std::size_t i) { return static_cast<int>(i); };
    writer.WriteInside(inside, number);
    writer.WriteHeld(held, number);
    ASSERT_EQ(inside, wantedInside) << repeat;
    ASSERT_EQ(held, wantedHeld) << repeat;
    EXPECT_EQ(writer.Exact(), std::ranges::count(verdicts, Verdict::Inside));
    EXPECT_EQ(writer.Unknown(), std::ranges::count(verdicts, Verdict::Unknown));
  }
}
} // namespace pixelexact::testing
