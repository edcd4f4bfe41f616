// SPDX-License-Identifier: BSD-3-Clause
// Iso-surfaces where the field's gradient vanishes: sheets that touch and cross, against their
// roots along rays in closed form; and how much work that may take.
#include "IsoPairs.h"

#include "Trace/Surfaces/Curved/PartTree.h"

#include <tbb/parallel_for.h>

#include <optional>

namespace pixelexact::testing
{
namespace
{
/// Parallel rays through a square of `side` x `side` places about the element.
std::vector<Ray> Picture(const Vec3& direction, int side)
{
  const Vec3 along = glm::normalize(direction);
  const Vec3 up = std::fabs(along.y) < 0.9 ? Vec3(0.0, 1.0, 0.0) : Vec3(0.0, 0.0, 1.0);
  const Vec3 right = glm::normalize(glm::cross(up, along));
  const Vec3 top = glm::cross(along, right);
  std::vector<Ray> rays;
  for (int j = 0; j < side; ++j)
  {
    for (int i = 0; i < side; ++i)
    {
      const double x = 3.0 * (2.0 * i + 1.0 - side) / side;
      const double y = 3.0 * (2.0 * j + 1.0 - side) / side;
      rays.push_back({ x * right + y * top - 8.0 * along, along });
    }
  }
  return rays;
}

const std::array<Vec3, 4> kDirections{ Vec3(0.0, 0.0, 1.0), Vec3(1.0, 0.0, 0.0),
  Vec3(0.3, 0.2, 1.0), Vec3(0.61, -0.5, 0.4) };

struct Count
{
  int rays = 0;
  int hits = 0;
  int close = 0;     ///< rays that closed forms leave to rounding
  int undecided = 0; ///< of the others
  int far = 0;       ///< of these, where no root is near
  int wrong = 0;
};

/// The hits before the first undecided one are the first roots; all of them, where there is none.
void CompareRoots(const IsoPair& pair, const std::vector<Ray>& rays, Count& count)
{
  const auto hits = MeetPoints(*pair.iso, rays);
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const IsoTruth truth = TruthOf(pair, rays[i]);
    const auto open = std::ranges::find_if(
      hits[i], [](const PointHit& hit) { return hit.status == HitStatus::Undecided; });
    const auto certain = static_cast<std::size_t>(open - hits[i].begin());
    ++count.rays;
    count.hits += static_cast<int>(certain);
    if (truth.isClose)
    {
      ++count.close;
      continue;
    }
    if (open != hits[i].end())
    {
      const bool isAtRoot =
        certain < truth.roots.size() && std::fabs(open->t - truth.roots[certain]) <= 1e-6;
      ++count.undecided;
      count.far += isAtRoot ? 0 : 1;
    }
    bool right =
      open != hits[i].end() ? certain <= truth.roots.size() : certain == truth.roots.size();
    for (std::size_t k = 0; right && k < certain; ++k)
    {
      right = std::fabs(hits[i][k].t - truth.roots[k]) <= 1e-6;
    }
    // An undecided interval begins no later than the next root.
    right = right &&
      (open == hits[i].end() || certain == truth.roots.size() ||
        open->t <= truth.roots[certain] + 1e-6);
    if (!right && ++count.wrong <= 2)
    {
      ADD_FAILURE() << "map " << pair.map << ", field "
                    << kIsoFieldNames[static_cast<std::size_t>(pair.number)] << " = " << pair.value
                    << ", ray " << i << ": " << certain << " hits, " << truth.roots.size()
                    << " roots";
    }
  }
}
} // namespace

/// Every pair of a map and a field, at values where sheets touch or cross, and where they do not.
TEST(IsoPairs, HitsAreTheRootsInClosedForm)
{
  for (int field = 0; field < kIsoFields; ++field)
  {
    Count count;
    std::int64_t most = 0;
    for (int map = 0; map < kIsoMaps; ++map)
    {
      for (const double value : { 0.0, 0.1, -0.1 })
      {
        const IsoPair pair(map, field, value);
        for (const Vec3& direction : kDirections)
        {
          CompareRoots(pair, Picture(direction, 9), count);
        }
        most = std::max(most, pair.iso->PiecesMade());
      }
    }
    std::cout << "[ measured ] " << kIsoFieldNames[static_cast<std::size_t>(field)] << ": "
              << count.rays << " rays, " << count.hits << " hits, " << count.close
              << " left to rounding, " << count.undecided << " others undecided, " << most
              << " pieces at most" << std::endl;
    EXPECT_EQ(count.wrong, 0);
    // A root may lie where two pieces meet. Near a plateau, as far as rounding moves a root of
    // order 3 or 4, every ray is decided.
    EXPECT_EQ(count.far, 0);
    EXPECT_LE(count.undecided, count.rays / 500);
    EXPECT_GT(count.hits, 0);
    EXPECT_LE(most, 40'000);
  }
}

namespace
{
using Hits = std::vector<std::vector<PointHit>>;

/// Compares rays and their first `some` hits.
void ExpectSameRoots(const Hits& a, const Hits& b, std::optional<std::size_t> some = std::nullopt)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    const std::size_t count = std::min(some.value_or(a[i].size()), a[i].size());
    ASSERT_EQ(count, std::min(some.value_or(b[i].size()), b[i].size())) << "ray " << i;
    for (std::size_t k = 0; k < count; ++k)
    {
      EXPECT_EQ(a[i][k].t, b[i][k].t) << "ray " << i;
      EXPECT_EQ(a[i][k].position, b[i][k].position) << "ray " << i;
      EXPECT_EQ(a[i][k].status, b[i][k].status) << "ray " << i;
    }
  }
}

long UndecidedOf(const Hits& hits)
{
  return std::ranges::count_if(hits,
    [](const std::vector<PointHit>& of)
    {
      return std::ranges::any_of(
        of, [](const PointHit& hit) { return hit.status == HitStatus::Undecided; });
    });
}

Hits MeetWith(
  const Surface& surface, const std::vector<Ray>& rays, std::int64_t work, bool nearestOnly = false)
{
  return MeetPoints(surface, rays, std::vector<double>(rays.size(), kNearest), nearestOnly, work);
}
} // namespace

/// Sheets that cross, with less and less work: no hit is lost, and what a ray meets depends on no
/// other ray, on no thread and on nothing that was met before.
TEST(IsoPairs, WorkThatRunsOutLeavesRaysUndecided)
{
  for (const int field : { 0, 2, 6 })
  {
    const IsoPair pair(7, field, field == 0 ? 0.0 : 1e-9);
    const std::vector<Ray> rays = Picture({ 0.3, 0.2, 1.0 }, 16);
    const Hits all = MeetWith(*pair.iso, rays, kRayWork);
    long before = UndecidedOf(all);
    std::cout << "[ measured ] " << kIsoFieldNames[static_cast<std::size_t>(field)] << ": "
              << before;
    for (const std::int64_t work : { 100'000, 20'000, 0 })
    {
      const IsoPair fresh(7, field, pair.value);
      const Hits some = MeetWith(*fresh.iso, rays, work);
      const long undecided = UndecidedOf(some);
      std::cout << ", " << undecided;
      EXPECT_GE(undecided, before);
      before = undecided;
      Count count;
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        // Before the first that is undecided the hits are the same.
        const auto open = std::ranges::find_if(
          some[i], [](const PointHit& hit) { return hit.status == HitStatus::Undecided; });
        const auto certain = static_cast<std::size_t>(open - some[i].begin());
        ASSERT_LE(certain, all[i].size());
        for (std::size_t k = 0; k < certain; ++k)
        {
          EXPECT_NEAR(some[i][k].t, all[i][k].t, 1e-9);
        }
        if (certain < all[i].size())
        {
          ASSERT_NE(open, some[i].end());
          EXPECT_LE(open->t, all[i][certain].t + 1e-9);
        }
      }
      ExpectSameRoots(MeetWith(*fresh.iso, rays, work), some);
      ExpectSameRoots(MeetWith(*pair.iso, rays, work), some);
      ExpectSameRoots(MeetWith(*fresh.iso, rays, work, true), some, 1);
      const IsoPair other(7, field, pair.value);
      tbb::parallel_for(std::size_t{ 0 }, rays.size(),
        [&](std::size_t i)
        { ExpectSameRoots(MeetWith(*other.iso, { rays[i] }, work), { some[i] }); });
    }
    std::cout << " undecided of " << rays.size() << std::endl;
    EXPECT_GT(before, 0);
  }
}

TEST(IsoPairs, WhatIsNotKeptIsMadeEachTime)
{
  const std::int64_t before = PartTree::BytesKept();
  const std::vector<Ray> rays = Picture({ 0.3, 0.2, 1.0 }, 16);
  for (const int field : { 0, 2, 6 })
  {
    const IsoPair pair(6, field, 0.0);
    const Hits wanted = MeetWith(*pair.iso, rays, kRayWork);
    const std::int64_t bytes = PartTree::BytesKept();
    EXPECT_GT(bytes, before);
    PartTree::SetMostBytes(bytes);
    {
      const IsoPair other(6, field, 0.0);
      ExpectSameRoots(MeetWith(*other.iso, rays, kRayWork), wanted);
      EXPECT_EQ(other.iso->PartsMade(), 0);
      EXPECT_EQ(PartTree::BytesKept(), bytes);
      // A tree that is there does not grow.
      ExpectSameRoots(MeetWith(*pair.iso, Picture({ 0.61, -0.5, 0.4 }, 16), kRayWork),
        MeetWith(*other.iso, Picture({ 0.61, -0.5, 0.4 }, 16), kRayWork));
      EXPECT_EQ(PartTree::BytesKept(), bytes);
    }
    PartTree::SetMostBytes(PartTree::kMaxBytes);
  }
  EXPECT_EQ(PartTree::BytesKept(), before);
}

TEST(IsoPairs, TheWorkOfARayIsItsShareOfThePicture)
{
  EXPECT_EQ(WorkOfRay(1, 1, 1), kRayWork);
  EXPECT_EQ(WorkOfRay(300, 300, 1), kFrameWork / 90'000);
  EXPECT_EQ(WorkOfRay(300, 300, 4), kMinRayWork);
  EXPECT_EQ(WorkOfRay(100'000, 100'000, 255), kMinRayWork);
  EXPECT_EQ(WorkOfRay(0, 0, 0), kRayWork);
}
} // namespace pixelexact::testing
