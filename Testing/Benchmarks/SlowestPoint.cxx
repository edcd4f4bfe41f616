// SPDX-License-Identifier: BSD-3-Clause
// The most that a single point costs: for every mesh file given (or in the folders given), points
// at random in the mesh's box and those of the oracles beside it, each asked alone with trees that
// have to be grown for it. A Markdown table on stdout.
//
// usage: SlowestPoint [--points N] FILE|FOLDER...
#include "CaseFiles.h"
#include "Filters/LoadMesh.h"

#include "Core/Location/Sample.h"
#include "HighOrderModel.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
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

void Measure(const std::filesystem::path& file, std::size_t atRandom)
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
  double slowest = 0.0;
  Vec3 where(0.0);
  int above = 0;
  for (const Vec3& x : points)
  {
    const auto start = std::clock();
    SampleTile(locator, nullptr, { &x, 1 }, {});
    const double milliseconds = MillisecondsSince(start);
    above += milliseconds > 10.0 ? 1 : 0;
    if (milliseconds > slowest)
    {
      slowest = milliseconds;
      where = x;
    }
  }
  const auto& counters = locator.Counters();
  std::printf("| %s | %zu | %lld | %lld | %.2f | %d | %.17g %.17g %.17g | %.2f |\n",
    file.filename().c_str(), points.size(), static_cast<long long>(counters.careful),
    static_cast<long long>(counters.unknown), slowest, above, where.x, where.y, where.z, bounds);
  std::fflush(stdout);
}
} // namespace

int main(int argc, char** argv)
{
  const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
  std::size_t atRandom = 2000;
  std::puts(
    "| file | points | on the careful path | unknown | slowest ms | above 10 ms | where | an "
    "element's bounds ms |\n|---|---|---|---|---|---|---|---|");
  try
  {
    for (int i = 1; i < argc; ++i)
    {
      if (std::string_view(argv[i]) == "--points" && i + 1 < argc)
      {
        atRandom = std::strtoul(argv[++i], nullptr, 10);
        continue;
      }
      for (const auto& file : MeshFilesIn(argv[i]))
      {
        Measure(file, atRandom);
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
