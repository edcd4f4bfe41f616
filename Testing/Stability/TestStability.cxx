// SPDX-License-Identifier: BSD-3-Clause
// The study's short form: some values of each parameter, few points, everything that is bounded
// asserted. The full form is Study.cxx.
#include "Stability/EvaluationStudy.h"
#include "Stability/LocationStudy.h"
#include "Stability/NodeStudy.h"

#include <gtest/gtest.h>

#include <sstream>

namespace pixelexact::testing
{
namespace
{
constexpr int kPoints = 32;

std::string Describe(const Row& row)
{
  std::ostringstream text;
  text << row.sweep << ", " << row.shape << ", " << row.parameter << ' ' << row.at;
  return text.str();
}
} // namespace

class LocationStability : public ::testing::TestWithParam<LocationSweep>
{
};

TEST_P(LocationStability, VerdictsAreRightAndErrorsWithinRoundingAndConditioning)
{
  std::vector<LocationCase> cases;
  GetParam().add(Extent::Short, cases);
  std::int64_t outside = 0;
  for (const LocationCase& subject : cases)
  {
    const Row row = StudyLocation(subject, kPoints, kPoints);
    SCOPED_TRACE(Describe(row));
    EXPECT_EQ(row.inside.right, kPoints);
    EXPECT_EQ(row.inside.wrong, 0);
    EXPECT_EQ(row.outside.wrong, 0);
    EXPECT_EQ(row.outside.unknown, 0);
    outside += row.outside.right;
    EXPECT_LE(row.xiOverBound, 1.0);
    EXPECT_LE(row.backwardOverBound, 1.0);
    EXPECT_LE(row.value.overBound, 1.0);
  }
  // Some cases are so small that no point is known to be outside.
  EXPECT_GT(outside, static_cast<std::int64_t>(cases.size()) * kPoints / 4);
}

INSTANTIATE_TEST_SUITE_P(Sweeps, LocationStability, ::testing::ValuesIn(LocationSweeps()),
  [](const auto& sweep) { return std::string(sweep.param.name); });

class EvaluationStability : public ::testing::TestWithParam<Coefficients>
{
};

TEST_P(EvaluationStability, ErrorsAreWithinRounding)
{
  for (const int order : { 1, 2, 3, 5, 8, 13, 20, 32 })
  {
    for (const Space& space : EvaluationSpaces(order))
    {
      const Row row = StudyEvaluation(space, GetParam(), order > 16 ? 2 : 4);
      SCOPED_TRACE(Describe(row));
      EXPECT_LE(row.value.overBound, 1.0);
      EXPECT_LE(row.gradient.overBound, 1.0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, EvaluationStability, ::testing::ValuesIn(kAllCoefficients));

TEST(NodeStability, ErrorsAreThoseOfTheRoundedValues)
{
  for (const int order : { 1, 2, 4, 8, 12, 20 })
  {
    EXPECT_LE(StudyNodes(Shape::Hexahedron, Nodes::Equispaced, order, 20).value.overBound, 1.0);
    EXPECT_LE(StudyNodes(Shape::Hexahedron, Nodes::GaussLobatto, order, 20).value.overBound, 1.0);
  }
  for (const int order : { 1, 3, 6, 9 })
  {
    EXPECT_LE(StudyNodes(Shape::Tetrahedron, Nodes::Equispaced, order, 20).value.overBound, 1.0);
  }
}

TEST(NodeStability, GaussLobattoNodesLoseNothingAtAnyOrder)
{
  EXPECT_LE(StudyNodes(Shape::Hexahedron, Nodes::GaussLobatto, kMaxOrder, 10).value.inUlps, 1.0);
}
} // namespace pixelexact::testing
