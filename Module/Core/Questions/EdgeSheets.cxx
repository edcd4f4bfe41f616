// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Math/Mat.h"
#include "Core/Math/Rounding.h"
#include "Core/Questions/EdgeBounds.h"
#include "Core/Questions/EdgeMeeting.h"
#include "Core/Questions/OnSheet.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <span>

namespace pixelexact
{
using namespace edges;

namespace
{
/// Newton steps towards the place where a sheet leaves its element.
constexpr int kExitSteps = 8;
/// The largest number of subdivisions of a node for a chord.
constexpr int kSmaller = 6;
/// The largest last step, in xi: far less than exits are outside the element.
constexpr double kArrived = 1e-12;
} // namespace

std::optional<SheetExit> OnSheet::ExitOf(const SheetPoint& from, const SheetPoint& towards) const
{
  const Vec3 chord = (towards.x - from.x) / Of.Size();
  const auto directionAt = [&](double part)
  {
    return glm::normalize(
      (1.0 - part) * from.distance * from.direction + part * towards.distance * towards.direction);
  };
  SheetExit exit;
  exit.point.xi = from.xi;
  for (int step = 0; step < kExitSteps; ++step)
  {
    const Values at = At(std::array{ exit.point.xi })[0];
    const Mat3 W = glm::inverse(at.jacobian);
    const Vec3 w = W * directionAt(exit.part);
    const Vec3 q = w / glm::dot(at.gradient, w);
    // The place where the ray through c(u) meets the sheet, to first order: base + u along.
    const Vec3 back = W * (at.y - Of.InUnits(from.x));
    const Vec3 forth = W * chord;
    const Vec3 base = exit.point.xi - back + q * (glm::dot(at.gradient, back) - at.f);
    const Vec3 along = forth - q * glm::dot(at.gradient, forth);
    double part = 1.0;
    for (std::size_t k = 0; k < 6; ++k)
    {
      const EdgeNodeEnd& end = Ends[k];
      const double outwards =
        end.normal[0] * along.x + end.normal[1] * along.y + end.normal[2] * along.z;
      // Half of the distance that a path may be outside the element, so that it overlaps with the
      // neighbour's.
      constexpr double kHalf[3] = { 0.5 * kOverlap, 0.5 * kOverlap, 0.5 * kOverlap };
      if (k != Own && outwards > 0.0)
      {
        part = std::min(part, (end.DepthOf(base) + end.Across(kHalf)) / outwards);
      }
    }
    const Vec3 next = base + part * along;
    const Vec3 moved = next - exit.point.xi;
    const bool arrived = glm::length(moved) <= kArrived;
    exit.point.xi = next;
    exit.part = part;
    // The comparison is written so that a NaN ends the search.
    if (!(part >= 0.0 && part <= 1.0))
    {
      return std::nullopt;
    }
    if (arrived)
    {
      const Vec3 c = from.x + part * (towards.x - from.x);
      exit.point.direction = directionAt(part);
      const double tau =
        glm::dot(Of.InWorld(At(std::array{ next })[0].y) - c, exit.point.direction);
      exit.point.x = c + tau * exit.point.direction;
      exit.point.distance = (1.0 - part) * from.distance + part * towards.distance;
      exit.point.off = std::max(from.off, towards.off);
      exit.beside = std::fabs(tau);
      return exit;
    }
  }
  return std::nullopt;
}

double OnSheet::Sagitta(const EdgeTree& tree, const SheetPoint& a, const SheetPoint& b) const
{
  const Vec3 middle = 0.5 * (a.xi + b.xi);
  const auto at = At(std::array{ a.xi, b.xi, middle });
  const auto pencil = PencilOf(at[0], a.direction, b.direction);
  if (!pencil)
  {
    return kInfinity;
  }
  const auto etaOf = [this](const Vec3& xi)
  { return glm::clamp(ReferenceToTensor(Of.GetShape(), xi), Vec3(-1.0), Vec3(1.0)); };
  const Vec3 etas[3] = { etaOf(a.xi), etaOf(b.xi), etaOf(middle) };
  // Where rays nearly touch the sheet, smaller nodes give better bounds.
  const EdgeNode* node = &tree.LeafAt(etas[2], nullptr);
  double sagitta = Sagitta(*node, *pencil, a, b, at);
  for (int k = 0; k < kSmaller && !std::isfinite(sagitta) && node->regular; ++k)
  {
    const auto& children = tree.Split(*node);
    const int d = node->direction;
    node = &children[etas[2][d] <= children[0].box.upper[d] ? 0 : 1];
    if (!node->wide.Holds(etas[0]) || !node->wide.Holds(etas[1]))
    {
      break;
    }
    sagitta = Sagitta(*node, *pencil, a, b, at);
  }
  return sagitta;
}

bool EdgeBounds::MayMeet(
  const Sheet& sheet, const WideOutline& region, const EdgeEffort& effort) const
{
  const ValueSet value{ std::span(&sheet.value, 1) };
  if (sheet.face < 0 || !Functions.IsKnown())
  {
    return MayTake(value, region, effort);
  }
  // Works as MayTake, in the nodes at the face.
  const std::size_t own = EndOfFace(Functions.GetShape(), sheet.face);
  const auto mayMeet = [&](const auto& self, const EdgeNode& node) -> bool
  {
    if (Misses(Functions, node, region))
    {
      return false;
    }
    bool divide = !node.regular;
    if (node.regular)
    {
      const EdgeNodeEnd& face = node.boxEnds[own];
      if (!face.ofElement)
      {
        return false;
      }
      const EdgeMeeting meeting = Meet(Functions, node, region, value, &face);
      if (!meeting.values)
      {
        return false;
      }
      divide = meeting.bends && node.subdivisions < effort.whereMapBends;
    }
    return !divide || !Tree.CanSplit(node, effort.work) ||
      std::ranges::any_of(Tree.Split(node), [&](const EdgeNode& half) { return self(self, half); });
  };
  return !Frame.Misses(Functions, region) && mayMeet(mayMeet, Tree.Whole());
}

double EdgeBounds::Sagitta(const Sheet& sheet, const SheetPoint& a, const SheetPoint& b) const
{
  return Functions.IsKnown() ? OnSheet(Functions, Ends, sheet).Sagitta(Tree, a, b) : kInfinity;
}

std::optional<SheetExit> EdgeBounds::ExitOf(
  const Sheet& sheet, const SheetPoint& from, const SheetPoint& towards) const
{
  return Functions.IsKnown() ? OnSheet(Functions, Ends, sheet).ExitOf(from, towards) : std::nullopt;
}
} // namespace pixelexact
