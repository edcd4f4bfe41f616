// SPDX-License-Identifier: BSD-3-Clause
// What the careful path costs: for every file of the folders given, the share of points that needed
// it and its share of the time, for the points of the solver's oracle and for a plane cut of 400 x
// 400. A Markdown table on stdout.
//
// usage: CarefulShare FOLDER...
#include "CaseFiles.h"
#include "Filters/LoadMesh.h"

#include "Core/Location/Sample.h"
#include "HighOrderModel.h"

#include <glm/geometric.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <iostream>

namespace
{
using namespace pixelexact;

constexpr int kPixels = 400;
constexpr int kTile = 32;
constexpr int kRuns = 3;
constexpr double kLongEnough = 1.0; ///< seconds

struct Share
{
  std::size_t points = 0;
  std::int64_t inside = 0;
  std::int64_t unknown = 0;
  std::int64_t candidates = 0;
  std::int64_t queries = 0;
  std::size_t careful = 0; ///< points
  double seconds = 0.0;    ///< for all points
  double others = 0.0;     ///< for those that did not need the careful path
};

/// Processor time of serial location in runs of neighbours, the best of a few times where it is
/// quick.
double Seconds(const Locator& locator, std::span<const Vec3> points)
{
  double best = INFINITY;
  double total = 0.0;
  for (int run = 0; run < kRuns && total < kLongEnough; ++run)
  {
    const std::clock_t start = std::clock();
    Sample(locator, nullptr, points, {});
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    best = std::min(best, seconds);
    total += seconds;
  }
  return best;
}

Share Measure(const Locator& locator, std::span<const Vec3> points)
{
  const auto& counters = locator.Counters();
  Share share;
  share.points = points.size();
  std::vector<Verdict> verdict(points.size());
  SampleTarget target;
  target.verdict = verdict;
  const auto queries = counters.queries.load();
  const auto candidates = counters.candidates.load();
  Sample(locator, nullptr, points, target);
  share.queries = counters.queries - queries;
  share.candidates = counters.candidates - candidates;
  share.inside = std::ranges::count(verdict, Verdict::Inside);
  share.unknown = std::ranges::count(verdict, Verdict::Unknown);
  // The result of a point does not depend on others, so single points show which ones need it.
  std::vector<Vec3> others;
  for (const Vec3& x : points)
  {
    const auto before = counters.careful.load();
    SampleTile(locator, nullptr, { &x, 1 }, {});
    if (counters.careful == before)
    {
      others.push_back(x);
    }
  }
  share.careful = points.size() - others.size();
  share.seconds = Seconds(locator, points);
  share.others = share.careful == 0 ? share.seconds : Seconds(locator, others);
  return share;
}

/// A slanted cut through the middle that just covers the mesh's box, tile by tile.
std::vector<Vec3> CutPoints(const Box3& box)
{
  const Vec3 extent = box.upper - box.lower;
  const Vec3 centre = 0.5 * (box.lower + box.upper);
  std::vector<Vec3> points;
  for (int tile = 0; tile < (kPixels / kTile + 1) * (kPixels / kTile + 1); ++tile)
  {
    const int x0 = tile % (kPixels / kTile + 1) * kTile;
    const int y0 = tile / (kPixels / kTile + 1) * kTile;
    for (int y = y0; y < std::min(y0 + kTile, kPixels); ++y)
    {
      for (int x = x0; x < std::min(x0 + kTile, kPixels); ++x)
      {
        const double u = (x + 0.5) / kPixels - 0.5;
        const double v = (y + 0.5) / kPixels - 0.5;
        points.push_back(centre + extent * Vec3(u, v, 0.31 * u - 0.23 * v + 0.017));
      }
    }
  }
  return points;
}

void Print(const std::string& name, const char* what, const Share& share)
{
  const auto n = static_cast<double>(std::max<std::size_t>(share.points, 1));
  const double time = std::max(0.0, 1.0 - share.others / share.seconds);
  std::printf("| %s | %s | %zu | %lld | %.2f | %.3g | %zu | %.3f %% | %.1f %% | %.2f | %lld |\n",
    name.c_str(), what, share.points, static_cast<long long>(share.inside),
    static_cast<double>(share.candidates) / n, static_cast<double>(share.queries) / n,
    share.careful, 100.0 * static_cast<double>(share.careful) / n, 100.0 * time,
    1e6 * share.seconds / n, static_cast<long long>(share.unknown));
  std::fflush(stdout);
}

void MeasureFolder(const std::filesystem::path& folder)
{
  for (const auto& file : MeshFilesIn(folder))
  {
    const auto grid = pixelexact::testing::LoadMesh(file);
    if (!grid || grid->GetNumberOfCells() == 0)
    {
      std::cerr << file << ": no mesh\n";
      continue;
    }
    const auto model = HighOrderModel::From(grid);
    const Locator& locator = model->GetLocator();
    const std::string name = file.filename().string();
    const auto oracle = OraclePoints(file);
    if (!oracle.empty())
    {
      Print(name, "oracle", Measure(locator, oracle));
    }
    Print(name, "cut", Measure(locator, CutPoints(locator.Bounds())));
  }
}
} // namespace

int main(int argc, char** argv)
{
  const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
  std::puts("| file | points of | points | inside | candidates a point | queries a point | careful "
            "points | share | share of time | us a point | unknown |\n"
            "|---|---|---|---|---|---|---|---|---|---|---|");
  try
  {
    for (int i = 1; i < argc; ++i)
    {
      MeasureFolder(argv[i]);
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
