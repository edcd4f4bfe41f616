// SPDX-License-Identifier: BSD-3-Clause
// The most that a single point costs: for every mesh file given (or in the folders given), points
// at random in the mesh's box and those of the oracles beside it, each asked alone with trees that
// have to be grown for it. A Markdown table on stdout; with --list, what each point gave and cost.
//
// usage: SlowestPoint [--points N] [--list FILE] FILE|FOLDER...
#include "CaseFiles.h"
#include "Filters/LoadMesh.h"

#include "Core/Location/Sample.h"
#include "HighOrderModel.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <random>
#include <string_view>

namespace
{
using namespace pixelexact;

/// Processor time.
double MillisecondsSince(std::clock_t start)
{
  return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

std::vector<Vec3> PointsFor(
  const std::filesystem::path& file, const Box3& box, std::size_t atRandom)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> part(-0.02, 1.02);
  std::vector<Vec3> points(atRandom);
  for (Vec3& x : points)
  {
    for (int d = 0; d < 3; ++d)
    {
      x[d] = box.lower[d] + part(random) * (box.upper[d] - box.lower[d]);
    }
  }
  const auto oracles = OraclePoints(file);
  points.insert(points.end(), oracles.begin(), oracles.end());
  return points;
}

/// Writes one line per point, so that two lists of the same points can be compared.
class PointList
{
public:
  void Open(const char* file)
  {
    Out.open(file);
    Out << "file,point,x,y,z,verdict,element,xi1,xi2,xi3,ms\n" << std::setprecision(17);
  }
  void Add(const std::filesystem::path& file, std::size_t point, const Vec3& x, Verdict verdict,
    int element, const Vec3& xi, double milliseconds)
  {
    if (Out.is_open())
    {
      Out << file.filename().string() << ',' << point << ',' << x.x << ',' << x.y << ',' << x.z
          << ',' << static_cast<int>(verdict) << ',' << element << ',' << xi.x << ',' << xi.y << ','
          << xi.z << ',' << milliseconds << '\n';
    }
  }

private:
  std::ofstream Out;
};

void Measure(const std::filesystem::path& file, std::size_t atRandom, PointList& list)
{
  const auto grid = pixelexact::testing::LoadMesh(file);
  if (!grid || grid->GetNumberOfCells() == 0)
  {
    std::cerr << file << ": no mesh\n";
    return;
  }
  const auto model = HighOrderModel::From(grid);
  const Mesh& mesh = model->GetMesh();
  double bounds = 0.0;
  for (int element = 0; element < mesh.Elements(); ++element)
  {
    const auto start = std::clock();
    MakeElementBounds(mesh, element);
    bounds = std::max(bounds, MillisecondsSince(start));
  }
  Locator locator(mesh);
  locator.Index().SetTreeLimit(0);
  const auto points = PointsFor(file, locator.Bounds(), atRandom);
  if (points.empty())
  {
    std::cerr << file << ": no points\n";
    return;
  }
  double slowest = 0.0;
  Vec3 where(0.0);
  std::vector<double> times;
  for (const Vec3& x : points)
  {
    Verdict verdict{};
    std::int32_t element = -1;
    Vec3 xi(0.0);
    const auto start = std::clock();
    SampleTarget target;
    target.verdict = { &verdict, 1 };
    target.element = { &element, 1 };
    target.xi = { &xi, 1 };
    SampleTile(locator, nullptr, { &x, 1 }, target);
    const double milliseconds = MillisecondsSince(start);
    list.Add(file, times.size(), x, verdict, element, xi, milliseconds);
    times.push_back(milliseconds);
    if (milliseconds > slowest)
    {
      slowest = milliseconds;
      where = x;
    }
  }
  const auto above =
    std::ranges::count_if(times, [](double milliseconds) { return milliseconds > 10.0; });
  std::ranges::sort(times);
  const auto& counters = locator.Counters();
  std::printf("| %s | %zu | %lld | %lld | %.3f | %.2f | %.2f | %lld | %.17g %.17g %.17g | %.2f |\n",
    file.filename().c_str(), points.size(), static_cast<long long>(counters.careful),
    static_cast<long long>(counters.unknown), times[times.size() / 2],
    times[times.size() * 99 / 100], slowest, static_cast<long long>(above), where.x, where.y,
    where.z, bounds);
  std::fflush(stdout);
}
} // namespace

int main(int argc, char** argv)
{
  const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
  std::size_t atRandom = 2000;
  PointList list;
  std::puts(
    "| file | points | on the careful path | unknown | median ms | 99 % ms | slowest ms | "
    "above 10 ms | where | an element's bounds ms |\n|---|---|---|---|---|---|---|---|---|---|");
  try
  {
    for (int i = 1; i < argc; ++i)
    {
      if (std::string_view(argv[i]) == "--points" && i + 1 < argc)
      {
        atRandom = std::strtoul(argv[++i], nullptr, 10);
        continue;
      }
      if (std::string_view(argv[i]) == "--list" && i + 1 < argc)
      {
        list.Open(argv[++i]);
        continue;
      }
      for (const auto& file : MeshFilesIn(argv[i]))
      {
        Measure(file, atRandom, list);
      }
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
