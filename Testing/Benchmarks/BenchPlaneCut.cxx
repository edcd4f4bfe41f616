// SPDX-License-Identifier: BSD-3-Clause
// A 1000 x 1000 plane cut beside the bare evaluation kernel and beside VTK's own probe, and where
// its time goes. `ns_per_point` counts points inside of the mesh only; table.py turns a run's JSON
// into ratios. Argument 0: the data set (BenchmarkData.h).
#include "BenchmarkData.h"

#include "Core/Element/Kernels.h"
#include "Core/Location/Sample.h"
#include "Trace/Modules/ColorMapping.h"
#include "Trace/Surfaces/Plane.h"
#include "Trace/TileVisit.h"
#include "Trace/TraceTile.h"
#include "Trace/Tracer.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProbeFilter.h"
#include "vtkStaticCellLocator.h"

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <thread>

namespace pixelexact::benchmarks
{
namespace
{
constexpr int kPixels = 1000;

void Report(benchmark::State& state, std::size_t points)
{
  state.SetLabel(GetPlaneCut(static_cast<int>(state.range(0))).name);
  state.counters["points"] = static_cast<double>(points);
  // Inverted rate of a kilo-iteration invariant: seconds per point, scaled to nanoseconds.
  state.counters["ns_per_point"] = benchmark::Counter(static_cast<double>(points) * 1e-9,
    benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

Scene SceneOf(const PlaneCut& cut)
{
  Scene scene;
  scene.locator = &cut.model->GetLocator();
  scene.layers.push_back({ std::make_shared<Plane>(cut.origin, cut.normal), cut.field });
  return scene;
}

/// The kernel alone: one element's coefficients and a batch of points, all in cache.
void BareKernel(benchmark::State& state)
{
  const PlaneCut& cut = GetPlaneCut(static_cast<int>(state.range(0)));
  constexpr int kBatch = 1024;
  std::vector<double> xi[3];
  for (std::size_t i = 0; xi[0].size() < kBatch && i < cut.frame.centres.Size(); ++i)
  {
    const Vec3& at = cut.frame.centres.xi[i];
    if (std::isfinite(at.x))
    {
      for (int d = 0; d < 3; ++d)
      {
        xi[d].push_back(at[d]);
      }
    }
  }
  std::vector<double> out(kBatch);
  double* const outTo[1] = { out.data() };
  const Space& space = cut.field->values.SpaceOf(0);
  const auto kernels = KernelsFor(space);
  const std::size_t batches = (cut.inside.size() + kBatch - 1) / kBatch;
  for (auto _ : state)
  {
    for (std::size_t b = 0; b < batches; ++b)
    {
      kernels.value(space, cut.field->values.Coefficients(0), 1,
        { { xi[0].data(), xi[1].data(), xi[2].data() }, kBatch }, outTo);
      benchmark::DoNotOptimize(out.data());
      benchmark::ClobberMemory();
    }
  }
  Report(state, batches * kBatch);
}

ColorMapping GrayColors()
{
  return ColorMapping(
    [](std::span<const double> values, std::uint8_t* rgba)
    {
      for (const double v : values)
      {
        const auto gray = static_cast<std::uint8_t>(std::clamp(127.5 + 127.5 * v, 0.0, 255.0));
        const std::uint8_t color[4] = { gray, gray, gray, 255 };
        rgba = std::copy_n(color, 4, rgba);
      }
    });
}

/// The frame as `render` makes it; argument 1: threads, 0 for all. The colour map is a plain one,
/// so that VTK's is not what is measured.
void PlaneCutFrame(benchmark::State& state)
{
  const PlaneCut& cut = GetPlaneCut(static_cast<int>(state.range(0)));
  const auto all = std::thread::hardware_concurrency();
  const auto threads = state.range(1) == 0 ? all : static_cast<unsigned>(state.range(1));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  const Scene scene = SceneOf(cut);
  const Camera camera = ViewOf(cut, kPixels);
  const ColorMapping colors = GrayColors();
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(Trace(scene, camera, { { &colors }, {} }).Image().data());
  }
  Report(state, cut.inside.size());
  state.counters["tbb_threads"] = threads;
}

/// Share of the rays and hits: all of the image's, per point inside.
void StageRaysAndHits(benchmark::State& state)
{
  const PlaneCut& cut = GetPlaneCut(static_cast<int>(state.range(0)));
  const Scene scene = SceneOf(cut);
  const Camera camera = ViewOf(cut, kPixels);
  TileSamples samples;
  std::vector<HitSlots> hits;
  for (auto _ : state)
  {
    for (int y = 0; y < kPixels; y += kTileSize)
    {
      for (int x = 0; x < kPixels; x += kTileSize)
      {
        samples.Begin(camera,
          { x, y, std::min(x + kTileSize, kPixels), std::min(y + kTileSize, kPixels) }, {},
          kPixels);
        samples.Meet(camera, scene, hits);
        benchmark::DoNotOptimize(hits[0].T(0));
      }
    }
  }
  Report(state, cut.inside.size());
}

/// Location of the frame's inside points in tile-sized runs, without or with evaluation.
void StageLocate(benchmark::State& state)
{
  const PlaneCut& cut = GetPlaneCut(static_cast<int>(state.range(0)));
  const bool evaluate = state.range(1) != 0;
  constexpr std::size_t kRun = 1024;
  // Runs of neighbouring pixels: blocks of 32 x 32, as the tracer's tiles.
  std::vector<Vec3> ordered;
  for (int ty = 0; ty < kPixels; ty += 32)
  {
    for (int tx = 0; tx < kPixels; tx += 32)
    {
      for (int y = ty; y < std::min(ty + 32, kPixels); ++y)
      {
        for (int x = tx; x < std::min(tx + 32, kPixels); ++x)
        {
          const auto at = static_cast<std::size_t>(y) * kPixels + static_cast<std::size_t>(x);
          if (cut.frame.centres.verdict[at] == static_cast<std::uint8_t>(PixelVerdict::Exact))
          {
            ordered.push_back(cut.frame.centres.position[at]);
          }
        }
      }
    }
  }
  std::vector<std::int32_t> element(kRun);
  std::vector<double> value(kRun);
  for (auto _ : state)
  {
    for (std::size_t begin = 0; begin < ordered.size(); begin += kRun)
    {
      const auto points = std::span(ordered).subspan(begin, std::min(kRun, ordered.size() - begin));
      SampleTarget target;
      target.element = std::span(element).first(points.size());
      target.value = evaluate ? std::span(value).first(points.size()) : std::span<double>();
      SampleTile(cut.model->GetLocator(), evaluate ? cut.field : nullptr, points, target);
    }
  }
  Report(state, ordered.size());
}

/// Looks at the corners of every pixel.
class Corners final : public FrameModule
{
public:
  [[nodiscard]] SampleNeeds Needs() const override
  {
    return { .corners = Buffer::Value | Buffer::Verdict };
  }
  void Begin(int /*width*/, int /*height*/) override {}
  void Process(TileVisit& tile) override { benchmark::DoNotOptimize(tile.Corners().value.data()); }
};

/// Times that a pipeline adds to a frame, on one thread. Argument 0: nothing is painted; 1:
/// colours, tile by tile; 2: colours after tracing; 3: corners in addition to centres, for a
/// module.
void Pipelines(benchmark::State& state)
{
  const PlaneCut& cut = GetPlaneCut(static_cast<int>(state.range(0)));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  const Scene scene = SceneOf(cut);
  const Camera camera = ViewOf(cut, kPixels);
  const ColorMapping colors = GrayColors();
  Corners corners;
  const SampleNeeds needs{ .centres = Buffer::Value | Buffer::Verdict };
  const Pipeline pipelines[] = { {}, { { &colors }, {} }, {}, { {}, { &corners } } };
  const auto which = static_cast<std::size_t>(state.range(1));
  for (auto _ : state)
  {
    Frame frame = Trace(scene, camera, pipelines[which], needs);
    if (which == 2)
    {
      Repaint({ { &colors }, {} }, frame);
    }
    benchmark::DoNotOptimize(frame.centres.value.data());
  }
  Report(state, cut.inside.size());
}

/// VTK's probe on the file's own Lagrange cells, on a sample of the cut's points. Argument 1:
/// 0 its defaults; 1 a static cell locator and a tolerance that loses few points.
void VtkProbe(benchmark::State& state)
{
  const PlaneCut& cut = GetPlaneCut(static_cast<int>(state.range(0)));
  const std::size_t stride = cut.inside.size() / 500;
  const auto points = PointsOf(cut, stride);
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(points);
  probe->SetSourceData(cut.source);
  if (state.range(1) != 0)
  {
    vtkNew<vtkStaticCellLocator> locator;
    probe->SetCellLocatorPrototype(locator);
    probe->ComputeToleranceOff();
    probe->SetTolerance(1e-2);
  }
  // The first execution builds the locator; what is timed is probing.
  probe->Update();
  for (auto _ : state)
  {
    probe->Modified();
    probe->Update();
  }
  const auto count = static_cast<std::size_t>(points->GetNumberOfPoints());
  Report(state, count);
  auto* mask = probe->GetOutput()->GetPointData()->GetArray(probe->GetValidPointMaskArrayName());
  auto* values = probe->GetOutput()->GetPointData()->GetArray("u");
  const auto [low, high] = std::ranges::minmax(cut.values);
  double worst = 0.0;
  double lost = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    if (mask->GetTuple1(id) == 0.0)
    {
      lost += 1.0;
      continue;
    }
    worst = std::max(worst, std::fabs(values->GetTuple1(id) - cut.values[i * stride]));
  }
  state.counters["lost_percent"] = 100.0 * lost / static_cast<double>(count);
  state.counters["error_of_range"] = worst / (high - low);
}

/// Time from arrays to the first query: bounds and hierarchy.
void BuildLocator(benchmark::State& state)
{
  const PlaneCut& cut = GetPlaneCut(static_cast<int>(state.range(0)));
  for (auto _ : state)
  {
    const Locator locator(cut.model->GetMesh());
    benchmark::DoNotOptimize(&locator);
  }
  state.SetLabel(cut.name);
}

BENCHMARK(BareKernel)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(PlaneCutFrame)
  ->ArgsProduct({ { 0, 1 }, { 1, 0 } })
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
BENCHMARK(Pipelines)
  ->ArgsProduct({ { 0, 1 }, { 0, 1, 2, 3 } })
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
BENCHMARK(StageRaysAndHits)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(StageLocate)->ArgsProduct({ { 0, 1 }, { 0, 1 } })->Unit(benchmark::kMillisecond);
BENCHMARK(VtkProbe)
  ->ArgsProduct({ { 0, 1 }, { 0, 1 } })
  ->Unit(benchmark::kMillisecond)
  ->Iterations(2);
BENCHMARK(BuildLocator)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();
} // namespace
} // namespace pixelexact::benchmarks
