// SPDX-License-Identifier: BSD-3-Clause
// A frame has the same bytes the first and the hundredth time, in whichever passes it was made,
// from any number of threads; and it is shown where its elements have collapsed.
#include "Block.h"
#include "FrameCheck.h"

#include "Trace/ProgressiveFrame.h"
#include "Trace/Surfaces/Plane.h"
#include "Trace/Tracer.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <gtest/gtest.h>

namespace pixelexact::testing
{
namespace
{
constexpr Buffer kAllWithEnclosure = kAll | Buffer::Coverage | Buffer::Enclosure;

/// A curved hexahedron with a face collapsed to the edge x = y = 0, and a bent one before it; cut
/// across the edge.
class Collapsed
{
public:
  Collapsed()
  {
    Add(
      [](const LongVec3& xi) -> LongVec3
      {
        const auto [a, b, c] = xi;
        return { (1 + a) / 2, (1 + a) * (b + 0.1L * b * b * c) / 2, c + 0.1L * (1 + a) * b };
      });
    Add(
      [](const LongVec3& xi) -> LongVec3
      {
        const auto [a, b, c] = xi;
        return { a - 1 + 0.1L * (1 - a) * b * b, b + 0.1L * c * c * (1 - a), c };
      });
    field_ = { "u", Values.View() };
    Meshed = Elements.View();
  }

  /// A scene with the locator's.
  [[nodiscard]] Scene With(const Locator& locator) const
  {
    Scene scene;
    scene.locator = &locator;
    scene.layers.push_back(
      { std::make_shared<Plane>(Vec3(0.0, 0.0, 0.1), Vec3(0.1, 0.2, 1.0)), &field_ });
    return scene;
  }

  Mesh Meshed;

private:
  void Add(const MeshBuilder::Map& map)
  {
    const Space space = UniformSpace(Shape::Hexahedron, 3);
    Elements.Add(space, map);
    Values.Add(space, [](const LongVec3& xi, long double* u) { u[0] = xi[0] * xi[1] + xi[2]; });
  }

  Field field_;
  MeshBuilder Elements;
  ExpansionBuilder Values{ 1 };
};

Frame Render(const Scene& scene, const Camera& camera, int threads, bool inPasses)
{
  const tbb::global_control limit(
    tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  return arena.execute(
    [&]
    {
      if (!inPasses)
      {
        return Trace(scene, camera, {}, { .centres = kAllWithEnclosure });
      }
      ProgressiveFrame frame(scene, camera, {}, kAllWithEnclosure);
      while (frame.Step() != 1)
      {
        frame.Refine();
      }
      return frame.Take();
    });
}
} // namespace

TEST(FrameHistory, LeavesNoTrace)
{
  const Collapsed mesh;
  // The whole, of several tiles, and what is around the edge.
  for (const Camera& camera :
    { ViewAlongZ(49, 3, 0.05), ViewAlongZ(9, 5, 1e-3), ViewAlongZ(3, 3, 1e-9) })
  {
    const Locator first(mesh.Meshed);
    const Frame wanted = Render(mesh.With(first), camera, 1, false);
    EXPECT_GT(wanted.counters.exact, 0);
    Locator used(mesh.Meshed);
    for (int repeat = 0; repeat < 100; ++repeat)
    {
      const int threads = repeat % 3 == 0 ? 1 : repeat % 3 == 1 ? 2 : 16;
      ExpectSame(Render(mesh.With(used), camera, threads, repeat % 2 == 0), wanted);
      if (repeat % 10 == 0)
      {
        Render(mesh.With(used), ViewAlongZ(40, 34, 1.3), threads, true);
      }
      // Trees are dropped from the fiftieth frame on.
      used.Index().SetTreeLimit(repeat < 50 ? std::size_t{ 256 } << 20U : 0);
    }
    for (const int threads : { 1, 2, 16 })
    {
      for (const bool inPasses : { false, true })
      {
        const Locator fresh(mesh.Meshed);
        ExpectSame(Render(mesh.With(fresh), camera, threads, inPasses), wanted);
      }
    }
  }
}
} // namespace pixelexact::testing
