// SPDX-License-Identifier: BSD-3-Clause
// Jumps between the elements of neighbouring pixels, on curved elements, in closed form.
#include "Block.h"

#include "Trace/Modules/CutJumps.h"
#include "Trace/Surfaces/Quadric.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pixelexact::testing
{
namespace
{
/// The field in element e of a Block; the largest value is 15.
long double JumpingValueAt(int e, const LongVec3& x)
{
  return 1.5L * e + (1 + 0.25L * e) * x[0] - x[1] + 0.5L * (e % 3) * x[2];
}

/// A Block with that field; or with that of element 0 everywhere.
class JumpingBlock
{
public:
  explicit JumpingBlock(bool isContinuous)
  {
    for (int e = 0; e < 8; ++e)
    {
      Values.Add(UniformSpace(Shape::Hexahedron, 4),
        [&](const LongVec3& xi, long double* u)
        { *u = JumpingValueAt(isContinuous ? 0 : e, Block::Map(e, xi)); });
    }
    field_ = { "u", Values.View() };
    scene_.locator = block_.scene_.locator;
  }

  CutJumps Find(const std::shared_ptr<const Surface>& surface, Frame& frame)
  {
    scene_.layers = { { surface, &field_ } };
    // Even numbers: no pixel's centre is on a face.
    frame = Trace(scene_, ViewAlongZ(100, 84), {}, { .centres = NeedsOfCutJumps() });
    return FindCutJumps(scene_, frame.centres);
  }

private:
  Block block_;
  ExpansionBuilder Values{ 1 };
  Field field_;
  Scene scene_;
};

/// The positions where the segment between two points of the plane z = `z` leaves the element of
/// the first one. The inner faces of a Block are x = z y / 5 and y = x / 5.
std::array<double, 2> WaysToFaces(const Vec3& a, const Vec3& b)
{
  const auto zero = [](double atA, double atB) { return atA / (atA - atB); };
  return { zero(a.x - 0.2 * a.z * a.y, b.x - 0.2 * b.z * b.y),
    zero(a.y - 0.2 * a.x, b.y - 0.2 * b.x) };
}

/// The jump between two pixels' elements, which differ in one direction; NaN: in several.
double JumpBetween(const SampleBuffers& samples, std::size_t i, std::size_t j)
{
  const auto a = static_cast<int>(samples.element[i]);
  const auto b = static_cast<int>(samples.element[j]);
  const int differs = a ^ b;
  if (differs != 1 && differs != 2)
  {
    return std::nan("");
  }
  const double part =
    WaysToFaces(samples.position[i], samples.position[j])[static_cast<std::size_t>(differs - 1)];
  const LongVec3 x = ToLong(samples.position[i] * (1.0 - part) + samples.position[j] * part);
  return static_cast<double>(std::fabs(JumpingValueAt(b, x) - JumpingValueAt(a, x)));
}
} // namespace

TEST(CutJumps, AreThoseOfClosedFormOnBentFaces)
{
  JumpingBlock block(false);
  Frame frame;
  const CutJumps jumps =
    block.Find(std::make_shared<Plane>(Vec3(0.0, 0.0, 0.3), Vec3(0.0, 0.0, 1.0)), frame);
  const SampleBuffers& samples = frame.centres;
  int compared = 0;
  double largest = 0.0;
  for (std::size_t i = 0; i < samples.Size(); ++i)
  {
    double wanted = std::nan("");
    for (const std::size_t j : { i + 1, i + static_cast<std::size_t>(samples.width) })
    {
      const bool isNeighbour = j != i + 1 || j % static_cast<std::size_t>(samples.width) != 0;
      if (isNeighbour && j < samples.Size() && samples.element[i] >= 0 && samples.element[j] >= 0 &&
        samples.element[i] != samples.element[j])
      {
        wanted = std::fmax(wanted, JumpBetween(samples, i, j));
        ++compared;
      }
    }
    EXPECT_EQ(std::isnan(samples.jump[i]), std::isnan(wanted)) << i;
    if (!std::isnan(wanted))
    {
      EXPECT_NEAR(samples.jump[i], wanted, 1e-12 * 15.0) << i;
      largest = std::max(largest, wanted);
    }
  }
  EXPECT_GT(compared, 120);
  EXPECT_EQ(jumps.jumping, compared);
  EXPECT_EQ(jumps.continuous + jumps.notFinite + jumps.notFound, 0);
  ASSERT_TRUE(jumps.largest);
  EXPECT_NEAR(jumps.largest->jump, largest, 1e-12 * 15.0);
}

TEST(CutJumps, AreTakenOnTheChordOfCurvedSurfaces)
{
  JumpingBlock block(false);
  Frame frame;
  const CutJumps jumps =
    block.Find(std::make_shared<Quadric>(MakeSphere({ 0.1, 0.05, 0.0 }, 0.8)), frame);
  EXPECT_GT(jumps.jumping, 100);
  EXPECT_EQ(jumps.notFound, 0);
  ASSERT_TRUE(jumps.largest);
  const auto [a, b] = jumps.largest->elements;
  const LongVec3 x = ToLong(jumps.largest->position);
  EXPECT_NEAR(jumps.largest->jump,
    static_cast<double>(std::fabs(JumpingValueAt(b, x) - JumpingValueAt(a, x))), 1e-12 * 15.0);
  // A pixel is 0.03 wide: chords are within their sagitta, 0.03^2 / (8 * 0.8), of the sphere.
  const Vec3 from = jumps.largest->position - Vec3(0.1, 0.05, 0.0);
  EXPECT_NEAR(std::sqrt(from.x * from.x + from.y * from.y + from.z * from.z), 0.8, 2e-3);
}

TEST(CutJumps, OfContinuousFieldsAreZero)
{
  JumpingBlock block(true);
  for (const std::shared_ptr<const Surface>& surface :
    { std::shared_ptr<const Surface>(
        std::make_shared<Plane>(Vec3(0.1, 0.0, 0.2), Vec3(0.3, 0.2, 1.0))),
      std::shared_ptr<const Surface>(
        std::make_shared<Quadric>(MakeSphere({ 0.1, 0.05, 0.0 }, 0.8))) })
  {
    Frame frame;
    const CutJumps jumps = block.Find(surface, frame);
    EXPECT_EQ(jumps.jumping + jumps.notFinite + jumps.notFound, 0);
    EXPECT_GT(jumps.continuous, 100);
    EXPECT_FALSE(jumps.largest);
    EXPECT_EQ(std::ranges::count(frame.centres.jump, 0.0),
      std::ranges::count_if(frame.centres.jump, [](double jump) { return !std::isnan(jump); }));
  }
}
} // namespace pixelexact::testing
