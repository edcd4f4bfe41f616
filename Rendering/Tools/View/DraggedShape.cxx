// SPDX-License-Identifier: BSD-3-Clause
#include "View/DraggedShape.h"

#include "Base/Numbers.h"
#include "Trace/Surfaces/ConvexBody.h"
#include "Trace/Surfaces/Plane.h"
#include "Trace/Surfaces/Quadric.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Length of an arrow in parts of the diagonal of the mesh's box.
constexpr double kArrow = 0.18;
/// Smallest radius and side in parts of the same.
constexpr double kMinSize = 1e-3;
/// Squared sine of the angle to the direction of view below which an axis points at the viewer.
constexpr double kMinSine2 = 0.05;

/// The distance along an axis (unit length) by which a point follows the pointer. Where the axis
/// points at the viewer, a pointer that moves upwards moves the point away.
double Along(const HandleMove& move, const Vec3& axis)
{
  const double depth = glm::dot(axis, move.forward);
  const Vec3 seen = axis - depth * move.forward;
  const double sine2 = glm::dot(seen, seen);
  return sine2 > kMinSine2 ? glm::dot(move.by, seen) / sine2
                           : glm::dot(move.by, move.up) * (depth > 0.0 ? 1.0 : -1.0);
}

/// A unit vector across an axis, sideways on the screen.
Vec3 Sideways(const CameraView& view, const Vec3& axis)
{
  Vec3 side = glm::cross(axis, view.position - view.focalPoint);
  if (glm::length(side) < 1e-6 * glm::length(view.position - view.focalPoint))
  {
    side = glm::cross(axis, glm::cross(view.viewUp, axis));
  }
  return glm::normalize(side);
}

Vec3 RightOf(const CameraView& view)
{
  return glm::normalize(glm::cross(view.focalPoint - view.position, view.viewUp));
}

/// The option with its numbers: "--sphere=0,0,0.5,1". Roundings that dragging leaves in the first
/// three are replaced by 0; `size` is the magnitude of these.
std::string Worded(
  const char* option, const Vec3& place, double size, const std::vector<double>& more)
{
  std::vector<double> numbers{ place.x, place.y, place.z };
  for (double& number : numbers)
  {
    number = WithoutRoundings(number, size);
  }
  numbers.insert(numbers.end(), more.begin(), more.end());
  return fmt::format("{}={}", option, fmt::join(numbers, ","));
}

std::vector<double> NumbersOf(const Vec3& v)
{
  return { WithoutRoundings(v.x, 1.0), WithoutRoundings(v.y, 1.0), WithoutRoundings(v.z, 1.0) };
}

/// The edges of a box: pairs of corners that differ in one coordinate.
std::vector<std::array<Vec3, 2>> EdgesOf(const Box3& box)
{
  const auto corner = [&box](unsigned k)
  {
    return Vec3((k & 1U) != 0 ? box.upper.x : box.lower.x,
      (k & 2U) != 0 ? box.upper.y : box.lower.y, (k & 4U) != 0 ? box.upper.z : box.lower.z);
  };
  std::vector<std::array<Vec3, 2>> edges;
  edges.reserve(12);
  for (unsigned k = 0; k < 8; ++k)
  {
    for (const unsigned side : { 1U, 2U, 4U })
    {
      if ((k & side) == 0)
      {
        edges.push_back({ corner(k), corner(k | side) });
      }
    }
  }
  return edges;
}

/// The ball moves the plane along its normal, the arrow's tip turns it.
class DraggedPlane final : public DraggedShape
{
public:
  DraggedPlane(const Plane& plane, const Box3& box)
    : Normal(plane.Normal({}))
    , Box(box)
    , Size(glm::length(box.upper - box.lower))
  {
    // The ball may be anywhere in the plane, and numbers of few digits are printed.
    const double digit = std::pow(10.0, std::floor(std::log10(Size)) - 6.0);
    const Vec3 middle = digit * glm::round(0.5 * (box.lower + box.upper) / digit);
    const Vec3 off = middle - plane.Point();
    Origin = plane.Point() + (off - glm::dot(off, Normal) * Normal);
  }

  [[nodiscard]] std::vector<Vec3> Handles(const CameraView& /*view*/) const override
  {
    return { Origin, Tip() };
  }
  [[nodiscard]] std::vector<std::array<Vec3, 2>> Lines(const CameraView& /*view*/) const override
  {
    std::vector<std::array<Vec3, 2>> lines = Outline();
    lines.push_back({ Origin, Tip() });
    return lines;
  }
  void Drag(std::size_t handle, const CameraView& /*view*/, const HandleMove& move) override
  {
    if (handle == 0)
    {
      Origin += Along(move, Normal) * Normal;
      return;
    }
    const Vec3 turned = Tip() + move.by - Origin;
    Normal = glm::length(turned) > 0.0 ? glm::normalize(turned) : Normal;
  }
  [[nodiscard]] std::shared_ptr<const Surface> Now() const override
  {
    return std::make_shared<Plane>(Origin, Normal);
  }
  [[nodiscard]] std::string Word() const override
  {
    return Worded("--plane", Origin, Size, NumbersOf(Normal));
  }

private:
  [[nodiscard]] Vec3 Tip() const { return Origin + kArrow * Size * Normal; }

  /// The polygon in which the plane cuts the mesh's box.
  [[nodiscard]] std::vector<std::array<Vec3, 2>> Outline() const
  {
    std::vector<Vec3> corners;
    for (const auto& [a, b] : EdgesOf(Box))
    {
      const double from = glm::dot(a - Origin, Normal);
      const double to = glm::dot(b - Origin, Normal);
      if ((from < 0.0) != (to < 0.0))
      {
        corners.push_back(a + from / (from - to) * (b - a));
      }
    }
    Vec3 middle(0.0);
    for (const Vec3& corner : corners)
    {
      middle += corner / static_cast<double>(corners.size());
    }
    const Vec3 helper = std::fabs(Normal.x) < 0.6 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
    const Vec3 right = glm::cross(Normal, helper);
    const Vec3 up = glm::cross(Normal, right);
    std::ranges::sort(corners, {},
      [&](const Vec3& at)
      { return std::atan2(glm::dot(at - middle, up), glm::dot(at - middle, right)); });
    std::vector<std::array<Vec3, 2>> lines;
    lines.reserve(corners.size() + 1);
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
      lines.push_back({ corners[k], corners[(k + 1) % corners.size()] });
    }
    return lines;
  }

  Vec3 Origin{ 0.0 };
  Vec3 Normal;
  Box3 Box;
  double Size; ///< of the mesh
};

/// The ball in the middle moves the sphere, the one at its right changes its radius.
class DraggedSphere final : public DraggedShape
{
public:
  DraggedSphere(const std::vector<double>& numbers, double size)
    : Centre(numbers[0], numbers[1], numbers[2])
    , Radius(numbers[3])
    , MinRadius(kMinSize * size)
  {
  }
  [[nodiscard]] std::vector<Vec3> Handles(const CameraView& view) const override
  {
    return { Centre, Centre + Radius * RightOf(view) };
  }
  [[nodiscard]] std::vector<std::array<Vec3, 2>> Lines(const CameraView& view) const override
  {
    return { { Centre, Centre + Radius * RightOf(view) } };
  }
  void Drag(std::size_t handle, const CameraView& view, const HandleMove& move) override
  {
    if (handle == 0)
    {
      Centre += move.by;
      return;
    }
    Radius = std::max(MinRadius, Radius + glm::dot(move.by, RightOf(view)));
  }
  [[nodiscard]] std::shared_ptr<const Surface> Now() const override
  {
    return std::make_shared<Quadric>(MakeSphere(Centre, Radius));
  }
  [[nodiscard]] std::string Word() const override
  {
    return Worded("--sphere", Centre, Radius, { Radius });
  }

private:
  Vec3 Centre;
  double Radius;
  double MinRadius;
};

/// The ball in the middle moves the cylinder, those on the axis turn it, the one at its side
/// changes its radius.
class DraggedCylinder final : public DraggedShape
{
public:
  DraggedCylinder(const std::vector<double>& numbers, double size)
    : Centre(numbers[0], numbers[1], numbers[2])
    , Axis(glm::normalize(Vec3(numbers[3], numbers[4], numbers[5])))
    , Radius(numbers[6])
    , Size(size)
  {
  }
  [[nodiscard]] std::vector<Vec3> Handles(const CameraView& view) const override
  {
    return { Centre, Centre + kArrow * Size * Axis, Centre + Radius * Sideways(view, Axis) };
  }
  [[nodiscard]] std::vector<std::array<Vec3, 2>> Lines(const CameraView& view) const override
  {
    const std::vector<Vec3> handles = Handles(view);
    return { { handles[0], handles[1] }, { handles[0], handles[2] } };
  }
  void Drag(std::size_t handle, const CameraView& view, const HandleMove& move) override
  {
    if (handle == 0)
    {
      Centre += move.by;
    }
    else if (handle == 1)
    {
      const Vec3 turned = kArrow * Size * Axis + move.by;
      Axis = glm::length(turned) > 0.0 ? glm::normalize(turned) : Axis;
    }
    else
    {
      Radius = std::max(kMinSize * Size, Radius + glm::dot(move.by, Sideways(view, Axis)));
    }
  }
  [[nodiscard]] std::shared_ptr<const Surface> Now() const override
  {
    return std::make_shared<Quadric>(MakeCylinder(Centre, Axis, Radius));
  }
  [[nodiscard]] std::string Word() const override
  {
    std::vector<double> more = NumbersOf(Axis);
    more.push_back(Radius);
    return Worded("--cylinder", Centre, Size, more);
  }

private:
  Vec3 Centre;
  Vec3 Axis;
  double Radius;
  double Size; ///< of the mesh
};

/// The ball in the middle moves the box, those on its faces move these.
class DraggedBox final : public DraggedShape
{
public:
  DraggedBox(const std::vector<double>& numbers, double size)
    : Box{ glm::min(
             Vec3(numbers[0], numbers[1], numbers[2]), Vec3(numbers[3], numbers[4], numbers[5])),
      glm::max(Vec3(numbers[0], numbers[1], numbers[2]), Vec3(numbers[3], numbers[4], numbers[5])) }
    , Size(size)
  {
  }
  [[nodiscard]] std::vector<Vec3> Handles(const CameraView& /*view*/) const override
  {
    const Vec3 middle = 0.5 * (Box.lower + Box.upper);
    std::vector<Vec3> handles(7, middle);
    for (int d = 0; d < 3; ++d)
    {
      const auto first = 1 + 2 * static_cast<std::size_t>(d);
      handles[first][d] = Box.lower[d];
      handles[first + 1][d] = Box.upper[d];
    }
    return handles;
  }
  [[nodiscard]] std::vector<std::array<Vec3, 2>> Lines(const CameraView& /*view*/) const override
  {
    return EdgesOf(Box);
  }
  void Drag(std::size_t handle, const CameraView& /*view*/, const HandleMove& move) override
  {
    if (handle == 0)
    {
      Box.lower += move.by;
      Box.upper += move.by;
      return;
    }
    const int d = static_cast<int>(handle - 1) / 2;
    Vec3 axis(0.0);
    axis[d] = 1.0;
    const double by = Along(move, axis);
    if (handle % 2 == 1)
    {
      Box.lower[d] = std::min(Box.lower[d] + by, Box.upper[d] - kMinSize * Size);
    }
    else
    {
      Box.upper[d] = std::max(Box.upper[d] + by, Box.lower[d] + kMinSize * Size);
    }
  }
  [[nodiscard]] std::shared_ptr<const Surface> Now() const override
  {
    return std::make_shared<ConvexBody>(MakeBox(Box.lower, Box.upper));
  }
  [[nodiscard]] std::string Word() const override
  {
    return Worded("--box", Box.lower, Size,
      { WithoutRoundings(Box.upper.x, Size), WithoutRoundings(Box.upper.y, Size),
        WithoutRoundings(Box.upper.z, Size) });
  }

private:
  Box3 Box;
  double Size; ///< of the mesh
};
} // namespace

std::unique_ptr<DraggedShape> MakeDragged(
  const Surface& surface, const SurfaceOptions::Described& given, const Box3& box)
{
  const double size = glm::length(box.upper - box.lower);
  if (const auto* plane = dynamic_cast<const Plane*>(&surface))
  {
    return std::make_unique<DraggedPlane>(*plane, box);
  }
  if (given.option == "--sphere")
  {
    return std::make_unique<DraggedSphere>(given.numbers, size);
  }
  if (given.option == "--cylinder")
  {
    return std::make_unique<DraggedCylinder>(given.numbers, size);
  }
  if (given.option == "--box")
  {
    return std::make_unique<DraggedBox>(given.numbers, size);
  }
  return nullptr;
}
} // namespace pixelexact
