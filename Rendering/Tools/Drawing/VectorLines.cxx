// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/VectorLines.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace pixelexact
{
namespace
{
using Path = std::vector<CanvasPoint>;

/// The part of the way between two points that a label covers, from 0 to 1; none where it covers
/// nothing.
std::optional<std::array<double, 2>> PartWithin(
  const ContourLabel& label, const CanvasPoint& from, const CanvasPoint& to)
{
  const double angle = label.angle * std::numbers::pi / 180.0;
  const std::array along{ std::cos(angle), std::sin(angle) };
  const std::array half{ 0.5 * label.size.width + ContourLabel::kGap,
    0.5 * label.size.height + ContourLabel::kGap };
  const auto inLabel = [&](const CanvasPoint& p)
  {
    const double x = p[0] - label.x;
    const double y = p[1] - label.y;
    return CanvasPoint{ x * along[0] + y * along[1], y * along[0] - x * along[1] };
  };
  const CanvasPoint a = inLabel(from);
  const CanvasPoint b = inLabel(to);
  std::array part{ 0.0, 1.0 };
  for (std::size_t d = 0; d < 2; ++d)
  {
    const double length = b[d] - a[d];
    if (length == 0.0)
    {
      part[1] = std::fabs(a[d]) > half[d] ? -1.0 : part[1];
      continue;
    }
    const double first = (-half[d] - a[d]) / length;
    const double last = (half[d] - a[d]) / length;
    part = { std::max(part[0], std::min(first, last)), std::min(part[1], std::max(first, last)) };
  }
  return part[0] < part[1] ? std::optional(part) : std::nullopt;
}

std::vector<Path> PartsBesideOne(const ContourLabel& label, const Path& line)
{
  std::vector<Path> parts(1);
  for (std::size_t k = 0; k + 1 < line.size(); ++k)
  {
    const CanvasPoint& from = line[k];
    const CanvasPoint& to = line[k + 1];
    const auto at = [&](double part) {
      return CanvasPoint{ std::lerp(from[0], to[0], part), std::lerp(from[1], to[1], part) };
    };
    const auto within = PartWithin(label, from, to);
    if (parts.back().empty() && !(within && (*within)[0] <= 0.0))
    {
      parts.back().push_back(from);
    }
    if (!within)
    {
      parts.back().push_back(to);
      continue;
    }
    if ((*within)[0] > 0.0)
    {
      parts.back().push_back(at((*within)[0]));
    }
    if (!parts.back().empty())
    {
      parts.emplace_back();
    }
    if ((*within)[1] < 1.0)
    {
      parts.back() = { at((*within)[1]), to };
    }
  }
  std::erase_if(parts, [](const Path& part) { return part.size() < 2; });
  return parts;
}
} // namespace

std::vector<Path> PartsBeside(const std::vector<ContourLabel>& labels, const Path& line)
{
  std::vector<Path> parts{ line };
  for (const ContourLabel& label : labels)
  {
    std::vector<Path> next;
    for (const Path& part : parts)
    {
      std::ranges::move(PartsBesideOne(label, part), std::back_inserter(next));
    }
    parts = std::move(next);
  }
  return parts;
}

void VectorLines::Draw(Canvas& canvas, int width, int height) const
{
  canvas.Clip(width, height);
  for (const VectorLine& line : lines)
  {
    canvas.Line(line.points, line.width, line.color);
  }
  for (const ContourLabel& label : labels)
  {
    canvas.WriteTurned(
      label.text, { label.x, label.y }, label.angle, labelSize, label.color, InkOn(label.color));
  }
  canvas.Unclip();
}
} // namespace pixelexact
