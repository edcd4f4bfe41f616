// SPDX-License-Identifier: BSD-3-Clause
// What the trees' boxes claim of the map, against long double: hulls, frames, planes and what is
// held, down to small boxes, of low orders and of those that begin with coarse boxes.
#include "LongMap.h"

#include "Core/Index/ElementIndex.h"
#include "Core/Tree/Regularity.h"
#include "Core/Tree/TreeKernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

namespace pixelexact::testing
{
namespace
{
/// A map of first order and noise, whose modes fall off slowly.
MeshBuilder Element(Shape shape, int order, double noise, Random& random)
{
  MeshBuilder mesh;
  mesh.Add(UniformSpace(shape, 1),
    [](const LongVec3& xi) -> LongVec3 {
      return { xi[0] + 0.1L * xi[1], xi[1] - 0.2L * xi[2], xi[2] + 0.05L * xi[0] };
    });
  const ExpansionBuilder low = mesh.Phi;
  const Space& space = mesh.Phi.Spaces[0] = UniformSpace(shape, order);
  const auto modes = static_cast<std::size_t>(space.Modes());
  const auto lowModes = static_cast<std::size_t>(low.Spaces[0].Modes());
  mesh.Phi.Coefficients.assign(3 * modes, 0.0);
  for (std::size_t c = 0; c < 3; ++c)
  {
    std::map<std::array<int, 3>, double> first;
    ForEachMode(low.Spaces[0],
      [&](int p, int q, int r, int mode) {
        first[{ p, q, r }] = low.Coefficients[c * lowModes + static_cast<std::size_t>(mode)];
      });
    ForEachMode(space,
      [&](int p, int q, int r, int mode)
      {
        const auto found = first.find({ p, q, r });
        mesh.Phi.Coefficients[c * modes + static_cast<std::size_t>(mode)] =
          (found == first.end() ? 0.0 : found->second) +
          noise * random() * std::pow(0.7, p + q + r) * (shape == Shape::Pyramid ? 0.1 : 1.0);
      });
  }
  return mesh;
}

class Boxes
{
public:
  explicit Boxes(const Mesh& mesh, bool injective = false)
    : mesh_(mesh)
    , Index(mesh)
    , Map(mesh)
    , Injective(injective)
  {
  }

  /// Descends to a random box of `depth` subdivisions.
  void Walk(int depth, Random& random)
  {
    const auto tree = Index.TreeOf(0);
    const auto& pieces = tree->Pieces();
    auto* node =
      pieces[static_cast<std::size_t>(random(0.0, 0.999) * static_cast<double>(pieces.size()))]
        .get();
    Check(*node, random);
    for (int i = 0; i < depth && tree->Split(*node); ++i)
    {
      // Together the box.
      const EtaBox& whole = node->Frame().box;
      EXPECT_EQ(node->Child(0).Frame().box.lower, whole.lower);
      EXPECT_EQ(node->Child(1).Frame().box.upper, whole.upper);
      node = &node->Child(random() < 0.0 ? 0 : 1);
      Check(*node, random);
    }
    LastSlack = node->Frame().slack[0];
  }

  std::size_t Pieces() { return Index.TreeOf(0)->Pieces().size(); }

  double LastSlack = 0.0;
  int InjectiveBoxes = 0;

private:
  void Check(const ElementTree::Node& node, Random& random)
  {
    const NodeFrame& frame = node.Frame();
    double lanes[3][kGroupPoints];
    for (int k = 0; k < kGroupPoints; ++k)
    {
      Vec3 eta;
      for (int d = 0; d < 3; ++d)
      {
        const double part = std::clamp(random(-0.3, 1.3), 0.0, 1.0);
        eta[d] = frame.box.lower[d] + part * (frame.box.upper[d] - frame.box.lower[d]);
      }
      const Vec3 xi = TensorToReference(mesh_.ShapeOf(0), eta);
      const LongVec3 x = Map(0, ToLong(xi));
      const Vec3 root = frame.Root(ToDouble(x));
      for (int d = 0; d < 3; ++d)
      {
        lanes[d][k] = static_cast<double>(x[d]);
        const auto& deviation = frame.deviation[static_cast<std::size_t>(d)];
        EXPECT_TRUE(!frame.framed ||
          (root[d] - xi[d] >= deviation.lower && root[d] - xi[d] <= deviation.upper));
      }
    }
    const double* const y[3] = { lanes[0], lanes[1], lanes[2] };
    const std::uint64_t all = ~std::uint64_t{ 0 };
    EXPECT_EQ(GetTreeKernels().classify(frame, y, all).near, all);
    EXPECT_EQ(GetTreeKernels().classifyWidely(frame, y, all).near, all);
    if (Injective)
    {
      CheckHeld(frame, random);
    }
    if (frame.injective)
    {
      ++InjectiveBoxes;
      CheckInjective(node, random);
    }
  }

  /// M J is strictly diagonally dominant for one M: det J has one sign, also in the box's reach.
  void CheckInjective(const ElementTree::Node& node, Random& random)
  {
    const EtaBox& box = node.Frame().box;
    const double reach = ReachOf(mesh_.map.SpaceOf(0).TensorDegree());
    const long double step = 1e-7L;
    int positive = 0;
    constexpr int kPoints = 8;
    for (int k = 0; k < kPoints; ++k)
    {
      Vec3 xi;
      for (int d = 0; d < 3; ++d)
      {
        const double part = random(-reach, 1.0 + reach);
        xi[d] = box.lower[d] + part * (box.upper[d] - box.lower[d]);
      }
      std::array<LongVec3, 3> column;
      for (std::size_t d = 0; d < 3; ++d)
      {
        LongVec3 from = ToLong(xi);
        LongVec3 to = from;
        from[d] -= step;
        to[d] += step;
        const LongVec3 begin = Map(0, from);
        const LongVec3 end = Map(0, to);
        for (std::size_t c = 0; c < 3; ++c)
        {
          column[d][c] = end[c] - begin[c];
        }
      }
      const auto& [u, v, w] = column;
      positive += u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
          u[2] * (v[0] * w[1] - v[1] * w[0]) >
        0.0L;
    }
    EXPECT_TRUE(positive == 0 || positive == kPoints);
  }

  /// For an injective map, points outside of the box have images that are not among the values over
  /// it.
  void CheckHeld(const NodeFrame& frame, Random& random)
  {
    double lanes[3][kGroupPoints];
    for (int k = 0; k < kGroupPoints; ++k)
    {
      Vec3 eta;
      for (int d = 0; d < 3; ++d)
      {
        const double width = frame.box.upper[d] - frame.box.lower[d];
        eta[d] =
          std::clamp(random(frame.box.lower[d] - width, frame.box.upper[d] + width), -1.0, 1.0);
      }
      // The distance exceeds rounding, and is not along a collapsed direction of eta.
      const int d = k % 3;
      const double apart = 1e-9 + random(0.0, 0.1);
      eta[d] =
        frame.box.upper[d] + apart < 1.0 ? frame.box.upper[d] + apart : frame.box.lower[d] - apart;
      const bool within = eta[d] >= -1.0 && eta[2] < 0.999;
      const LongVec3 x = Map(0, ToLong(TensorToReference(mesh_.ShapeOf(0), eta)));
      for (int c = 0; c < 3; ++c)
      {
        lanes[c][k] = within ? static_cast<double>(x[c]) : 1e9;
      }
    }
    const double* const y[3] = { lanes[0], lanes[1], lanes[2] };
    const std::uint64_t all = ~std::uint64_t{ 0 };
    EXPECT_EQ(GetTreeKernels().classify(frame, y, all).held, 0U);
  }

  Mesh mesh_;
  ElementIndex Index;
  LongMap Map;
  bool Injective;
};
} // namespace

TEST(ElementTree, NoBoxLosesAValueOfIts)
{
  Random random(2);
  for (const Shape shape : kShapes)
  {
    for (const int order : { 1, 3, 7, 13, 17 })
    {
      for (const double noise : { 1e-3, 0.2 })
      {
        SCOPED_TRACE(std::string(Name(shape)) + " of order " + std::to_string(order));
        const MeshBuilder mesh = Element(shape, order, noise, random);
        Boxes boxes(mesh.View(), noise < 0.01);
        for (int i = 0; i < (order < 10 ? 8 : 2); ++i)
        {
          boxes.Walk(12, random);
        }
      }
    }
  }
}

TEST(ElementTree, HighOrdersBeginWithFewBoxesAndEndWithPreciseOnes)
{
  Random random(3);
  const MeshBuilder mesh = Element(Shape::Hexahedron, 20, 0.2, random);
  Boxes boxes(mesh.View());
  EXPECT_EQ(boxes.Pieces(), 1U);
  // Three subdivisions lead to boxes whose rounding is as small as the map's own.
  boxes.Walk(2, random);
  const double coarse = boxes.LastSlack;
  boxes.Walk(3, random);
  EXPECT_LT(boxes.LastSlack, 1e-2 * coarse);
}

TEST(ElementTree, BoxesOfHighOrdersAreInjectiveByTheirFrames)
{
  Random random(4);
  for (const int order : { 9, 13, 20 })
  {
    SCOPED_TRACE("order " + std::to_string(order));
    const MeshBuilder mesh = Element(Shape::Hexahedron, order, 0.2, random);
    Boxes boxes(mesh.View());
    for (int i = 0; i < 3; ++i)
    {
      boxes.Walk(12, random);
    }
    EXPECT_GT(boxes.InjectiveBoxes, 3);
  }
}
} // namespace pixelexact::testing
