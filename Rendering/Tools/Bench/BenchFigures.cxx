// SPDX-License-Identifier: BSD-3-Clause
#include "Bench/BenchFigures.h"

#include "Base/Report.h"
#include "Bench/FrameTime.h"
#include "Bench/MadeBlock.h"
#include "Scene/ColorOptions.h"

#include "Core/Element/Kernels.h"
#include "Trace/Surfaces/Plane.h"

#include <nlohmann/json.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace pixelexact
{
namespace
{
constexpr int kDefaultElements = 5000;
constexpr int kMaxElements = 1000000;
/// Coefficients beyond this are not made: 2 GB.
constexpr std::int64_t kMaxCoefficients = 250000000;

struct BlockRow
{
  BlockKind kind;
  ImageSize size{};
  int elements = 0;
  int bounded = 0; ///< elements of which more than the box was made
  double build = 0.0;
  std::size_t memory = 0;
  FrameTime one{};
  FrameTime all{};
  FrameTime floats{}; ///< one thread, values in single precision
};

/// All of the image's pixels lie in the mesh.
Camera FilledView(const Vec3& normal, const ImageSize& size)
{
  CameraView view;
  view.position = 4.0 * normal;
  view.parallel = true;
  view.parallelScale =
    0.55 * std::min(1.0, static_cast<double>(size.height) / static_cast<double>(size.width));
  return { view, size.width, size.height };
}

BlockRow Measure(const BlockKind& kind, const ImageSize& size, const BenchFigureOptions& options)
{
  BlockRow row;
  row.kind = kind;
  row.size = size;
  const MadeBlock block(kind);
  const auto begin = std::chrono::steady_clock::now();
  const Locator locator(block.GetMesh());
  row.build = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  row.elements = block.GetMesh().Elements();
  const Vec3 normal = Vec3(0.2, 0.3, 1.0) / std::sqrt(1.13);
  Scene scene;
  scene.locator = &locator;
  scene.layers.push_back(
    { std::make_shared<Plane>(Vec3(0.013, 0.021, 0.034), normal), &block.GetField() });
  const Camera camera = FilledView(normal, size);
  const ColorMapping colors(ColorOptions().MapOver({ -1.0, 1.0 }));
  const Pipeline pipeline{ { &colors }, {} };
  const auto ignore = [](double) {};
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    row.one = MeasureFrames(scene, camera, pipeline, options.repeat, ignore);
    scene.layers[0].precision = Precision::Float;
    row.floats = MeasureFrames(scene, camera, pipeline, options.repeat, ignore);
    scene.layers[0].precision = Precision::Double;
  }
  row.all = MeasureFrames(scene, camera, pipeline, options.repeat, ignore);
  row.bounded = locator.Index().BoundedElements();
  row.memory = locator.Index().MemoryUsage();
  return row;
}

double PerPoint(const FrameTime& time)
{
  return time.points > 0 ? 1e9 * time.Frame() / static_cast<double>(time.points) : 0.0;
}

double KernelPerPoint(const FrameTime& time)
{
  return time.points > 0 ? 1e9 * time.Kernel() / static_cast<double>(time.points) : 0.0;
}

void PrintBlock(const BlockRow& row)
{
  const std::string size = fmt::format("{}x{}", row.size.width, row.size.height);
  fmt::print("{:12} {:8} {:5} {:8} {:>10} {:9} {:8.1f} {:7.1f} {:6.1f} {:8.1f} {:6.1f} {:7.1f} "
             "{:>8.1e}  {}\n",
    row.kind.mixed ? "mixed" : Name(row.kind.shape), row.kind.curved ? "curved" : "straight",
    row.kind.order, row.elements, size, row.one.points, KernelPerPoint(row.one), PerPoint(row.one),
    row.one.Ratio(), PerPoint(row.all), row.all.Ratio(), PerPoint(row.floats),
    row.floats.floatCheck.largest, Shares(row.one.stages));
  FlushOutput();
}

nlohmann::ordered_json Summary(const BlockRow& row)
{
  return { { "shape", row.kind.mixed ? "mixed" : Name(row.kind.shape) },
    { "curved", row.kind.curved }, { "order", row.kind.order }, { "elements", row.elements },
    { "width", row.size.width }, { "height", row.size.height }, { "points", row.one.points },
    { "locator_seconds", row.build }, { "locator_bytes", row.memory },
    { "elements_bounded", row.bounded }, { "kernel_ns", KernelPerPoint(row.one) },
    { "one_thread_ns", PerPoint(row.one) }, { "one_thread_ratio", row.one.Ratio() },
    { "all_threads_ns", PerPoint(row.all) }, { "all_threads_ratio", row.all.Ratio() },
    { "floats_ns", PerPoint(row.floats) }, { "floats_error", row.floats.floatCheck.largest },
    { "stages", ToJson(row.one.stages) }, { "staged_seconds", row.one.staged } };
}

bool Fits(const BlockKind& kind)
{
  const std::int64_t each = UniformSpace(kind.shape, kind.order).Modes() +
    3 * UniformSpace(kind.shape, kind.curved ? 3 : 1).Modes();
  return each * kind.elements <= kMaxCoefficients;
}
struct Case
{
  BlockKind kind;
  ImageSize size;
};

/// Figure 10 (a): all shapes and orders.
void AddOrders(const BenchFigureOptions& options, std::vector<Case>& cases)
{
  for (const Shape shape : { Shape::Hexahedron, Shape::Prism, Shape::Tetrahedron, Shape::Pyramid })
  {
    for (const bool curved : { false, true })
    {
      for (const int order : { 3, 6, 8, 14 })
      {
        cases.push_back(
          { { shape, curved, order, std::min(kDefaultElements, options.largest) }, options.size });
      }
    }
  }
}

ImageSize Scaled(const ImageSize& size, double width, double height)
{
  const auto scaled = [](double factor, int pixels)
  { return std::max(1, static_cast<int>(std::lround(factor * pixels))); };
  return { scaled(width, size.width), scaled(height, size.height), {} };
}

/// Figure 10 (b) and (c): by elements, by pixels.
void AddGrowth(const BenchFigureOptions& options, std::vector<Case>& cases)
{
  for (const bool curved : { false, true })
  {
    for (const int elements : { 1000, 20000, 200000 })
    {
      if (elements <= options.largest)
      {
        cases.push_back({ { Shape::Hexahedron, curved, 6, elements }, options.size });
        cases.push_back({ { Shape::Tetrahedron, curved, 6, elements }, options.size });
      }
    }
    for (const double factor : { 0.5, 1.0, 2.0 })
    {
      cases.push_back(
        { { Shape::Hexahedron, curved, 6, std::min(kDefaultElements, options.largest) },
          Scaled(options.size, factor, factor) });
    }
  }
  if (kMaxElements <= options.largest)
  {
    cases.push_back({ { Shape::Hexahedron, false, 3, kMaxElements }, options.size });
  }
}

/// Meshes of hexahedra and prisms as large as the paper's canister (section 6); of the usual 1000 x
/// 1000 pixels its image has 1800 x 800.
void AddCanister(const BenchFigureOptions& options, std::vector<Case>& cases)
{
  for (const bool curved : { false, true })
  {
    cases.push_back({ { Shape::Hexahedron, curved, 3, std::min(5736, options.largest), true },
      Scaled(options.size, 1.8, 0.8) });
  }
}

std::vector<Case> CasesOf(const BenchFigureOptions& options)
{
  std::vector<Case> cases;
  AddOrders(options, cases);
  AddGrowth(options, cases);
  AddCanister(options, cases);
  return cases;
}
} // namespace

void RunFigures(const BenchFigureOptions& options)
{
  const std::vector<Case> cases = CasesOf(options);
  auto rows = nlohmann::ordered_json::array();
  if (!options.json)
  {
    fmt::print("Frames of a plane that fills the image; ns a pixel and ratio to the bare kernel "
               "({}), median of {}; 1 thread and {}.\n",
      InstructionSet(), options.repeat,
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
    fmt::print(
      "{:12} {:8} {:>5} {:>8} {:>10} {:>9} {:>8} {:>7} {:>6} {:>8} {:>6} {:>7} {:>8}  {}\n",
      "shape", "map", "order", "elements", "image", "pixels", "kernel", "frame", "ratio", "threads",
      "ratio", "floats", "error", "time of one thread in the tiles");
  }
  for (const auto& [kind, size] : cases)
  {
    if (!Fits(kind))
    {
      continue;
    }
    const BlockRow row = Measure(kind, size, options);
    if (options.json)
    {
      rows.push_back(Summary(row));
    }
    else
    {
      PrintBlock(row);
    }
  }
  if (options.json)
  {
    Print({ { "instruction_set", InstructionSet() }, { "repeat", options.repeat },
      { "threads",
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) },
      { "frames", rows } });
  }
}
} // namespace pixelexact
