// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Block.h"

#include "Trace/Modules/ContourCertifier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <vector>

// Whether a field takes values on pixels' edges, by many samples in long double.
namespace pixelexact::testing
{
inline constexpr auto kOut = static_cast<std::uint8_t>(ContourVerdict::Out);
inline constexpr auto kIn = static_cast<std::uint8_t>(ContourVerdict::In);
inline constexpr auto kUndecided = static_cast<std::uint8_t>(ContourVerdict::Undecided);

/// Values of contours, layer by layer.
using LayerValues = std::vector<std::vector<double>>;

inline const Vec3 kPlaneOrigin{ 0.1, 0.0, 0.05 };
inline const Vec3 kPlaneNormal{ 0.2, 0.1, 1.0 };

// Size of the certified images.
inline constexpr int kVerdictWidth = 64;
inline constexpr int kVerdictHeight = 48;
inline CameraView Oblique(bool parallel = false)
{
  CameraView view;
  view.position = { 1.3, -1.9, 4.0 };
  view.viewUp = { 0.1, 1.0, 0.0 };
  view.viewAngle = 30.0;
  view.parallel = parallel;
  view.parallelScale = 1.2;
  return view;
}

/// All hits of a ray, in order.
using LongHits = std::function<std::vector<long double>(const LongRay& ray)>;

inline LongHits PlaneHits(const Vec3& origin, const Vec3& normal)
{
  return [o = ToLong(origin), n = ToLong(normal)](const LongRay& ray)
  { return std::vector{ Dot(n, Minus(o, ray.origin)) / Dot(n, ray.direction) }; };
}

/// The hits of a cylinder about a unit axis; of a sphere where the axis is zero.
inline LongHits RoundHits(const Vec3& point, const Vec3& axis, double radius)
{
  return
    [p = ToLong(point), a = ToLong(axis), r = static_cast<long double>(radius)](const LongRay& ray)
  {
    const auto across = [&](const LongVec3& v) { return Minus(v, Times(Dot(a, v), a)); };
    const LongVec3 from = across(Minus(ray.origin, p));
    const LongVec3 along = across(ray.direction);
    const long double square = Dot(along, along);
    const long double half = Dot(from, along) / square;
    const long double d = half * half - (Dot(from, from) - r * r) / square;
    return d >= 0 ? std::vector{ -half - std::sqrt(d), -half + std::sqrt(d) }
                  : std::vector<long double>();
  };
}

/// The sheet of the k-th hit, which changes where a sheet begins or ends.
inline std::size_t SheetOf(std::size_t k, const std::vector<long double>& all)
{
  return 16 * all.size() + k;
}

/// The true result at an image position: the ray's visible sheet, and the field's value there.
struct TrueSight
{
  std::size_t sheet;
  long double value;
};
using Sight = std::function<std::optional<TrueSight>(long double px, long double py)>;

/// The values of a pixel's edges: of consecutive samples on the same sheet.
class TrueVerdicts
{
public:
  TrueVerdicts(
    Sight sight, int width, int height, std::vector<double> values, long double tolerance)
    : At(std::move(sight))
    , Width(width)
    , Height(height)
    , Values(std::move(values))
    , Tolerance(tolerance)
  {
    for (int y = 0; y <= height; ++y)
    {
      for (int x = 0; x <= width; ++x)
      {
        Across.push_back(Of(x, y, true));
        Up.push_back(Of(x, y, false));
      }
    }
  }

  struct Edge
  {
    bool takes = false;  ///< a value lies between samples, by more than the tolerance
    bool meets = false;  ///< or by less than it beyond them
    bool leaps = false;  ///< or between samples on different sheets
    bool isSeen = false; ///< at an end
    int longest = 0;     ///< samples one after the other that see the surface
  };

  [[nodiscard]] Edge Of(long double x, long double y, bool across, int samples = kSamples) const
  {
    Edge edge;
    std::optional<TrueSight> before;
    int seen = 0;
    for (int k = 0; k <= samples; ++k)
    {
      const long double part = static_cast<long double>(k) / samples;
      const auto sight = across ? At(x + part, y) : At(x, y + part);
      seen = sight ? seen + 1 : 0;
      edge.longest = std::max(edge.longest, seen);
      if (sight)
      {
        const bool isNext = before && before->sheet == sight->sheet;
        if (before && !isNext)
        {
          Edge leap;
          Add(before->value, sight->value, leap);
          edge.leaps = edge.leaps || leap.meets;
        }
        Add(isNext ? before->value : sight->value, sight->value, edge);
        edge.isSeen = edge.isSeen || k == 0 || k == samples;
      }
      before = sight;
    }
    return edge;
  }

  /// On curved surfaces, edges that meet the surface neither at an end nor at a sixteenth are
  /// skipped.
  [[nodiscard]] static bool IsAsked(const Edge& edge)
  {
    return edge.isSeen || edge.longest > kSamples / 16;
  }

  /// Checks that no pixel is Out with a value on its edge, and none is In without one.
  void Check(const std::vector<std::uint8_t>& verdicts, bool isFlat) const
  {
    int wrong = 0;
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        const auto edges = EdgesOf(x, y);
        const auto verdict =
          static_cast<ContourVerdict>(verdicts[static_cast<std::size_t>(y * Width + x)]);
        const bool takes = std::ranges::any_of(
          edges, [&](const Edge& edge) { return edge.takes && (isFlat || IsAsked(edge)); });
        const bool meets = std::ranges::any_of(edges, &Edge::meets);
        const bool leaps = std::ranges::any_of(edges, &Edge::leaps);
        const bool isWrong = (verdict == ContourVerdict::Out && takes) ||
          (verdict == ContourVerdict::In && !meets && !leaps && !MeetsBetween(x, y));
        wrong += isWrong ? 1 : 0;
        EXPECT_TRUE(!isWrong || wrong > 5)
          << x << " " << y << " verdict " << int(verdict) << " of a pixel that"
          << (takes ? " takes a value" : " takes none");
      }
    }
    EXPECT_EQ(wrong, 0);
  }

  /// Edges that take a value and see the surface on more than a sixteenth, but at no end.
  [[nodiscard]] int CountPeeks() const
  {
    const auto peeks = [](const Edge& edge) { return edge.takes && !edge.isSeen && IsAsked(edge); };
    return static_cast<int>(
      std::ranges::count_if(Across, peeks) + std::ranges::count_if(Up, peeks));
  }

  [[nodiscard]] int CountOutThatTake(const std::vector<std::uint8_t>& verdicts) const
  {
    int count = 0;
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        const bool out = verdicts[static_cast<std::size_t>(y * Width + x)] ==
          static_cast<std::uint8_t>(ContourVerdict::Out);
        count += out && std::ranges::any_of(EdgesOf(x, y), &Edge::takes) ? 1 : 0;
      }
    }
    return count;
  }

private:
  [[nodiscard]] std::array<Edge, 4> EdgesOf(int x, int y) const
  {
    const auto at = static_cast<std::size_t>(y * (Width + 1) + x);
    const auto above = at + static_cast<std::size_t>(Width) + 1;
    return { Across[at], Across[above], Up[at], Up[at + 1] };
  }

  static constexpr int kSamples = 64;
  static constexpr int kMany = 1 << 13;

  void Add(long double a, long double b, Edge& edge) const
  {
    const auto [lower, upper] = std::minmax(a, b);
    for (const double value : Values)
    {
      edge.takes = edge.takes || (lower + Tolerance < value && value < upper - Tolerance);
      edge.meets = edge.meets || (lower - Tolerance <= value && value <= upper + Tolerance);
    }
  }
  [[nodiscard]] bool MeetsBetween(int x, int y) const
  {
    return Of(x, y, true, kMany).meets || Of(x, y + 1, true, kMany).meets ||
      Of(x, y, false, kMany).meets || Of(x + 1, y, false, kMany).meets;
  }

  Sight At;
  int Width;
  int Height;
  std::vector<double> Values;
  long double Tolerance;
  std::vector<Edge> Across; ///< from each corner
  std::vector<Edge> Up;
};
} // namespace pixelexact::testing
