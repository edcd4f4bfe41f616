// SPDX-License-Identifier: BSD-3-Clause
// jump(f) on faces of curved meshes, of fields whose polynomials differ from element to element,
// so that jumps are known in closed form.
#include "CurvedMeshes.h"
#include "FaceCounts.h"
#include "LongMap.h"

#include "Core/Base/Error.h"
#include "Core/Expression/Expression.h"
#include "Core/Faces/FaceJumps.h"
#include "Core/Faces/FaceSampler.h"
#include "Core/Faces/ReferenceFace.h"
#include "Core/Location/Sample.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace pixelexact::testing
{
namespace
{
/// The polynomial of an element: of x, of total degree 2.
struct OwnPolynomial
{
  std::array<long double, 4> linear{};
  long double bilinear = 0;

  [[nodiscard]] long double operator()(const LongVec3& p) const
  {
    const auto [x, y, z] = p;
    return linear[0] + linear[1] * x + linear[2] * y + linear[3] * z + bilinear * x * y;
  }
  [[nodiscard]] LongVec3 Gradient(const LongVec3& p) const
  {
    return { linear[1] + bilinear * p[1], linear[2] + bilinear * p[0], linear[3] };
  }
};

/// `isContinuous`: all elements have the same one.
OwnPolynomial PolynomialOf(int element, bool isContinuous)
{
  const long double e = isContinuous ? 0.0L : element;
  return { { 0.5L + 0.25L * e, 1 - 0.0625L * e, 0.125L * e - 2, 0.3125L }, 0.75L + 0.03125L * e };
}

/// A mesh with the field u of these polynomials, its locator and its faces.
class JumpCase
{
public:
  explicit JumpCase(CurvedMesh mesh, bool isContinuous = false)
    : Made(std::move(mesh))
    , IsContinuous(isContinuous)
    , OfU(1)
    , Places(Made.View())
    , Table(Places.Index())
  {
    LongMap map(Made.View());
    for (int e = 0; e < View().Elements(); ++e)
    {
      OfU.Add(UniformSpace(View().ShapeOf(e), 6),
        [&](const LongVec3& xi, long double* out) { *out = Of(e)(map(e, xi)); });
    }
    Fields = { { "u", OfU.View() } };
  }

  [[nodiscard]] const Mesh& View() const { return Places.GetMesh(); }
  [[nodiscard]] const FaceTable& Faces() const { return Table; }
  [[nodiscard]] const Locator& GetLocator() const { return Places; }
  [[nodiscard]] OwnPolynomial Of(int element) const { return PolynomialOf(element, IsContinuous); }

  [[nodiscard]] const Field& U() const { return Fields.front(); }

  [[nodiscard]] Field Make(const std::string& text) const
  {
    ExpressionScope scope;
    scope.fields = Fields;
    scope.locator = [this]() -> const Locator& { return Places; };
    Field field;
    field.name = text;
    field.function = MakeExpression(text, scope);
    field.values.components = field.function->Components();
    return field;
  }

  /// `components` for each point.
  [[nodiscard]] std::vector<double> Evaluate(const std::string& text, int element,
    std::span<const Vec3> xi, std::span<const Vec3> normals = {}) const
  {
    const Field field = Make(text);
    std::vector<double> values(static_cast<std::size_t>(field.values.components) * xi.size());
    EvaluateAt(View(), field, element, xi, values, {}, { {}, normals });
    return values;
  }

  /// visit(element, face, xi, x) with points of each face.
  template <class Visit>
  void ForEachFace(const Visit& visit) const
  {
    Random random(11);
    for (int e = 0; e < View().Elements(); ++e)
    {
      const auto faces = static_cast<int>(FacesOf(View().ShapeOf(e)).size());
      for (int f = 0; f < faces; ++f)
      {
        const ReferenceFace& face = ReferenceFaceOf(View().ShapeOf(e), f);
        std::vector<Vec3> xi(5);
        std::ranges::generate(xi,
          [&] {
            return face.At({ random(0.05, 0.45), random(0.05, 0.45) });
          });
        std::vector<Vec3> x(xi.size());
        MapForward(View(), e, xi, x);
        visit(e, f, xi, x);
      }
    }
  }

private:
  CurvedMesh Made;
  bool IsContinuous;
  ExpansionBuilder OfU;
  Locator Places;
  FaceTable Table;
  std::vector<Field> Fields;
};

class Neighbours final : public PreimageSink
{
public:
  void Found(int /*index*/, const Preimage& preimage) override { All.push_back(preimage); }
  void Undecided(int /*index*/, int /*element*/) override {}
  std::vector<Preimage> All;
};

/// The largest values are some 20, gradients some 5.
constexpr double kRoundingOfJumps = 2e-12;

struct JumpMesh
{
  const char* name;
  CurvedMesh (*make)();
};

class JumpsOf : public ::testing::TestWithParam<JumpMesh>
{
};
} // namespace

TEST_P(JumpsOf, PiecewisePolynomialsAreTheirDifferences)
{
  const JumpCase one(GetParam().make());
  int interior = 0;
  int boundary = 0;
  one.ForEachFace(
    [&](int e, int f, std::span<const Vec3> xi, std::span<const Vec3> x)
    {
      const std::vector<double> jump = one.Evaluate("jump(u)", e, xi);
      const std::vector<double> slope = one.Evaluate("jump(grad(u))", e, xi);
      const std::vector<double> square = one.Evaluate("jump(u)^2 + jump(u*u)", e, xi);
      const ElementFace other = one.Faces().NeighbourOf(e, f);
      for (std::size_t i = 0; i < xi.size(); ++i)
      {
        if (one.Faces().KindOf(e, f) == FaceKind::Boundary)
        {
          EXPECT_TRUE(std::isnan(jump[i]) && std::isnan(slope[3 * i]));
          ++boundary;
        }
        if (other.element < 0)
        {
          continue;
        }
        ++interior;
        const LongVec3 at = ToLong(x[i]);
        const long double there = one.Of(other.element)(at);
        const long double here = one.Of(e)(at);
        EXPECT_NEAR(jump[i], static_cast<double>(there - here), kRoundingOfJumps);
        EXPECT_NEAR(square[i],
          static_cast<double>((there - here) * (there - here) + there * there - here * here),
          1e-10);
        const LongVec3 wanted = Minus(one.Of(other.element).Gradient(at), one.Of(e).Gradient(at));
        for (std::size_t d = 0; d < 3; ++d)
        {
          EXPECT_NEAR(slope[3 * i + d], static_cast<double>(wanted[d]), 20 * kRoundingOfJumps);
        }
      }
    });
  EXPECT_GT(interior, 50);
  EXPECT_GT(boundary, 50);
}

TEST_P(JumpsOf, ContinuousFieldsAreRounding)
{
  const JumpCase one(GetParam().make(), true);
  double largest = 0.0;
  one.ForEachFace(
    [&](int e, int /*f*/, std::span<const Vec3> xi, std::span<const Vec3> /*x*/)
    {
      for (const double jump : one.Evaluate("jump(u)", e, xi))
      {
        largest = std::max(largest, std::isnan(jump) ? 0.0 : std::fabs(jump));
      }
      for (const double jump : one.Evaluate("jump(coords)", e, xi))
      {
        EXPECT_TRUE(std::isnan(jump) || jump == 0.0);
      }
    });
  EXPECT_LT(largest, 2e-13); // values are up to 5
  std::printf("[ measured ] largest jump of a continuous field: %.2g\n", largest);
}

TEST_P(JumpsOf, TheOtherSideAreTheNegative)
{
  const JumpCase one(GetParam().make());
  int compared = 0;
  one.ForEachFace(
    [&](int e, int f, std::span<const Vec3> xi, std::span<const Vec3> x)
    {
      const std::vector<double> jump = one.Evaluate("jump(u)", e, xi);
      for (std::size_t i = 0; i < xi.size(); ++i)
      {
        Neighbours there;
        one.GetLocator().LocateAll(x.subspan(i, 1), there);
        EXPECT_EQ(std::isnan(jump[i]), one.Faces().KindOf(e, f) == FaceKind::Boundary);
        for (const Preimage& other : there.All)
        {
          if (other.element == e)
          {
            continue;
          }
          ++compared;
          const std::vector<double> back =
            one.Evaluate("jump(u)", other.element, std::span(&other.xi, 1));
          EXPECT_NEAR(back[0], -jump[i], kRoundingOfJumps) << e << " " << other.element;
        }
      }
    });
  EXPECT_GT(compared, 50);
}

TEST_P(JumpsOf, AcrossAllFacesHoldTheClosedForm)
{
  constexpr int kPlaces = 24; // along a parameter
  const JumpCase one(GetParam().make());
  const FaceJumps found = FindFaceJumps(one.GetLocator(), one.Faces(), one.U());
  EXPECT_EQ(found.notFound, 0);
  EXPECT_EQ(found.notFinite, 0);
  int proven = 0;
  double square = 0.0;
  double exactSquare = 0.0;
  for (const FaceJump& jump : found.faces)
  {
    const int e = jump.face.element;
    const ReferenceFace& face = ReferenceFaceOf(one.View().ShapeOf(e), jump.face.face);
    std::vector<FacePoint> places;
    for (int i = 0; i < kPlaces * kPlaces; ++i)
    {
      const double a = (i / kPlaces + 0.5) / kPlaces;
      const double b = (i % kPlaces + 0.5) / kPlaces;
      places.push_back({ face.corners == 3 ? a * (1.0 - b) : a, b });
    }
    FaceSampler sampler(one.View());
    std::vector<FaceSample> samples;
    sampler.Sample(e, jump.face.face, places, samples);
    const bool isWhole = one.Faces().KindOf(e, jump.face.face) == FaceKind::Interior;
    double most = 0.0;
    for (std::size_t i = 0; i < samples.size() && isWhole; ++i)
    {
      const LongVec3 at = ToLong(samples[i].x);
      const auto exact = static_cast<double>(std::fabs(one.Of(jump.neighbour)(at) - one.Of(e)(at)));
      most = std::max(most, exact);
      const double size = one.View().size[static_cast<std::size_t>(e)];
      const double shrink = face.corners == 3 ? 1.0 - places[i][1] : 1.0;
      exactSquare += exact * exact * size * size * shrink / (kPlaces * kPlaces) *
        glm::length(glm::cross(samples[i].first, samples[i].second));
    }
    square += isWhole ? jump.square : 0.0;
    EXPECT_LE(most, jump.bound);
    if (isWhole)
    {
      EXPECT_LE(most, 1.04 * jump.largest + kRoundingOfJumps);
    }
    const bool isBounded = std::isfinite(jump.bound);
    proven += isBounded ? 1 : 0;
    EXPECT_LE(isBounded ? jump.bound : 0.0, 1.04 * jump.largest + 1e-9);
    Vec3 x;
    MapForward(one.View(), e, std::span(&jump.xi, 1), std::span(&x, 1));
    const LongVec3 at = ToLong(x);
    EXPECT_NEAR(jump.largest,
      static_cast<double>(std::fabs(one.Of(jump.neighbour)(at) - one.Of(e)(at))), kRoundingOfJumps);
  }
  EXPECT_GT(proven, 10);
  EXPECT_NEAR(square, exactSquare, 5e-3 * exactSquare);
}

TEST_P(JumpsOf, AcrossAllFacesOfContinuousFieldsAreRounding)
{
  const JumpCase one(GetParam().make(), true);
  for (const FaceJump& jump : FindFaceJumps(one.GetLocator(), one.Faces(), one.U()).faces)
  {
    EXPECT_LT(jump.largest, 2e-13);
    EXPECT_LT(std::isfinite(jump.bound) ? jump.bound : 0.0, 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, JumpsOf,
  ::testing::Values(JumpMesh{ "Hexahedra", [] { return Blocks(2, kHexahedra); } },
    JumpMesh{ "Tetrahedra", [] { return Blocks(2, kTetrahedra); } },
    JumpMesh{ "Mixed", [] { return Blocks(3, kMixed); } },
    JumpMesh{ "Hanging", [] { return Hanging(kHexahedra); } }),
  [](const auto& test) { return std::string(test.param.name); });

TEST(Jump, TakesTheNormalOfTheSurface)
{
  const JumpCase one(Blocks(2, kHexahedra));
  const Vec3 xi(1.0, 0.25, -0.5);
  const Vec3 normal(0.6, 0.0, -0.8);
  const auto slopes = one.Evaluate("jump(grad(u))", 0, std::span(&xi, 1));
  const auto along =
    one.Evaluate("jump(dot(grad(u), n))", 0, std::span(&xi, 1), std::span(&normal, 1));
  EXPECT_NEAR(along[0], 0.6 * slopes[0] - 0.8 * slopes[2], 1e-12);
  EXPECT_TRUE(one.Make("jump(dot(grad(u), n))").function->NeedsNormals());
}

TEST(Jump, IsNothingInsideAndOffFaces)
{
  const JumpCase one(Blocks(2, kHexahedra));
  // More points than are evaluated together; each third one on a face.
  std::vector<Vec3> xi;
  for (int i = 0; i < 400; ++i)
  {
    const double at = -0.9 + 1.8 * i / 400;
    xi.emplace_back(i % 3 == 0 ? 1.0 : i % 3 == 1 ? 1.0 - 1e-7 : 0.3, at, -at);
  }
  const auto values = one.Evaluate("jump(u)", 0, xi);
  const auto chosen = one.Evaluate("where(jump(u) == jump(u), 7, u)", 0, xi);
  for (std::size_t i = 0; i < xi.size(); ++i)
  {
    EXPECT_EQ(std::isnan(values[i]), i % 3 != 0) << i;
    EXPECT_EQ(chosen[i] == 7.0, i % 3 == 0) << i;
    // A point's value depends only on that point.
    const auto alone = one.Evaluate("jump(u)", 0, std::span(&xi[i], 1));
    EXPECT_TRUE(values[i] == alone[0] || i % 3 != 0);
  }
  const auto isOfFunction = [&](const char* text)
  { return one.Make(text).function->NeedsNeighbours(); };
  EXPECT_TRUE(isOfFunction("1 + jump(u)"));
  EXPECT_FALSE(isOfFunction("1 + u"));
}

TEST(Jump, HasNoEnclosureAndNoDerivative)
{
  const JumpCase one(Blocks(2, kHexahedra));
  const Field field = one.Make("jump(u)");
  const Vec3 xi(1.0, 0.25, -0.5);
  Vec3 x;
  MapForward(one.View(), 0, std::span(&xi, 1), std::span(&x, 1));
  double lower = 0.0;
  double upper = 0.0;
  EncloseAt(one.View(), field, 0, std::span(&xi, 1), std::span(&x, 1), std::span(&lower, 1),
    std::span(&upper, 1));
  EXPECT_TRUE(std::isinf(lower) && std::isinf(upper));
  EXPECT_THROW(field.function->RequireGradient(), Unsupported);
  try
  {
    static_cast<void>(one.Make("1 + grad(jump(u)).x"));
    ADD_FAILURE() << "a derivative of a jump was taken";
  }
  catch (const Unsupported& error)
  {
    EXPECT_EQ(std::string(error.what()),
      "derivatives of jumps are not available; for the jump of a derivative write "
      "jump(grad(u))\n  1 + grad(jump(u)).x\n      ^");
  }
}
} // namespace pixelexact::testing
