// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Contours/EdgeRefiner.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pixelexact
{
namespace
{
/// Subdivisions of an edge with no end on the layer, but with a corner beside it on the layer.
constexpr int kPeeks = 4;
/// Samples that an Unknown sample counts as: samples near it are seldom decided.
constexpr int kSamplesOfUnknown = 4;
/// Largest sagitta, relative to the chord, of curved edges that are tested against other elements.
constexpr double kBulge = 1.0;
} // namespace

EdgeRefiner::EdgeRefiner(LayerSight& sight, const EdgeClassifier& classifier,
  const ContourMethod& method, std::span<ContourVerdict> states, ContourCounters& counted)
  : Sight(sight)
  , Classifier(classifier)
  , Method(method)
  , IsPlane(sight.GetSurface().IsPlane())
  , States(states)
  , Counted(counted)
  , Parts(states.size(), 0)
  , Samples(states.size(), 0)
  , IsLimited(IsPlane && method.samples != ContourMethod::kAny)
{
}

void EdgeRefiner::Add(std::size_t edge, const EdgeEnd& a, const EdgeEnd& b, bool peeks)
{
  if (States[edge] != ContourVerdict::In)
  {
    const Part part{ edge, a, b, peeks };
    const EdgeFinding finding = ClassifyWithin(part);
    if (finding == EdgeFinding::Uncovered && !MayJump(part))
    {
      Run.push_back(part);
      return;
    }
    Settle(part, finding, 0);
  }
  EndRow();
}

void EdgeRefiner::EndRow()
{
  SettleRun(Run);
  Run.clear();
}

int EdgeRefiner::SideOf(const Part& part) const
{
  return Sight.Shows(part.a) ? Classifier.SideOf(part.a.point.value)
    : Sight.Shows(part.b)    ? Classifier.SideOf(part.b.point.value)
                             : EdgeClassifier::kNoSide;
}

bool EdgeRefiner::MayJump(const Part& part) const
{
  return Sight.Shows(part.a) && Sight.Shows(part.b) && part.a.element != part.b.element &&
    Classifier.AreOpposite(part.a, part.b);
}

EdgeFinding EdgeRefiner::ClassifyWithin(const Part& part) const
{
  const EdgeEnd& a = part.a;
  const EdgeEnd& b = part.b;
  const bool hidden = Sight.Hides(a) && Sight.Hides(b) && !part.peeks;
  if (hidden || Sight.IsPlaneBeyond(std::array{ a, b }))
  {
    // Another layer hides this one at both ends, or there is nothing of it.
    return EdgeFinding::Out;
  }
  // An end lies on the edge, so it decides the edge alone.
  const auto isOnPlateau = [this](const EdgeEnd& end)
  { return Sight.Shows(end) && Classifier.IsOnPlateau(end); };
  if (isOnPlateau(a) || isOnPlateau(b))
  {
    return EdgeFinding::In;
  }
  return Sight.Shows(a) && Sight.Shows(b) && a.element == b.element
    ? Classifier.Within(a, b, Sight.EdgeBetween(a, b))
    : EdgeFinding::Uncovered;
}

EdgeFinding EdgeRefiner::ClassifyBeyond(const Part& part) const
{
  const SurfaceEdge edge = Sight.EdgeBetween(part.a, part.b);
  const bool inReach = edge.sagitta <= kBulge * glm::distance(edge.from, edge.to);
  return inReach && !MayJump(part) && Classifier.StaysOn(SideOf(part), edge, true)
    ? EdgeFinding::Out
    : EdgeFinding::Uncovered;
}

bool EdgeRefiner::ShowsNoValue(const Part& part) const
{
  // The test cannot improve an edge that is already Undecided.
  return !IsPlane && States[part.edge] == ContourVerdict::Out &&
    Classifier.StaysBetween(Sight.GetSurface(), Sight.BeamBetween(part.a, part.b));
}

void EdgeRefiner::SettleRun(std::span<const Part> run)
{
  if (run.size() <= 1)
  {
    for (const Part& part : run)
    {
      Settle(part, EdgeFinding::Uncovered, 0);
    }
    return;
  }
  if (IsPlane)
  {
    // On a plane, the run is one straight edge.
    const SurfaceEdge all = Sight.EdgeBetween(run.front().a, run.back().b);
    const int side = SideOf(run.front());
    if (std::ranges::all_of(run, [&](const Part& part) { return SideOf(part) == side; }) &&
      Classifier.StaysOn(side, all, false))
    {
      return;
    }
  }
  SettleRun(run.first(run.size() / 2));
  SettleRun(run.subspan(run.size() / 2));
}

void EdgeRefiner::Settle(const Part& part, EdgeFinding finding, int level)
{
  if (finding == EdgeFinding::Uncovered)
  {
    finding = ClassifyBeyond(part);
  }
  if (finding == EdgeFinding::Out)
  {
    return;
  }
  if (finding == EdgeFinding::In)
  {
    States[part.edge] = ContourVerdict::In;
    return;
  }
  const bool onBoth = Sight.Shows(part.a) && Sight.Shows(part.b);
  if (finding == EdgeFinding::Blurred ||
    (finding == EdgeFinding::Uncovered && onBoth && Classifier.MayTouch(part.a) &&
      Classifier.MayTouch(part.b)))
  {
    States[part.edge] = ContourVerdict::Undecided;
    return;
  }
  if (!IsPlane && !Sight.Shows(part.a) && !Sight.Shows(part.b))
  {
    // Otherwise the surface is not searched between two rays that both miss it.
    if (part.peeks && level < kPeeks)
    {
      Open.push_back(part);
    }
    return;
  }
  const int deepest = finding == EdgeFinding::Open ? Method.edgeLevels : Method.crossings;
  // With many open parts, parts that show no value are removed to make room for others.
  if (finding == EdgeFinding::Uncovered && level < deepest &&
    Parts[part.edge] >= Method.parts * 3 / 4 && ShowsNoValue(part))
  {
    return;
  }
  // After the limits, only opposite sides with a continuous surface between them prove In.
  const bool opposite = onBoth && Classifier.AreOpposite(part.a, part.b);
  if (level < deepest && Parts[part.edge] < Method.parts &&
    (opposite || !IsLimited || Samples[part.edge] < Method.samples))
  {
    ++Parts[part.edge];
    Open.push_back(part);
    return;
  }
  if (opposite && finding == EdgeFinding::Uncovered)
  {
    const SurfaceEdge edge = Sight.EdgeBetween(part.a, part.b);
    // The surface is proven continuous between the ends.
    if (std::isfinite(edge.sagitta) && Classifier.Across(part.a, part.b) != EdgeFinding::Open)
    {
      States[part.edge] = ContourVerdict::In;
      Counted.jumps += Classifier.IsJump(part.a, part.b, edge) ? 1 : 0;
      return;
    }
  }
  const bool near = onBoth && Sight.AreNear(part.a, part.b);
  if (level >= deepest && !near && !opposite && !IsPlane)
  {
    // The search ends this close to a silhouette or to the mesh's boundary. A value between those
    // of two separate sheets is no line.
    return;
  }
  if (ShowsNoValue(part))
  {
    return;
  }
  States[part.edge] = JoinVerdicts(States[part.edge], ContourVerdict::Undecided);
}

void EdgeRefiner::MarkOpen(std::span<ContourVerdict> states) const
{
  for (const Part& part : Open)
  {
    states[part.edge] = JoinVerdicts(states[part.edge], ContourVerdict::Undecided);
  }
}

void EdgeRefiner::Refine()
{
  for (int level = 1;; ++level)
  {
    std::vector<Part> parts = std::exchange(Open, {});
    std::erase_if(parts,
      [this](const Part& part)
      {
        return States[part.edge] == ContourVerdict::In ||
          (IsLimited && States[part.edge] == ContourVerdict::Undecided &&
            !Classifier.AreOpposite(part.a, part.b));
      });
    if (parts.empty())
    {
      return;
    }
    std::int64_t cost = 0;
    for (const Part& part : parts)
    {
      cost += Classifier.SampleCost(part.a, part.b);
    }
    // A level is subdivided completely or not at all, so no pixel takes precedence.
    if (!Classifier.Affords(cost))
    {
      Open = std::move(parts);
      MarkOpen(States);
      return;
    }
    std::vector<ImagePosition> middles;
    for (const Part& part : parts)
    {
      middles.push_back({ 0.5 * (part.a.position[0] + part.b.position[0]),
        0.5 * (part.a.position[1] + part.b.position[1]) });
      Parts[part.edge] = 0;
      ++Samples[part.edge];
    }
    const std::vector<EdgeEnd> ends = Sight.Trace(middles);
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      if (ends[i].isUnknown)
      {
        Classifier.SpendOnUnknown();
        Samples[parts[i].edge] += kSamplesOfUnknown;
      }
      const Part children[2] = { { parts[i].edge, parts[i].a, ends[i], parts[i].peeks },
        { parts[i].edge, ends[i], parts[i].b, parts[i].peeks } };
      for (const Part& half : children)
      {
        if (States[half.edge] != ContourVerdict::In)
        {
          Settle(half, ClassifyWithin(half), level);
        }
      }
    }
    Counted.samples += std::ssize(middles);
  }
}
} // namespace pixelexact
