// SPDX-License-Identifier: BSD-3-Clause
// Which elements may take a value, against samples in long double.
#include "MeshBuilder.h"
#include "QuadReference.h"

#include "Core/Base/Error.h"
#include "Core/Index/ValueIndex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact::testing
{
namespace
{
/// Elements of all shapes with noise as field.
struct Noise
{
  explicit Noise(int count)
  {
    Random random(17);
    for (int e = 0; e < count; ++e)
    {
      const Shape shape = kShapes[static_cast<std::size_t>(e) % std::size(kShapes)];
      mesh.Add(UniformSpace(shape, 1), [](const LongVec3& xi) { return xi; });
      const double offset = random(-10.0, 10.0);
      values.Add(UniformSpace(shape, 3),
        [&](const LongVec3& /*xi*/, long double* value) { *value = offset; });
      const auto first = static_cast<std::size_t>(values.Offset.back());
      for (std::size_t i = first; i < values.Coefficients.size(); ++i)
      {
        values.Coefficients[i] += 0.3 * random();
      }
    }
    field.name = "noise";
    field.values = values.View();
  }

  MeshBuilder mesh;
  ExpansionBuilder values{ 1 };
  Field field;
};
} // namespace

TEST(ValueIndex, LeavesOutNoElementThatTakesAValue)
{
  Noise noise(200);
  const Mesh mesh = noise.mesh.View();
  const ValueIndex index(mesh, { Quantity::Component, &noise.field });
  Random random(18);
  std::vector<int> found;
  std::size_t most = 0;
  for (int i = 0; i < 400; ++i)
  {
    const int element = static_cast<int>(random(0.0, 199.9));
    const Vec3 xi = random.Inside(mesh.ShapeOf(element));
    const auto exact = EvaluateQuad(noise.field.values, element, { xi.x, xi.y, xi.z })[0].value;
    const auto value = static_cast<double>(exact);
    index.Find({ std::nextafter(value, -INFINITY), std::nextafter(value, INFINITY) }, found);
    EXPECT_TRUE(std::ranges::is_sorted(found));
    EXPECT_TRUE(std::ranges::binary_search(found, element)) << i;
    most = std::max(most, found.size());
    EXPECT_TRUE(index.Range().Contains(value));
  }
  // Values lie between -10 and 10, and each element takes a few of them.
  EXPECT_LT(most, 60U);
  index.Find(Interval(100.0), found);
  EXPECT_TRUE(found.empty());
  index.Find(Interval(std::numeric_limits<double>::quiet_NaN()), found);
  EXPECT_TRUE(found.empty());
}

TEST(ValueIndex, OfWhatIsNotFiniteNothingIsSaid)
{
  Noise noise(8);
  noise.values.Coefficients[static_cast<std::size_t>(noise.values.Offset[5])] =
    std::numeric_limits<double>::quiet_NaN();
  noise.field.values = noise.values.View();
  const ValueIndex index(noise.mesh.View(), { Quantity::Component, &noise.field });
  std::vector<int> found;
  index.Find(Interval(1e6), found);
  EXPECT_EQ(found, std::vector<int>{ 5 });
}

TEST(ValueIndex, RefusesWhatHasNoAnswer)
{
  Noise noise(4);
  noise.field.mapping = Mapping::Covariant;
  const RangeQuestion gradient{ Quantity::GradientMagnitude, &noise.field };
  EXPECT_THROW(ValueIndex(noise.mesh.View(), gradient), Unsupported);
}
} // namespace pixelexact::testing
