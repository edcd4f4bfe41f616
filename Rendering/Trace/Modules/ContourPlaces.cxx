// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Modules/ContourPlaces.h"

#include "Trace/Modules/ContourCells.h"
#include "Trace/TileVisit.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

namespace pixelexact
{
namespace
{
constexpr double kBent = 0.15;
constexpr double kBorder = 4.0;
constexpr double kApart = 0.3;
/// Pixels between candidate places, and between points along a contour.
constexpr int kTried = 3;
constexpr double kStep = 2.0;
/// Largest distance, in pixels, of a contour's next point from its tangent.
constexpr int kReach = 2;

struct Candidate
{
  ContourPlace place;
  double bent = 0.0; ///< in pixels
};

class Search
{
public:
  Search(const Frame& frame, const Camera& camera, const ContourCertifier& contours,
    const std::vector<std::vector<LabelSize>>& sizes, bool undecided)
    : frame_(frame)
    , Contours(contours)
    , Sizes(sizes)
    , OnUndecided(undecided)
  {
    const SampleBuffers& centres = frame.centres;
    const bool sheets = !centres.position.empty() && !centres.normal.empty();
    // The cells are the squares between pixels' centres.
    Cells.Begin(
      { centres }, { 0, 0, frame.width - 1, frame.height - 1 }, sheets ? &camera : nullptr);
  }

  std::vector<Candidate> Find()
  {
    std::vector<Candidate> found;
    for (int y = 0; y + 1 < frame_.height; y += kTried)
    {
      for (int x = 0; x + 1 < frame_.width; x += kTried)
      {
        const std::uint8_t layer = Cells.LayerOf(x, y);
        if (layer == kNoLayer)
        {
          continue;
        }
        const glm::dvec2 middle(x + 0.5, y + 0.5);
        const double here = *Cells.ValueAt(middle);
        const std::span<const double> values = Contours.Values()[layer];
        const auto above = std::ranges::lower_bound(values, here);
        for (const auto value : { above, above - (above == values.begin() ? 0 : 1) })
        {
          if (value == values.end())
          {
            continue;
          }
          const auto at = static_cast<std::size_t>(value - values.begin());
          if (const auto candidate = Try(layer, at, middle))
          {
            found.push_back(*candidate);
          }
        }
      }
    }
    return found;
  }

private:
  struct Point
  {
    glm::dvec2 at{};
    glm::dvec2 across{}; ///< up the field, unit length
  };

  [[nodiscard]] std::optional<Point> Project(const glm::dvec2& from, double value) const
  {
    const auto foot = Cells.Find(from, value, kReach);
    return foot ? std::optional(Point{ from + foot->distance * foot->towards, foot->towards })
                : std::nullopt;
  }

  /// No other contour lies within half the text's height.
  [[nodiscard]] bool IsAlone(const Point& point, std::uint8_t layer, double height) const
  {
    const glm::dvec2 side = (0.5 * height + 1.0) * point.across;
    const auto below = Cells.ValueAt(point.at - side);
    const auto above = Cells.ValueAt(point.at + side);
    const std::span<const double> values = Contours.Values()[layer];
    if (!below || !above)
    {
      return false;
    }
    const auto first = std::ranges::lower_bound(values, std::min(*below, *above));
    const auto last = std::ranges::upper_bound(values, std::max(*below, *above));
    return last - first == 1;
  }

  [[nodiscard]] std::optional<Candidate> Try(
    std::uint8_t layer, std::size_t value, const glm::dvec2& near) const
  {
    const double wanted = Contours.Values()[layer][value];
    const LabelSize& size = Sizes[layer][value];
    const auto middle = Project(near, wanted);
    // Cells' corners are pixels' centres.
    if (!middle || glm::distance(middle->at, near) > kTried || !HasLines(middle->at) ||
      !IsAlone(*middle, layer, size.height))
    {
      return std::nullopt;
    }
    std::vector<glm::dvec2> points{ middle->at };
    const double half = 0.5 * size.width + kStep;
    for (const double sense : { 1.0, -1.0 })
    {
      Point last = *middle;
      for (double gone = 0.0; gone < half; gone += kStep)
      {
        const glm::dvec2 along(-last.across.y, last.across.x);
        const auto next = Project(last.at + sense * kStep * along, wanted);
        if (!next || glm::dot(next->across, last.across) < 0.9 ||
          !IsAlone(*next, layer, size.height))
        {
          return std::nullopt;
        }
        last = *next;
        points.push_back(last.at);
      }
      // The second end starts again from the first end.
      if (sense > 0.0)
      {
        std::swap(points.front(), points.back());
      }
    }
    return Classify({ .layer = layer, .value = value }, size, points);
  }

  /// The pixel is not proven to have no line.
  [[nodiscard]] bool HasLines(const glm::dvec2& at) const
  {
    const auto pixel =
      static_cast<std::size_t>(std::floor(at.y + 0.5)) * static_cast<std::size_t>(frame_.width) +
      static_cast<std::size_t>(std::floor(at.x + 0.5));
    const auto verdict = static_cast<ContourVerdict>(Contours.Verdicts()[pixel]);
    return verdict == ContourVerdict::In || (OnUndecided && verdict == ContourVerdict::Undecided);
  }

  /// `points`: along a contour, from one end to the other.
  [[nodiscard]] std::optional<Candidate> Classify(
    ContourPlace place, const LabelSize& size, std::span<const glm::dvec2> points) const
  {
    glm::dvec2 along = glm::normalize(points.back() - points.front());
    along = along.x < 0.0 || (along.x == 0.0 && along.y < 0.0) ? -along : along;
    const glm::dvec2 up(-along.y, along.x);
    double lowest = 0.0;
    double highest = 0.0;
    for (const glm::dvec2& point : points)
    {
      const double off = glm::dot(point - points.front(), up);
      lowest = std::min(lowest, off);
      highest = std::max(highest, off);
    }
    if (!(highest - lowest <= 2.0 * kBent * size.height))
    {
      return std::nullopt;
    }
    // Cells' coordinates are half a pixel less than the image's.
    const glm::dvec2 chord = 0.5 * (points.front() + points.back());
    place.centre = chord + 0.5 * (lowest + highest) * up + 0.5;
    place.angle = std::atan2(along.y, along.x) * 180.0 / std::numbers::pi;
    const double x = 0.5 * (size.width * std::fabs(along.x) + size.height * std::fabs(along.y));
    const double y = 0.5 * (size.width * std::fabs(along.y) + size.height * std::fabs(along.x));
    const bool inside = place.centre.x - x > kBorder && place.centre.y - y > kBorder &&
      place.centre.x + x < frame_.width - kBorder && place.centre.y + y < frame_.height - kBorder;
    return inside ? std::optional(Candidate{ place, highest - lowest }) : std::nullopt;
  }

  const Frame& frame_;
  const ContourCertifier& Contours;
  const std::vector<std::vector<LabelSize>>& Sizes;
  bool OnUndecided;
  ContourCells Cells;
};
} // namespace

std::vector<ContourPlace> PlaceLabels(const Frame& frame, const Camera& camera,
  const ContourCertifier& contours, const std::vector<std::vector<LabelSize>>& sizes,
  bool undecided)
{
  std::vector<ContourPlace> places;
  if (frame.width < 2 || frame.height < 2 || frame.centres.value.empty())
  {
    return places;
  }
  std::vector<Candidate> candidates = Search(frame, camera, contours, sizes, undecided).Find();
  std::ranges::stable_sort(candidates, {}, &Candidate::bent);
  const double apart = kApart * std::min(frame.width, frame.height);
  for (const Candidate& candidate : candidates)
  {
    const ContourPlace& place = candidate.place;
    const bool free = std::ranges::none_of(places,
      [&](const ContourPlace& other)
      {
        const LabelSize& size = sizes[place.layer][place.value];
        const LabelSize& others = sizes[other.layer][other.value];
        const bool same = other.layer == place.layer && other.value == place.value;
        const double least = 0.5 * (size.width + others.width) + size.height;
        return glm::distance(other.centre, place.centre) < (same ? std::max(apart, least) : least);
      });
    if (free)
    {
      places.push_back(place);
    }
  }
  return places;
}
} // namespace pixelexact
