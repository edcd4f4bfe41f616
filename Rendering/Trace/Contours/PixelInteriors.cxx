// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Contours/PixelInteriors.h"

#include <algorithm>
#include <utility>

namespace pixelexact
{
namespace
{
/// Points that a quartered square adds: the middles of its sides, from below on, and its centre.
constexpr std::size_t kAdded = 5;

std::array<ImagePosition, kAdded> PlacesIn(const PixelInteriors::Corners& corners)
{
  const auto between = [&](std::size_t i, std::size_t j) -> ImagePosition
  {
    return { 0.5 * (corners[i].position[0] + corners[j].position[0]),
      0.5 * (corners[i].position[1] + corners[j].position[1]) };
  };
  return { between(0, 1), between(1, 2), between(2, 3), between(3, 0), between(0, 2) };
}

/// EdgeRefiner treats all segments of a pixel as one edge, so their samples have no limit.
ContourMethod WithAnySamples(ContourMethod method)
{
  method.samples = ContourMethod::kAny;
  return method;
}
} // namespace

PixelInteriors::PixelInteriors(LayerSight& sight, const EdgeClassifier& classifier,
  const ContourMethod& method, std::span<ContourVerdict> states, ContourCounters& counted)
  : Sight(sight)
  , Classifier(classifier)
  , Method(method)
  , States(states)
  , Counted(counted)
  , Lines(sight, classifier, WithAnySamples(method), states, counted)
  , Squares(states.size(), 0)
{
}

void PixelInteriors::Add(std::size_t pixel, const Corners& corners)
{
  if (States[pixel] == ContourVerdict::Out)
  {
    Settle({ pixel, corners }, 0);
  }
}

bool PixelInteriors::IsOut(const Square& square) const
{
  const Corners& ends = square.corners;
  if (std::ranges::all_of(ends, [this](const EdgeEnd& end) { return Sight.Hides(end); }) ||
    Sight.IsPlaneBeyond(ends))
  {
    // Another layer hides this one at all corners, or there is nothing of it.
    return true;
  }
  int side = EdgeClassifier::kNoSide;
  for (const EdgeEnd& end : ends)
  {
    if (Sight.Shows(end))
    {
      const int its = Classifier.SideOf(end.point.value);
      if (side != EdgeClassifier::kNoSide && its != side)
      {
        return false;
      }
      side = its;
    }
  }
  const bool isPlane = Sight.GetSurface().IsPlane();
  if (!std::ranges::all_of(ends, &EdgeEnd::meets))
  {
    // A curved surface that no corner shows is not searched; see EdgeRefiner.
    return !isPlane &&
      std::ranges::none_of(ends, [this](const EdgeEnd& end) { return Sight.Shows(end); });
  }
  const Vec3 x[4] = { ends[0].point.x, ends[1].point.x, ends[2].point.x, ends[3].point.x };
  if (isPlane)
  {
    return Classifier.StaysOn(side, Outline(x), 0.0);
  }
  // Both triangles stay on the side of all corners.
  const auto staysOn = [&](std::size_t a, std::size_t b, std::size_t c)
  {
    return Classifier.StaysOn(side, Outline(std::array{ x[a], x[b], x[c] }),
      Sight.SagittaOver({ &ends[a], &ends[b], &ends[c] }));
  };
  return staysOn(0, 1, 2) && staysOn(0, 2, 3);
}

void PixelInteriors::Settle(const Square& square, int level)
{
  if (IsOut(square))
  {
    return;
  }
  int& open = Squares[square.pixel];
  if (level < Method.quarterings && open < Method.squares)
  {
    ++open;
    Open.push_back(square);
    return;
  }
  States[square.pixel] = JoinVerdicts(States[square.pixel], ContourVerdict::Undecided);
}

void PixelInteriors::Compare(const Square& square, std::span<const EdgeEnd> samples)
{
  const auto shows = [this](const EdgeEnd& end) { return Sight.Shows(end); };
  const auto corner = std::ranges::find_if(square.corners, shows);
  const auto sample = std::ranges::find_if(samples, shows);
  if (sample == samples.end())
  {
    return;
  }
  const EdgeEnd& first = corner != square.corners.end() ? *corner : *sample;
  for (const EdgeEnd& other : samples)
  {
    if (Sight.Shows(other) && Classifier.AreOpposite(first, other))
    {
      Lines.Add(square.pixel, first, other, false);
      Lines.EndRow();
    }
  }
}

void PixelInteriors::Refine()
{
  for (int level = 1;; ++level)
  {
    std::vector<Square> squares = std::exchange(Open, {});
    std::erase_if(
      squares, [this](const Square& square) { return States[square.pixel] == ContourVerdict::In; });
    if (squares.empty())
    {
      return;
    }
    std::int64_t cost = 0;
    for (const Square& square : squares)
    {
      cost += kAdded * Classifier.SampleCost(square.corners[0], square.corners[2]);
    }
    if (!Classifier.Affords(cost))
    {
      for (const Square& square : squares)
      {
        States[square.pixel] = JoinVerdicts(States[square.pixel], ContourVerdict::Undecided);
      }
      return;
    }
    std::vector<ImagePosition> places;
    for (const Square& square : squares)
    {
      const auto added = PlacesIn(square.corners);
      places.insert(places.end(), added.begin(), added.end());
      Squares[square.pixel] = 0;
    }
    const std::vector<EdgeEnd> ends = Sight.Trace(places);
    Counted.samples += std::ssize(places);
    for (const EdgeEnd& end : ends)
    {
      if (end.isUnknown)
      {
        Classifier.SpendOnUnknown();
      }
    }
    for (std::size_t i = 0; i < squares.size(); ++i)
    {
      Compare(squares[i], std::span(ends).subspan(kAdded * i, kAdded));
    }
    Lines.Refine();
    for (std::size_t i = 0; i < squares.size(); ++i)
    {
      const auto& [pixel, corners] = squares[i];
      if (States[pixel] == ContourVerdict::In)
      {
        continue;
      }
      const std::span<const EdgeEnd> added = std::span(ends).subspan(kAdded * i, kAdded);
      for (std::size_t k = 0; k < corners.size(); ++k)
      {
        // The child's corners, in order from the parent's corner k.
        Settle({ pixel, { corners[k], added[k], added[4], added[(k + 3) % 4] } }, level);
      }
    }
  }
}
} // namespace pixelexact
