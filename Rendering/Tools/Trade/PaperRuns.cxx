// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/PaperRuns.h"

#include "Base/PeakMemory.h"
#include "Base/Report.h"
#include "Bench/ContourTime.h"
#include "Bench/FrameTime.h"
#include "Bench/MadeBlock.h"
#include "Scene/ColorOptions.h"

#include "Core/Location/Sample.h"
#include "Trace/Modules/ContourCertifier.h"
#include "Trace/Surfaces/BezierPatches.h"
#include "Trace/Surfaces/Plane.h"
#include "Trace/Surfaces/Quadric.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace pixelexact
{
namespace
{
constexpr int kTimedContours = 5;

/// The values of each parameter, and its fixed value while others vary.
struct Ranges
{
  std::vector<int> orders;
  std::vector<int> elements;
  std::vector<int> sizes; ///< of images, along a side
  std::vector<int> grids; ///< samples along a side of a volume
  std::vector<int> planes;
  int order;
  int count;
  int size;
  int repeat;
};

Ranges RangesOf(PaperExtent extent)
{
  return extent == PaperExtent::Whole
    ? Ranges{ { 2, 4, 6, 8, 10, 12, 14, 16 }, { 1000, 5000, 20000, 50000, 100000, 200000 },
        { 250, 500, 1000, 1500, 2000 }, { 32, 64, 128, 256 }, { 256, 512, 1024, 2048 }, 8, 5000,
        1000, 9 }
    : Ranges{ { 2, 4, 8, 14 }, { 1000, 5000, 20000 }, { 125, 250, 500 }, { 16, 32, 64 },
        { 64, 128, 256 }, 6, 2000, 250, 3 };
}

enum class Cut
{
  Plane,
  Cylinder,
  Patch
};

std::shared_ptr<const Surface> MakeCut(Cut cut)
{
  switch (cut)
  {
    case Cut::Plane:
      return std::make_shared<Plane>(
        Vec3(0.013, 0.021, 0.034), Vec3(0.2, 0.3, 1.0) / std::sqrt(1.13));
    case Cut::Cylinder:
      return std::make_shared<Quadric>(
        MakeCylinder(Vec3(0.013, 0.021, -0.5), Vec3(0.1, 1.0, -0.3), 0.85));
    default:
    {
      BezierPatch patch{ { 3, 3 }, {} };
      for (int i = 0; i < 4; ++i)
      {
        for (int j = 0; j < 4; ++j)
        {
          patch.points.emplace_back(
            -0.95 + 1.9 * i / 3.0, -0.95 + 1.9 * j / 3.0, (i + j) % 2 == 0 ? 0.3 : -0.2);
        }
      }
      return std::make_shared<BezierPatches>(std::span(&patch, 1));
    }
  }
}

/// A view in which the cut fills the image.
Camera ViewOf(int size)
{
  CameraView view;
  view.position = { 0.0, 0.0, 4.0 };
  view.parallel = true;
  view.parallelScale = 0.55;
  return { view, size, size };
}

Scene SceneOf(const MadeBlock& block, const Locator& locator, Cut cut)
{
  Scene scene;
  scene.locator = &locator;
  scene.layers.push_back({ MakeCut(cut), &block.GetField() });
  return scene;
}

double FrameSeconds(const Scene& scene, int size, int repeat)
{
  const ColorMapping colors(ColorOptions().MapOver({ -1.0, 1.0 }));
  return MeasureFrames(scene, ViewOf(size), { { &colors }, {} }, repeat, [](double) {}).Frame();
}

double ContourSeconds(const Scene& scene, int size, int repeat)
{
  std::vector<double> values;
  for (int k = 1; k <= kTimedContours; ++k)
  {
    values.push_back(-1.0 + 2.0 * k / (kTimedContours + 1));
  }
  const ColorMapping colors(ColorOptions().MapOver({ -1.0, 1.0 }));
  ContourCertifier certifier({ values }, ContourMethod(), nullptr);
  return MeasureContours(scene, ViewOf(size), { { &colors }, {} }, { { &colors }, { &certifier } },
    std::max(1, repeat / 3), [] { return ContourCounters(); })
    .Frame();
}

/// Memory of the process for a mesh, its hierarchy and a frame.
double FrameBytes(const BlockKind& kind, int size)
{
  const PeakMemory memory;
  const MadeBlock block(kind);
  const Locator locator(block.GetMesh());
  const ColorMapping colors(ColorOptions().MapOver({ -1.0, 1.0 }));
  (void)Trace(SceneOf(block, locator, Cut::Plane), ViewOf(size), { { &colors }, {} });
  return memory.Bytes().value_or(-1.0);
}

class PaperTask
{
public:
  PaperTask(PaperExtent extent, const std::function<void(double)>& progress, PaperResults& results)
    : The(RangesOf(extent))
    , Progress(progress)
    , Results(results)
  {
  }

  void Run()
  {
    Samples();
    Progress(0.2);
    Orders();
    Progress(0.5);
    Elements();
    Progress(0.7);
    Sizes();
    Progress(0.9);
    Memory();
  }

private:
  [[nodiscard]] BlockKind Kind(Shape shape, int order, int elements) const
  {
    return { shape, true, order, elements, false };
  }
  void Add(const char* figure, const std::string& series, double x, double seconds, double bytes)
  {
    Results.rows.push_back({ figure, series, x, seconds, bytes });
  }

  /// Figures 8 (a) and (b): samples on a grid over the volume, and on a plane.
  void Samples()
  {
    for (const int order : { 2, 4, 8 })
    {
      const MadeBlock block(Kind(Shape::Hexahedron, order, The.count));
      const Locator locator(block.GetMesh());
      const std::string series = fmt::format("order {}", order);
      const auto measure = [&](const char* figure, int across, int deep)
      {
        std::vector<Vec3> points;
        for (int k = 0; k < deep; ++k)
        {
          for (int j = 0; j < across; ++j)
          {
            for (int i = 0; i < across; ++i)
            {
              const auto at = [](int n, int of) { return -0.9 + 1.8 * (n + 0.5) / of; };
              points.emplace_back(at(i, across), at(j, across), at(k, deep) + 0.034);
            }
          }
        }
        std::vector<double> values(points.size());
        SampleTarget target{};
        target.value = values;
        // The first run computes the elements' bounds.
        Sample(locator, &block.GetField(), points, target);
        const Timer timer;
        Sample(locator, &block.GetField(), points, target);
        Add(figure, series, static_cast<double>(points.size()), timer.Seconds(), -1.0);
      };
      for (const int grid : The.grids)
      {
        measure("8a", grid, grid);
      }
      for (const int grid : The.planes)
      {
        measure("8b", grid, 1);
      }
    }
  }

  void Orders()
  {
    for (const Shape shape : { Shape::Hexahedron, Shape::Prism, Shape::Tetrahedron })
    {
      for (const int order : The.orders)
      {
        const MadeBlock block(Kind(shape, order, The.count));
        const Locator locator(block.GetMesh());
        const Scene scene = SceneOf(block, locator, Cut::Plane);
        Add("10a", Name(shape), order, FrameSeconds(scene, The.size, The.repeat), -1.0);
        if (shape == Shape::Hexahedron)
        {
          Add("10a", "contours", order, ContourSeconds(scene, The.size, The.repeat), -1.0);
        }
      }
    }
  }

  void Elements()
  {
    for (const Shape shape : { Shape::Hexahedron, Shape::Prism, Shape::Tetrahedron })
    {
      for (const int elements : The.elements)
      {
        const MadeBlock block(Kind(shape, 3, elements));
        const Locator locator(block.GetMesh());
        Add("10b", Name(shape), elements,
          FrameSeconds(SceneOf(block, locator, Cut::Plane), The.size, The.repeat), -1.0);
      }
    }
  }

  void Sizes()
  {
    const MadeBlock block(Kind(Shape::Hexahedron, 3, The.count));
    const Locator locator(block.GetMesh());
    const std::pair<const char*, Cut> cuts[] = { { "plane", Cut::Plane },
      { "cylinder", Cut::Cylinder }, { "bicubic patch", Cut::Patch } };
    for (const auto& [name, cut] : cuts)
    {
      const Scene scene = SceneOf(block, locator, cut);
      for (const int size : The.sizes)
      {
        const double pixels = static_cast<double>(size) * size;
        Add("10c", name, pixels, FrameSeconds(scene, size, The.repeat), -1.0);
        if (cut == Cut::Plane)
        {
          Add("10c", "contours", pixels, ContourSeconds(scene, size, The.repeat), -1.0);
        }
      }
    }
  }

  void Memory()
  {
    for (const int order : The.orders)
    {
      Add("10d", "bytes", order, 0.0,
        FrameBytes(Kind(Shape::Hexahedron, order, The.count), The.size));
    }
    for (const int size : The.sizes)
    {
      Add("10e", "bytes", static_cast<double>(size) * size, 0.0,
        FrameBytes(Kind(Shape::Hexahedron, The.order, The.count), size));
    }
    for (const int elements : The.elements)
    {
      if (elements <= 100000)
      {
        Add("10f", "bytes", elements, 0.0,
          FrameBytes(Kind(Shape::Hexahedron, The.order, elements), The.size));
      }
    }
  }

  Ranges The;
  const std::function<void(double)>& Progress;
  PaperResults& Results;
};
} // namespace

void MeasurePaper(
  PaperExtent extent, const std::function<void(double)>& progress, PaperResults& results)
{
  PaperTask(extent, progress, results).Run();
}
} // namespace pixelexact
