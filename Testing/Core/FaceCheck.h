// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "LongMap.h"

#include "Core/Basis/ModeBound.h"
#include "Core/Location/Sample.h"
#include "Core/Math/Mat.h"
#include "Core/Math/Rounding.h"

#include <glm/matrix.hpp>
#include <tbb/parallel_for.h>

#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>

// Checks that elements found for points on and near faces of a mesh contain them.
namespace pixelexact::testing
{
/// Points of one kind on one mesh: $PIXELEXACT_FACE_POINTS, by default few enough for every run.
inline int FacePointCount(int usual)
{
  const char* asked = std::getenv("PIXELEXACT_FACE_POINTS");
  return asked != nullptr ? std::max(1, std::atoi(asked)) : usual;
}

struct FaceReport
{
  std::int64_t points = 0;
  std::int64_t inside = 0;
  std::int64_t outside = 0;
  std::int64_t unknown = 0;
  std::int64_t wrong = 0;   ///< inside of an element that does not hold them
  std::int64_t careful = 0; ///< (point, element) pairs that needed the careful path
  double beyond = 0.0;      ///< largest distance past a face, in tolerances of that face
  std::string first;        ///< the first wrong or unknown point

  FaceReport& operator+=(const FaceReport& part)
  {
    points += part.points;
    inside += part.inside;
    outside += part.outside;
    unknown += part.unknown;
    wrong += part.wrong;
    careful += part.careful;
    beyond = std::max(beyond, part.beyond);
    first = first.empty() ? part.first : first;
    return *this;
  }

  void Print(const std::string& name) const
  {
    std::printf("[ measured ] %-44s %8lld points: %8lld inside, %8lld outside, %lld unknown, "
                "%lld wrong; %lld careful pairs; %.2f tolerances\n",
      name.c_str(), static_cast<long long>(points), static_cast<long long>(inside),
      static_cast<long long>(outside), static_cast<long long>(unknown),
      static_cast<long long>(wrong), static_cast<long long>(careful), beyond);
  }
};

/// The position of a xi: in the shape, outside by at most the faces' tolerance, or further outside.
enum class Side
{
  Inside,
  AtFace,
  Beyond
};

/// A face of a shape: offset + normal . xi >= 0 in the shape.
struct BoundingPlane
{
  std::array<int, 3> normal;
  int offset;
};

/// architecture.md's table of shapes.
inline std::vector<BoundingPlane> BoundingPlanesOf(Shape shape)
{
  std::vector<BoundingPlane> faces{ { { 1, 0, 0 }, 1 }, { { 0, 1, 0 }, 1 }, { { 0, 0, 1 }, 1 } };
  const auto add = [&faces](const std::vector<BoundingPlane>& further)
  { faces.insert(faces.end(), further.begin(), further.end()); };
  switch (shape)
  {
    case Shape::Hexahedron:
      add({ { { -1, 0, 0 }, 1 }, { { 0, -1, 0 }, 1 }, { { 0, 0, -1 }, 1 } });
      break;
    case Shape::Prism:
      add({ { { 0, -1, 0 }, 1 }, { { -1, 0, -1 }, 0 } });
      break;
    case Shape::Tetrahedron:
      add({ { { -1, -1, -1 }, -1 } });
      break;
    default:
      add({ { { -1, 0, -1 }, 0 }, { { 0, -1, -1 }, 0 } });
  }
  return faces;
}

/// Whether x = Phi(xi) and xi lies in the shape, each as far as rounding and the documented
/// tolerance at faces (element-tree.md) allow. Made from the stored coefficients and the formulas,
/// in long double where it matters; nothing of it is what the locator has computed.
class FaceOracle
{
public:
  explicit FaceOracle(const Mesh& mesh)
    : mesh_(mesh)
    , Map(mesh)
  {
  }

  [[nodiscard]] bool Holds(int element, const Vec3& xi, const Vec3& x)
  {
    const Shape shape = mesh_.ShapeOf(element);
    const Vec3 uncertainty = Uncertainty(element);
    // At a pyramid's apex the Jacobian depends on the direction of approach. There the tolerance is
    // compared with the image of the nearest point of the pyramid, because its rational functions
    // have no continuation beyond the apex.
    if (shape == Shape::Pyramid && 1.0 - xi.z < kNearApex)
    {
      return IsImage(element, IntoPyramid(xi), x, 6.0 * uncertainty);
    }
    const Mat3 jacobian = Jacobian(element, ToLong(xi));
    Vec3 rounding = 2.0 * uncertainty;
    for (int d = 0; d < 3; ++d)
    {
      for (int j = 0; j < 3; ++j)
      {
        rounding[d] += 2.0 * kUnitRoundoff * std::fabs(jacobian[j][d]);
      }
    }
    return IsImage(element, xi, x, rounding) && SideOf(element, ToLong(xi)) != Side::Beyond;
  }

  /// Must not be called for a xi near a pyramid's apex.
  [[nodiscard]] Side SideOf(int element, const LongVec3& xi)
  {
    const Vec3 uncertainty = Uncertainty(element);
    const Mat3 inverse = glm::inverse(Jacobian(element, xi));
    Vec3 tolerance(0.0);
    for (int d = 0; d < 3; ++d)
    {
      for (int j = 0; j < 3; ++j)
      {
        tolerance[d] += std::fabs(inverse[j][d]) * uncertainty[j];
      }
    }
    Side side = Side::Inside;
    for (const BoundingPlane& face : BoundingPlanesOf(mesh_.ShapeOf(element)))
    {
      long double distance = face.offset;
      double inDistance = 0.0;
      for (int d = 0; d < 3; ++d)
      {
        distance += face.normal[d] * xi[d];
        inDistance += std::abs(face.normal[d]) * tolerance[d];
      }
      // Its own rounding on top; the tolerance itself is known to the last Newton step.
      const double allowed = 1.001 * inDistance + 4.0 * kUnitRoundoff;
      if (distance < 0.0L)
      {
        beyond = std::max(beyond, static_cast<double>(-distance) / allowed);
        side = std::max(side, distance < -allowed ? Side::Beyond : Side::AtFace);
      }
    }
    return side;
  }

  /// The largest distance past a face so far, in that face's tolerances.
  double beyond = 0.0;

private:
  static constexpr double kNearApex = 1e-6;

  /// Whether Phi(xi) is x up to `error`, in the element's units.
  [[nodiscard]] bool IsImage(int element, const Vec3& xi, const Vec3& x, const Vec3& error)
  {
    const LongVec3 image = Map(element, ToLong(xi));
    const double size = mesh_.size[element];
    bool close = true;
    for (int d = 0; d < 3; ++d)
    {
      // Written so that a NaN is not close.
      close = close && std::fabs(static_cast<double>(image[d] - x[d])) <= error[d] * size;
    }
    return close;
  }

  static Vec3 IntoPyramid(const Vec3& xi)
  {
    const double z = std::clamp(xi.z, -1.0, 1.0);
    return { std::clamp(xi.x, -1.0, -z), std::clamp(xi.y, -1.0, -z), z };
  }

  /// u_j of element-tree.md, in the element's units.
  [[nodiscard]] Vec3 Uncertainty(int element) const
  {
    const Space& space = mesh_.map.SpaceOf(element);
    const double size = mesh_.size[element];
    const double gamma = Gamma(4 * (space.order[0] + space.order[1] + space.order[2]) + 16);
    const double* coefficient = mesh_.map.Coefficients(element);
    Vec3 u;
    for (int d = 0; d < 3; ++d)
    {
      double sum = 0.0;
      ForEachMode(space,
        [&](int p, int q, int r, int /*mode*/)
        { sum += std::fabs(*coefficient++) * ModeBound(space, p, q, r); });
      // The largest |x_d| is no larger.
      const double largest =
        std::fabs(mesh_.centre[3 * static_cast<std::size_t>(element) + d]) + sum * size;
      u[d] = (mesh_.uncertainty[element] + 4.0 * kUnitRoundoff * largest) / size + gamma * sum;
    }
    return u;
  }

  /// dPhi / dxi in the element's units.
  [[nodiscard]] Mat3 Jacobian(int element, const LongVec3& xi)
  {
    const auto columns = Map.Columns(element, xi, Map(element, xi));
    Mat3 jacobian;
    for (int j = 0; j < 3; ++j)
    {
      jacobian[j] = ToDouble(columns[j]) / mesh_.size[element];
    }
    return jacobian;
  }

  Mesh mesh_;
  LongMap Map;
};

/// Locates the points and holds each answer against the oracle. `verdicts` may be empty.
inline FaceReport CheckPoints(
  const Locator& locator, std::span<const Vec3> points, std::span<Verdict> verdicts = {})
{
  FaceReport report;
  report.points = static_cast<std::int64_t>(points.size());
  const auto before = locator.Counters().careful.load();
  std::vector<std::int32_t> element(points.size());
  std::vector<Vec3> xi(points.size());
  std::vector<Verdict> own(verdicts.empty() ? points.size() : 0);
  const std::span<Verdict> verdict = verdicts.empty() ? std::span(own) : verdicts;
  SampleTarget target;
  target.element = element;
  target.xi = xi;
  target.verdict = verdict;
  Sample(locator, nullptr, points, target);
  report.careful = locator.Counters().careful - before;
  std::mutex mutex;
  constexpr std::size_t kRun = 1000;
  tbb::parallel_for(std::size_t(0), (points.size() + kRun - 1) / kRun,
    [&](std::size_t run)
    {
      FaceOracle oracle(locator.GetMesh());
      FaceReport part;
      for (std::size_t i = run * kRun; i < std::min((run + 1) * kRun, points.size()); ++i)
      {
        part.outside += verdict[i] == Verdict::Outside ? 1 : 0;
        part.inside += verdict[i] == Verdict::Inside ? 1 : 0;
        part.unknown += verdict[i] == Verdict::Unknown ? 1 : 0;
        const bool wrong =
          verdict[i] == Verdict::Inside && !oracle.Holds(element[i], xi[i], points[i]);
        part.wrong += wrong ? 1 : 0;
        if ((wrong || verdict[i] == Verdict::Unknown) && part.first.empty())
        {
          char text[300];
          std::snprintf(text, sizeof(text), "%s at %a %a %a: element %d, xi %a %a %a",
            Name(verdict[i]), points[i].x, points[i].y, points[i].z, element[i], xi[i].x, xi[i].y,
            xi[i].z);
          part.first = text;
        }
      }
      part.beyond = oracle.beyond;
      const std::scoped_lock lock(mutex);
      report += part;
    });
  return report;
}

/// A number in [-1, 1): one in eight is a multiple of 1/4, where hanging nodes and vertices are.
inline double Coordinate(Random& random)
{
  const double u = random();
  return random() < -0.75 ? std::floor(4.0 * u) / 4.0 : u;
}

/// Moves one to three coordinates of a point of the cube to -1 or 1: to a face, an edge, a corner.
/// Returns which, as bits.
inline int ToBoundary(Random& random, Vec3& eta)
{
  const double kind = random();
  const int count = kind < 0.2 ? 1 : kind < 0.7 ? 2 : 3;
  int moved = 0;
  while (__builtin_popcount(static_cast<unsigned>(moved)) < count)
  {
    const auto axis = static_cast<int>(random(0.0, 3.0));
    eta[axis] = random() < 0.0 ? -1.0 : 1.0;
    moved |= 1 << axis;
  }
  return moved;
}

/// As TensorToReference.
inline LongVec3 LongReference(Shape shape, const LongVec3& eta)
{
  const auto [a, b, c] = eta;
  const auto collapse = [](long double u, long double v) { return (1 + u) * (1 - v) / 2 - 1; };
  switch (shape)
  {
    case Shape::Hexahedron:
      return eta;
    case Shape::Prism:
      return { collapse(a, c), b, c };
    case Shape::Tetrahedron:
      return { (1 + a) * (1 - b) * (1 - c) / 4 - 1, collapse(b, c), c };
    default:
      return { collapse(a, c), collapse(b, c), c };
  }
}

/// A xi on a face, an edge or a vertex of a shape.
inline LongVec3 OnBoundary(Random& random, Shape shape)
{
  Vec3 eta(Coordinate(random), Coordinate(random), Coordinate(random));
  ToBoundary(random, eta);
  return LongReference(shape, ToLong(eta));
}

/// 10^-16 to 10^-6, every decade alike.
inline long double SmallDistance(Random& random)
{
  return std::pow(10.0L, static_cast<long double>(random(-16.0, -6.0)));
}
} // namespace pixelexact::testing
