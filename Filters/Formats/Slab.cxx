// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Slab.h"

#include "Core/Base/Error.h"
#include "Core/Basis/ChangeOfBasis.h"
#include "Core/Shape/ShapeFace.h"
#include "Formats/ElementBasis.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

namespace pixelexact
{
namespace
{
/// The thickness is 2^-kThinner of the power of two below the shorter side.
constexpr int kThinner = 5;

/// The thickness of a surface's solids, in units of their elements. Curved surfaces may allow
/// little more; in thinner solids chords between pixels leave the solid sooner, and contours take
/// longer.
constexpr double kShellThickness = 1.0 / 16.0;
/// Rounding makes the parallelogram of derivatives smaller than this, in units of the element.
constexpr double kMinArea = 1e-14;
/// The largest order of the polynomial that stands for a surface's normal.
constexpr int kNormalOrder = 3;

/// The direction of xi that leads across a slab, as that of eta does.
std::size_t Across(Shape shape)
{
  return static_cast<std::size_t>(AcrossSlab(shape));
}

/// The directions of xi in the plane, which are x and y there.
std::array<std::size_t, 2> Along(Shape shape)
{
  return shape == Shape::Prism ? std::array<std::size_t, 2>{ 0, 2 }
                               : std::array<std::size_t, 2>{ 0, 1 };
}

/// The points at which the normal of a surface is sampled: derivatives of a map's modes there along
/// both directions in the plane, and the modes of the polynomial through samples.
struct NormalSamples
{
  std::array<std::vector<double>, 2> slopes; ///< point by point
  ChangeOfBasis change;
};

NormalSamples SamplesOf(const Space& plane, const Space& space)
{
  const auto points = UnisolventPoints(space);
  const auto modes = static_cast<std::size_t>(plane.Modes());
  NormalSamples samples{ {},
    ChangeOfBasis::FromFunctions(space, static_cast<int>(points.size()), Cardinal(space, points)) };
  // Any direction near the normal will do, so differences are good enough.
  constexpr long double kStep = 1e-4L;
  std::vector<long double> before(modes);
  std::vector<long double> behind(modes);
  for (std::size_t d = 0; d < 2; ++d)
  {
    const std::size_t direction = Along(plane.shape)[d];
    samples.slopes[d].reserve(points.size() * modes);
    for (const LongVec3& point : points)
    {
      LongVec3 xi = point;
      xi[direction] -= kStep;
      EvaluateModes(plane, xi, before.data());
      xi[direction] += 2 * kStep;
      EvaluateModes(plane, xi, behind.data());
      for (std::size_t m = 0; m < modes; ++m)
      {
        samples.slopes[d].push_back(static_cast<double>((behind[m] - before[m]) / (2 * kStep)));
      }
    }
  }
  return samples;
}

/// The same, made once for each pair of spaces.
const NormalSamples& KnownSamples(const Space& plane, const Space& space)
{
  static std::mutex mutex;
  static std::map<std::pair<Space, Space>, NormalSamples> known;
  const std::scoped_lock lock(mutex);
  const std::pair key(plane, space);
  const auto found = known.find(key);
  return found != known.end() ? found->second
                              : known.emplace(key, SamplesOf(plane, space)).first->second;
}

/// The modes, in `space`, of the polynomial through the unit normals of a surface.
std::vector<double> NormalModes(
  const Space& plane, std::span<const double> modes, const Space& space)
{
  const NormalSamples& samples = KnownSamples(plane, space);
  const auto count = static_cast<std::size_t>(samples.change.SourceSize());
  const auto planeModes = static_cast<std::size_t>(plane.Modes());
  std::vector<double> normals(3 * count);
  for (std::size_t i = 0; i < count; ++i)
  {
    std::array<Vec3, 2> along{ Vec3(0.0), Vec3(0.0) };
    for (std::size_t d = 0; d < 2; ++d)
    {
      for (std::size_t m = 0; m < planeModes; ++m)
      {
        along[d] += samples.slopes[d][i * planeModes + m] *
          Vec3(modes[m], modes[planeModes + m], modes[2 * planeModes + m]);
      }
    }
    const Vec3 normal = glm::cross(along[0], along[1]);
    const double length = glm::length(normal);
    if (!(length > kMinArea))
    {
      throw InvalidData("has no area, or an edge without length; repair it or take it out.");
    }
    normals[i] = normal.x / length;
    normals[count + i] = normal.y / length;
    normals[2 * count + i] = normal.z / length;
  }
  std::vector<double> result(3 * static_cast<std::size_t>(space.Modes()));
  ChangeOfBasis::Scratch scratch;
  samples.change.Apply(normals, std::array<double, 3>{}, result, scratch);
  return result;
}
} // namespace

const char* PlaneName(Shape solid)
{
  return solid == Shape::Prism ? "triangle" : "quadrilateral";
}

Slab MakeSlab(const Vec3& low, const Vec3& high, double roundings)
{
  const double largest = std::max({ std::fabs(low.x), std::fabs(low.y), std::fabs(low.z),
    std::fabs(high.x), std::fabs(high.y), std::fabs(high.z) });
  if (high.z - low.z > roundings * largest)
  {
    return { .middle = 0.0, .thickness = kShellThickness, .inSpace = true };
  }
  const auto [shorter, longer] = std::minmax({ high.x - low.x, high.y - low.y });
  const double side = shorter > 0.0 ? shorter : longer;
  Slab slab;
  slab.middle = low.z + (high.z - low.z) / 2;
  if (std::isnormal(side))
  {
    slab.thickness = std::ldexp(1.0, std::ilogb(side) - kThinner);
  }
  if (std::fabs(slab.middle) <= roundings * slab.thickness)
  {
    slab.middle = 0.0; // files hold 1e-310 where they mean 0
  }
  return slab;
}

void RequirePlane(const Slab& slab, const std::string& what)
{
  if (slab.inSpace)
  {
    throw Unsupported(what +
      " are read in a plane z = const only, and the mesh is a surface in space; leave them out, or "
      "move the mesh to such a plane");
  }
}

Space Lifted(const Space& plane)
{
  Space space = plane;
  space.order[Across(plane.shape)] = 1;
  return space;
}

Space PlaneOf(const Space& solid)
{
  Space space = solid;
  space.order[Across(solid.shape)] = 0;
  return space;
}

void LiftMap(const Space& plane, std::span<const double> modes, double middle, double half,
  std::span<double> lifted)
{
  const Space space = Lifted(plane);
  const auto count = static_cast<std::size_t>(space.Modes());
  const std::size_t across = Across(plane.shape);
  std::ranges::fill(lifted, 0.0);
  std::size_t planar = 0;
  ForEachMode(space,
    [&](int p, int q, int r, int mode)
    {
      const std::array<int, 3> order{ p, q, r };
      const auto at = static_cast<std::size_t>(mode);
      if (order[across] == 0)
      {
        lifted[at] = modes[planar];
        lifted[count + at] = modes[modes.size() / 2 + planar];
        lifted[2 * count + at] = p + r + q == 0 ? middle : 0.0;
        ++planar;
      }
      else if (p + q + r == 1)
      {
        // A prism's (xi1, xi3) is x and y: xi2 runs downwards, for the sign of the determinant.
        lifted[2 * count + at] = plane.shape == Shape::Prism ? -half : half;
      }
    });
}

void LiftSurface(const Space& plane, const Space& needed, std::span<const double> modes,
  double thickness, std::span<double> lifted)
{
  Space space = needed;
  for (const std::size_t d : Along(plane.shape))
  {
    space.order[d] = std::min<std::uint8_t>(space.order[d], kNormalOrder);
  }
  const std::vector<double> normals = NormalModes(plane, modes, space);
  const auto normalModes = static_cast<std::size_t>(space.Modes());
  std::map<std::array<int, 3>, std::size_t> ofNormal;
  ForEachMode(space, [&](int p, int q, int r, int mode) { ofNormal[{ p, q, r }] = mode; });
  const Space solid = Lifted(plane);
  const auto count = static_cast<std::size_t>(solid.Modes());
  const std::size_t across = Across(plane.shape);
  const std::size_t planeModes = modes.size() / 3;
  std::size_t planar = 0;
  ForEachMode(solid,
    [&](int p, int q, int r, int mode)
    {
      std::array<int, 3> order{ p, q, r };
      const bool isAcross = order[across] == 1;
      order[across] = 0;
      const auto normal = ofNormal.find(order);
      // A prism's xi2 runs downwards, for the sign of the determinant.
      const double half = (isAcross && plane.shape == Shape::Prism ? -0.5 : 0.5) * thickness;
      for (std::size_t c = 0; c < 3; ++c)
      {
        const double along =
          normal == ofNormal.end() ? 0.0 : half * normals[c * normalModes + normal->second];
        lifted[c * count + static_cast<std::size_t>(mode)] =
          isAcross ? along : modes[c * planeModes + planar] - along;
      }
      planar += isAcross ? 0 : 1;
    });
}

std::vector<double> SurfaceModes(const Space& solid, std::span<const double> map)
{
  const std::size_t across = Across(solid.shape);
  const bool isUpper = FacesOf(solid.shape)[static_cast<std::size_t>(ShellFace(solid.shape))].upper;
  const Space plane = PlaneOf(solid);
  const auto planeModes = static_cast<std::size_t>(plane.Modes());
  const auto count = static_cast<std::size_t>(solid.Modes());
  std::map<std::array<int, 3>, std::size_t> ofPlane;
  ForEachMode(plane,
    [&](int p, int q, int r, int mode) {
      ofPlane[{ p, q, r }] = static_cast<std::size_t>(mode);
    });
  std::vector<double> modes(3 * planeModes, 0.0);
  ForEachMode(solid,
    [&](int p, int q, int r, int mode)
    {
      std::array<int, 3> order{ p, q, r };
      const double sign = order[across] == 1 && !isUpper ? -1.0 : 1.0;
      order[across] = 0;
      for (std::size_t c = 0; c < 3; ++c)
      {
        modes[c * planeModes + ofPlane.at(order)] +=
          sign * map[c * count + static_cast<std::size_t>(mode)];
      }
    });
  return modes;
}

void LiftAgain(const Slab& slab, std::span<const std::int64_t> numbers, OwnedExpansion& map)
{
  for (std::size_t e = 0; slab.inSpace && e < numbers.size(); ++e)
  {
    try
    {
      const Space plane = PlaneOf(map.SpaceOf(e));
      const auto coefficients = map.Coefficients(e);
      LiftSurface(
        plane, plane, SurfaceModes(map.SpaceOf(e), coefficients), slab.thickness, coefficients);
    }
    catch (const InvalidData& error)
    {
      throw InvalidData(
        "element " + std::to_string(numbers[e]) + ", once it is moved, " + error.what());
    }
  }
}
} // namespace pixelexact
