// SPDX-License-Identifier: BSD-3-Clause
// What iso-surfaces cost whose field has gradients that vanish: one pixel alone, a frame, memory
// and unknown pixels.
//
//   IsoStudy [--size N] [--random N] [--only WORD]
//
// 88 pairs of eight maps and eleven fields of a hexahedron, and random fields of the orders 1 to 8
// in elements of every shape, half of them through a critical point. Each case runs in a process of
// its own and on one thread. Prints a Markdown table; its last rows are the largest of all.
#include "../Trace/IsoPairs.h"

#include "Trace/Surfaces/Curved/PartTree.h"
#include "Trace/Tracer.h"

#include <glm/geometric.hpp>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <tbb/global_control.h>

#include <cstdio>
#include <cstring>
#include <ctime>

namespace pixelexact::testing
{
namespace
{
struct Options
{
  int size = 300;
  int random = 200;
  std::string only;
};

struct Cost
{
  double pixel = 0.0; ///< seconds of the slowest pixel, alone and with nothing kept
  double frame = 0.0; ///< seconds of the processor
  double megabytes = 0.0;
  double kept = 0.0; ///< of these, by trees, after the frame
  long unknown = 0;
  long shown = 0;
};

double ProcessorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// The parts of a case. It makes surfaces without cached data.
struct IsoCase
{
  const Mesh* mesh = nullptr;
  const ElementIndex* index = nullptr;
  const Field* field = nullptr;
  double value = 0.0;

  [[nodiscard]] std::shared_ptr<IsoSurface> Surface() const
  {
    return std::make_shared<IsoSurface>(*index, *field, 0, value, true);
  }
};

Camera ViewOf(int side)
{
  CameraView view;
  view.position = { 2.4, -3.0, 7.0 };
  view.focalPoint = { 0.0, 0.0, 0.0 };
  view.parallel = true;
  view.parallelScale = 2.4;
  return { view, side, side };
}

/// The pixel's ray in a picture of its own.
double SecondsOfPixel(const IsoCase& of, const Ray& ray)
{
  const auto surface = of.Surface();
  const double start = ProcessorSeconds();
  (void)HitsOf(*surface, ray);
  return ProcessorSeconds() - start;
}

Cost Measure(const IsoCase& of, int side)
{
  const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
  Cost cost;
  const Locator locator(*of.mesh);
  Scene scene;
  scene.locator = &locator;
  scene.layers.push_back({ of.Surface(), of.field });
  const Camera camera = ViewOf(side);
  const double start = ProcessorSeconds();
  const Frame frame =
    Trace(scene, camera, {}, { .centres = Buffer::Verdict | Buffer::Position | Buffer::Value });
  cost.frame = ProcessorSeconds() - start;
  cost.kept = static_cast<double>(PartTree::BytesKept()) / 1e6;
  std::vector<std::size_t> slow;
  const auto& verdict = frame.centres.verdict;
  for (std::size_t i = 0; i < verdict.size(); ++i)
  {
    const auto one = static_cast<PixelVerdict>(verdict[i]);
    cost.unknown += one == PixelVerdict::Unknown ? 1 : 0;
    cost.shown += one != PixelVerdict::Nothing ? 1 : 0;
    if (one == PixelVerdict::Unknown && slow.size() < 8)
    {
      slow.push_back(i);
    }
  }
  const std::size_t step = std::max<std::size_t>(verdict.size() / 37, 1);
  for (std::size_t i = step / 2; i < verdict.size(); i += step)
  {
    slow.push_back(i);
  }
  for (const std::size_t pixel : slow)
  {
    const auto width = static_cast<std::size_t>(side);
    const Ray ray =
      camera.At(static_cast<double>(pixel % width) + 0.5, static_cast<double>(pixel / width) + 0.5);
    cost.pixel = std::max(cost.pixel, SecondsOfPixel(of, ray));
  }
  return cost;
}

/// Runs `make` in a process of its own.
template <class Make>
Cost Alone(const Make& make)
{
  int ends[2];
  Cost cost;
  if (pipe(ends) != 0)
  {
    return cost;
  }
  const pid_t child = fork();
  if (child == 0)
  {
    const Cost own = make();
    const bool written = write(ends[1], &own, sizeof(own)) == sizeof(own);
    _exit(written ? 0 : 1);
  }
  rusage usage{};
  int status = 0;
  close(ends[1]);
  const bool isRead = read(ends[0], &cost, sizeof(cost)) == sizeof(cost);
  close(ends[0]);
  wait4(child, &status, 0, &usage);
  if (!isRead || status != 0)
  {
    cost.frame = std::numeric_limits<double>::infinity();
  }
  cost.megabytes = static_cast<double>(usage.ru_maxrss) / 1e3;
  return cost;
}

Cost Worst{};

void Print(const std::string& name, const Cost& cost)
{
  std::printf("| %s | %.1f | %.2f | %.0f | %.0f | %ld | %ld |\n", name.c_str(), 1e3 * cost.pixel,
    cost.frame, cost.megabytes, cost.kept, cost.unknown, cost.shown);
  std::fflush(stdout);
  Worst.pixel = std::max(Worst.pixel, cost.pixel);
  Worst.frame = std::max(Worst.frame, cost.frame);
  Worst.megabytes = std::max(Worst.megabytes, cost.megabytes);
  Worst.kept = std::max(Worst.kept, cost.kept);
  Worst.unknown = std::max(Worst.unknown, cost.unknown);
  Worst.shown = std::max(Worst.shown, cost.shown);
}

void Pairs(const Options& options)
{
  for (int map = 0; map < kIsoMaps; ++map)
  {
    for (int field = 0; field < kIsoFields; ++field)
    {
      for (const double value : { 0.0, 0.1 })
      {
        const std::string name = "map " + std::to_string(map) + ", " +
          kIsoFieldNames[static_cast<std::size_t>(field)] + " = " + (value == 0.0 ? "0" : "0.1");
        if (name.find(options.only) == std::string::npos || (field == 8 && value != 0.0))
        {
          continue;
        }
        Print(name,
          Alone(
            [&]
            {
              const IsoPair pair(map, field, value);
              const Mesh mesh = pair.mesh.View();
              return Measure({ &mesh, pair.index.get(), &pair.field, value }, options.size);
            }));
      }
    }
  }
}

Cost MeasureRandom(int number, Shape shape, int order, bool isCritical, int side)
{
  Random random(1000 + static_cast<std::uint64_t>(number));
  const auto amount = static_cast<long double>(random(0.0, 1.0));
  MeshBuilder builder;
  builder.Add(UniformSpace(shape, 3),
    [amount](const LongVec3& xi)
    {
      const LongVec3 bent = Curved(xi);
      LongVec3 x;
      for (std::size_t d = 0; d < 3; ++d)
      {
        x[d] = xi[d] + 2.0L * amount * (bent[d] - xi[d]);
      }
      return x;
    });
  ExpansionBuilder values(1);
  const Space space = UniformSpace(shape, order);
  values.Spaces = { space };
  values.SpaceOf = { 0 };
  values.Offset = { 0 };
  ForEachMode(space,
    [&](int p, int q, int r, int)
    { values.Coefficients.push_back(random() * std::pow(0.8, p + q + r)); });
  const Mesh mesh = builder.View();
  const ElementIndex index(mesh);
  const Field field{ "u", values.View() };
  Vec3 xi = random.Inside(shape);
  double value = 0.0;
  Vec3 slope;
  const auto evaluate = [&]
  { EvaluateAt(mesh, field, 0, std::span(&xi, 1), std::span(&value, 1), std::span(&slope.x, 3)); };
  evaluate();
  // Downhill in the gradient's square, by trial: about to a critical point.
  for (int step = 0; isCritical && step < 400; ++step)
  {
    const Vec3 before = xi;
    const double least = glm::length(slope);
    xi += std::pow(0.98, step) * 0.3 * RandomDirection(random);
    evaluate();
    const bool isBetter = glm::length(slope) < least && Margin(shape, xi) > 0.0;
    if (!isBetter)
    {
      xi = before;
      evaluate();
    }
  }
  return Measure({ &mesh, &index, &field, value }, side);
}

void RandomOnes(const Options& options)
{
  for (int number = 0; number < options.random; ++number)
  {
    const Shape shape = kShapes[number % 4];
    const int order = 1 + number / 4 % 8;
    const bool isCritical = number / 32 % 2 == 0;
    const std::string name = std::string("random ") + std::to_string(number) + ", " + Name(shape) +
      ", order " + std::to_string(order) + (isCritical ? ", critical" : "");
    if (name.find(options.only) != std::string::npos)
    {
      Print(
        name, Alone([&] { return MeasureRandom(number, shape, order, isCritical, options.size); }));
    }
  }
}
} // namespace
} // namespace pixelexact::testing

int main(int argc, char** argv)
{
  pixelexact::testing::Options options;
  for (int i = 1; i + 1 < argc; i += 2)
  {
    const std::string name = argv[i];
    if (name == "--size")
    {
      options.size = std::max(std::atoi(argv[i + 1]), 1);
    }
    else if (name == "--random")
    {
      options.random = std::atoi(argv[i + 1]);
    }
    else if (name == "--only")
    {
      options.only = argv[i + 1];
    }
  }
  std::printf(
    "| case | slowest pixel, ms | frame, s | process, MB | trees, MB | unknown | shown |\n"
    "|---|---:|---:|---:|---:|---:|---:|\n");
  pixelexact::testing::Pairs(options);
  pixelexact::testing::RandomOnes(options);
  pixelexact::testing::Print("largest", pixelexact::testing::Worst);
  return 0;
}
