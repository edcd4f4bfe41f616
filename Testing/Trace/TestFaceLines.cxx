// SPDX-License-Identifier: BSD-3-Clause
#include "TrueLines.h"

#include "Trace/Modules/ElementEdges.h"
#include "Trace/Modules/FaceLines.h"
#include "Trace/TileVisit.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace pixelexact::testing
{
namespace
{
constexpr double kReach = 1.5;

/// The lines of all pixels of a frame.
std::vector<FaceLine> LinesOf(const Scene& scene, const Camera& camera, Frame& frame)
{
  const Pipeline pipeline;
  std::vector<FaceLine> lines;
  FaceLines search;
  for (int y = 0; y < frame.height; y += kTileSize)
  {
    for (int x = 0; x < frame.width; x += kTileSize)
    {
      TileVisit visit(&scene, &camera, pipeline, frame,
        { x, y, std::min(x + kTileSize, frame.width), std::min(y + kTileSize, frame.height) });
      const auto found = search.Find(visit, kReach);
      lines.insert(lines.end(), found.begin(), found.end());
    }
  }
  return lines;
}

struct LineTally
{
  int lines = 0;
  int expected = 0;
  int missing = 0;
  int nearEnds = 0;      ///< lines where a layer ends nearby, or another begins
  int madeUp = 0;        ///< of these, where none is within a pixel of the place
  double farthest = 0.0; ///< from the true place
};

std::array<double, 2> CentreOf(std::size_t pixel, int width)
{
  const auto across = static_cast<std::size_t>(width);
  return { static_cast<double>(pixel % across) + 0.5, static_cast<double>(pixel / across) + 0.5 };
}

/// The direction of a block's inner face; -1: it is on the boundary.
int InnerDirection(const FaceLine& line)
{
  // Faces in the order of FacesOf. An element is on the upper side where its bit is set.
  constexpr int kDirections[] = { 2, 0, 0, 1, 1, 2 };
  constexpr bool kUpper[] = { false, false, true, false, true, true };
  const int direction = kDirections[line.face];
  const bool above = (line.element >> direction & 1) != 0;
  return kUpper[line.face] != above ? direction : -1;
}

/// All lines of a view against the true ones.
LineTally CompareLines(const TrueScene& scene, const CameraView& view, int size)
{
  const Camera camera(view, size, size);
  Frame frame =
    Trace(scene.Traced, camera, {}, { .centres = ElementEdges(EdgeStyle()).Needs().centres });
  const TrueLines truth(scene, view, size, size);
  LineTally tally;
  std::map<std::size_t, double> found;
  for (const FaceLine& line : LinesOf(scene.Traced, camera, frame))
  {
    const int direction = InnerDirection(line);
    if (direction < 0)
    {
      continue;
    }
    const auto known = found.emplace(line.pixel, line.distance).first;
    known->second = std::min(known->second, line.distance);
    const auto [x, y] = CentreOf(line.pixel, size);
    const int layer = frame.centres.layer[line.pixel];
    const double distance = truth.To(x, y, layer, direction).distance;
    if (truth.IsAlone(x, y, layer, kReach + 0.1))
    {
      ++tally.lines;
      tally.farthest = std::max(tally.farthest, std::fabs(distance - line.distance));
      continue;
    }
    ++tally.nearEnds;
    // The surface is there, up to the step in which a place settles.
    const double to = line.distance - 0.06;
    const int there = truth.At(x + to * line.towards.x, y + to * line.towards.y).layer;
    tally.madeUp += distance > line.distance + 0.1 && there != layer ? 1 : 0;
  }
  for (std::size_t i = 0; i < frame.centres.Size(); ++i)
  {
    const auto [x, y] = CentreOf(i, size);
    const int layer = frame.centres.layer[i];
    if (layer == kNoLayer || !truth.IsAlone(x, y, layer, kReach + 0.1))
    {
      continue;
    }
    const double distance = truth.To(x, y, layer).distance;
    if (distance < kReach - 0.1)
    {
      ++tally.expected;
      const auto at = found.find(i);
      tally.missing += at == found.end() || at->second > distance + 0.1 ? 1 : 0;
    }
  }
  return tally;
}
} // namespace

/// Small and large elements.
TEST(FaceLines, AreWhereSurfacesCrossFaces)
{
  const Block block;
  TrueScene scene(block);
  scene.AddSphere({ 0.2, -0.1, 0.3 }, 0.6, { nullptr, &block.field_ }, &Block::CurvedAt);
  scene.AddPlane(
    { 0.0, 0.0, 0.1 }, { 0.2, 0.1, 1.0 }, { nullptr, &block.field_ }, &Block::CurvedAt);
  for (const int size : { 30, 60, 120 })
  {
    const LineTally tally = CompareLines(scene, MakeAskewView(), size);
    SCOPED_TRACE(size);
    EXPECT_GT(tally.lines, 3 * size / 2);
    EXPECT_LT(tally.farthest, 0.1);
    EXPECT_GT(tally.expected, 3 * size / 2);
    EXPECT_EQ(tally.missing, 0);
  }
}

/// Beyond a silhouette nothing is near, although what is seen there is steep.
TEST(FaceLines, EndAtSilhouettes)
{
  const Block block;
  for (const double radius : { 0.3, 0.6, 0.9 })
  {
    TrueScene scene(block);
    scene.AddSphere({ 0.05, -0.1, 0.02 }, radius, { nullptr, &block.field_ }, &Block::CurvedAt);
    for (const int size : { 30, 100 })
    {
      const LineTally tally = CompareLines(scene, MakeAskewView(), size);
      SCOPED_TRACE(::testing::Message() << radius << " " << size);
      EXPECT_GT(tally.nearEnds, 5);
      EXPECT_EQ(tally.madeUp, 0);
      EXPECT_LT(tally.farthest, 0.1);
      EXPECT_EQ(tally.missing, 0);
    }
  }
}
} // namespace pixelexact::testing
