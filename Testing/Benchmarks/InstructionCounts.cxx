// SPDX-License-Identifier: BSD-3-Clause
// Work whose instructions are counted under valgrind's callgrind, so that figures repeat on a noisy
// machine: frames of made meshes on one thread, each beside the bare kernel on as many points.
// instructions.py runs it and compares. Without valgrind it does the work and counts nothing.
#include "Bench/KernelTime.h"
#include "Bench/MadeBlock.h"

#include "Core/Element/Kernels.h"
#include "Core/Location/Locator.h"
#include "Trace/Modules/ColorMapping.h"
#include "Trace/Surfaces/Plane.h"
#include "Trace/Tracer.h"

#include <tbb/global_control.h>

#include <valgrind/callgrind.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace
{
using namespace pixelexact;

constexpr int kPixels = 128;
constexpr int kElements = 500;

template <class Work>
void Counted(const std::string& name, const Work& work)
{
  CALLGRIND_START_INSTRUMENTATION;
  CALLGRIND_ZERO_STATS;
  work();
  CALLGRIND_DUMP_STATS_AT(name.c_str());
  CALLGRIND_STOP_INSTRUMENTATION;
}

std::string NameOf(const BlockKind& kind)
{
  return std::string(Name(kind.shape)) + (kind.curved ? " curved" : " straight") + " order " +
    std::to_string(kind.order);
}

void Count(const BlockKind& kind)
{
  const MadeBlock block(kind);
  const Locator locator(block.GetMesh());
  CameraView view;
  view.position = { 0.0, 0.0, 4.0 };
  view.parallel = true;
  view.parallelScale = 0.55;
  const Camera camera(view, kPixels, kPixels);
  Scene scene;
  scene.locator = &locator;
  scene.layers.push_back(
    { std::make_shared<Plane>(Vec3(0.013, 0.021, 0.034), Vec3(0.2, 0.3, 1.0)), &block.GetField() });
  const ColorMapping colors(
    [](std::span<const double> values, std::uint8_t* rgba)
    {
      for (const double v : values)
      {
        rgba = std::fill_n(rgba, 4, static_cast<std::uint8_t>(127.0 + 64.0 * v));
      }
    });
  const Pipeline pipeline{ { &colors }, {} };
  // The first frame includes work that is done once, so it is not counted.
  const std::int64_t points = Trace(scene, camera, pipeline).counters.exact;
  const std::string name = NameOf(kind);
  std::printf("%s\t%lld\n", name.c_str(), static_cast<long long>(points));
  Counted(name + "\tframe", [&] { (void)Trace(scene, camera, pipeline); });
  Counted(name + "\tkernel", [&] { (void)KernelSeconds(block.GetField().values, points); });
}
} // namespace

/// Arguments: the names of cases; none: all.
int main(int argc, char** argv)
{
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  std::printf("instruction set\t%s\n", InstructionSet());
  for (const Shape shape : { Shape::Hexahedron, Shape::Prism, Shape::Tetrahedron, Shape::Pyramid })
  {
    for (const bool curved : { false, true })
    {
      for (const int order : { 3, 6 })
      {
        const BlockKind kind{ shape, curved, order, kElements };
        if (argc < 2 || std::find(argv + 1, argv + argc, NameOf(kind)) != argv + argc)
        {
          Count(kind);
        }
      }
    }
  }
}
