// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Slab.h"

#include "Core/Base/Error.h"
#include "Core/Basis/ChangeOfBasis.h"
#include "Core/Element/Kernels.h"
#include "Core/Shape/ShapeFace.h"
#include "Formats/ElementBasis.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
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
/// The largest order of the polynomial that stands for a surface's normal.
constexpr int kNormalOrder = 3;

/// The direction of xi that leads across a slab.
std::size_t Across(Shape shape)
{
  return shape == Shape::Prism ? 1 : 2;
}

/// The directions of xi in the plane, which are x and y there.
std::array<std::size_t, 2> Along(Shape shape)
{
  return shape == Shape::Prism ? std::array<std::size_t, 2>{ 0, 2 }
                               : std::array<std::size_t, 2>{ 0, 1 };
}

/// The points at which the normal of a surface is sampled, and the modes of the polynomial through
/// these samples.
struct NormalSamples
{
  std::vector<double> xi; ///< coordinate by coordinate, padded
  ChangeOfBasis change;
};

NormalSamples SamplesOf(const Space& space)
{
  const auto points = UnisolventPoints(space);
  const int count = static_cast<int>(points.size());
  const auto padded = static_cast<std::size_t>(PaddedCount(count));
  NormalSamples samples{ std::vector<double>(3 * padded),
    ChangeOfBasis::FromFunctions(space, count, Cardinal(space, points)) };
  for (std::size_t i = 0; i < padded; ++i)
  {
    for (std::size_t d = 0; d < 3; ++d)
    {
      samples.xi[d * padded + i] = static_cast<double>(points[std::min(i, points.size() - 1)][d]);
    }
  }
  return samples;
}

/// The same, made once for each space.
const NormalSamples& KnownSamples(const Space& space)
{
  static std::mutex mutex;
  static std::map<Space, NormalSamples> known;
  const std::scoped_lock lock(mutex);
  const auto found = known.find(space);
  return found != known.end() ? found->second
                              : known.emplace(space, SamplesOf(space)).first->second;
}

/// The modes, in `space`, of the polynomial through the unit normals of a surface.
std::vector<double> NormalModes(
  const Space& plane, std::span<const double> modes, const Space& space)
{
  const NormalSamples& samples = KnownSamples(space);
  const int count = samples.change.SourceSize();
  const auto padded = static_cast<std::size_t>(PaddedCount(count));
  const LanePoints xi{ { &samples.xi[0], &samples.xi[padded], &samples.xi[2 * padded] }, count };
  std::vector<double> buffer(12 * padded);
  std::array<double*, 3> value{};
  std::array<double*, 9> gradient{};
  for (std::size_t i = 0; i < 12; ++i)
  {
    (i < 3 ? value[i] : gradient[i - 3]) = &buffer[i * padded];
  }
  KernelsFor(plane).gradient(plane, modes.data(), 3, xi, value.data(), gradient.data());
  const auto [u, v] = Along(plane.shape);
  std::vector<double> normals(3 * static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    const auto along = [&](std::size_t d)
    { return Vec3(gradient[d][i], gradient[3 + d][i], gradient[6 + d][i]); };
    const Vec3 normal = glm::cross(along(u), along(v));
    const double length = glm::length(normal);
    if (!std::isnormal(length))
    {
      throw InvalidData("has no area, or an edge without length; repair it or take it out.");
    }
    for (int c = 0; c < 3; ++c)
    {
      normals[static_cast<std::size_t>(c) * static_cast<std::size_t>(count) +
        static_cast<std::size_t>(i)] = normal[c] / length;
    }
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

namespace
{
/// Lifts the surface of one map again.
void LiftOne(const Space& solid, double thickness, std::span<double> map)
{
  const std::size_t across = Across(solid.shape);
  const bool isUpper = FacesOf(solid.shape)[static_cast<std::size_t>(ShellFace(solid.shape))].upper;
  Space plane = solid;
  plane.order[across] = 0;
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
  LiftSurface(plane, plane, modes, thickness, map);
}
} // namespace

void LiftAgain(const Slab& slab, std::span<const std::int64_t> numbers, OwnedExpansion& map)
{
  for (std::size_t e = 0; slab.inSpace && e < numbers.size(); ++e)
  {
    try
    {
      LiftOne(map.SpaceOf(e), slab.thickness, map.Coefficients(e));
    }
    catch (const InvalidData& error)
    {
      throw InvalidData(
        "element " + std::to_string(numbers[e]) + ", once it is moved, " + error.what());
    }
  }
}
} // namespace pixelexact
