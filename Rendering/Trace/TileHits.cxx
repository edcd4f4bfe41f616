// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/TileHits.h"

#include "Core/Element/FieldFunction.h"
#include "Core/Location/SamplingSink.h"
#include "Core/Math/Interval.h"
#include "Trace/RayKernels.h"

#include <cmath>
#include <cstring>
#include <numeric>

namespace pixelexact
{
namespace
{
/// The samples are neighbours in the frame. If all samples of a tile are present, first and last
/// place decide. If some are missing, the ends of a row may belong to two blocks.
bool AreRow(std::span<const std::size_t, TileSamples::kRow> place, bool complete)
{
  bool areRow = place.back() == place.front() + place.size() - 1;
  for (std::size_t k = 1; !complete && k < place.size(); ++k)
  {
    areRow &= place[k] == place[0] + k;
  }
  return areRow;
}

/// Bounds of a layer's component, or of the magnitude, from bounds of all components.
Interval BoundsOf(std::span<const double> lower, std::span<const double> upper, int component)
{
  if (component != kMagnitude || lower.size() == 1)
  {
    const auto at = static_cast<std::size_t>(std::max(component, 0));
    return { lower[at], upper[at] };
  }
  Interval sum(0.0);
  for (std::size_t at = 0; at < lower.size(); ++at)
  {
    sum += Square({ lower[at], upper[at] });
  }
  return Sqrt(sum);
}
} // namespace

//--- Hits from slots ---

void TileHits::Begin(const Source& from, std::span<const int> rays, std::span<const int> slots)
{
  Of = &from.layer;
  Number = from.number;
  Slots = &from.slots;
  Ray = rays;
  Slot = slots;
}

void TileHits::TakeFirstSlot(const Source& from, std::span<const std::size_t> place)
{
  const std::size_t count = place.size();
  if (AllRays.size() < count)
  {
    AllRays.resize(count);
    std::iota(AllRays.begin(), AllRays.end(), 0);
    FirstSlots.resize(count, 0);
  }
  Begin(from, std::span(AllRays).first(count), std::span(FirstSlots).first(count));
  IsComplete = true;
  Place = place;
  T = from.slots.T(0);
  for (int d = 0; d < 3; ++d)
  {
    Position[static_cast<std::size_t>(d)] = from.slots.Position(0, d);
  }
}

void TileHits::Gather(const Source& from, std::span<const int> rays, std::span<const int> slots,
  std::span<const std::size_t> place)
{
  const std::size_t count = rays.size();
  Begin(from, rays, slots);
  IsComplete = false;
  Places.Resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    Places[i] = place[static_cast<std::size_t>(rays[i])];
  }
  Place = Places.View();
  const auto stride = static_cast<std::size_t>(PaddedCount(static_cast<int>(count)));
  Lanes.Resize(4 * stride);
  double* const lanes = Lanes.View().data();
  int slot = -1;
  std::array<const double*, 4> column{};
  for (std::size_t i = 0; i < stride; ++i)
  {
    // The arrays are padded with the last hit.
    const std::size_t k = std::min(i, count - 1);
    if (slots[k] != slot)
    {
      slot = slots[k];
      column = { from.slots.T(slot), from.slots.Position(slot, 0), from.slots.Position(slot, 1),
        from.slots.Position(slot, 2) };
    }
    for (std::size_t c = 0; c < column.size(); ++c)
    {
      lanes[c * stride + i] = column[c][rays[k]];
    }
  }
  T = lanes;
  Position = { lanes + stride, lanes + 2 * stride, lanes + 3 * stride };
}

LanePoints TileHits::Positions() const
{
  return { { Position[0], Position[1], Position[2] }, static_cast<int>(Size()) };
}

//--- Evaluation ---

void TileHits::Evaluate(const Locator& locator, const SampleBuffers& wanted, PrecisionCheck& check)
{
  const bool known = Slots->HasElements();
  const std::size_t count = Size();
  const std::size_t components =
    Of->field != nullptr ? static_cast<std::size_t>(Of->field->values.components) : 0;
  VerdictOf.Resize(count);
  Element.Resize(known || !wanted.element.empty() ? count : 0);
  Xi.Resize(known || !wanted.xi.empty() ? count : 0);
  Value.Resize(wanted.value.empty() ? 0 : count * components);
  Lower.Resize(wanted.valueLower.empty() ? 0 : count * components);
  Upper.Resize(Lower.View().size());
  Normal.Resize(0);
  const Field* field = Value.IsEmpty() && Lower.IsEmpty() ? nullptr : Of->field;
  if (field != nullptr && field->function != nullptr && field->function->NeedsNormals())
  {
    FindNormals(true);
  }
  SampleTarget target;
  target.value = Value.View();
  target.valueLower = Lower.View();
  target.valueUpper = Upper.View();
  target.normals = Normal.View();
  if (known)
  {
    EvaluateInElements(locator.GetMesh(), field, target);
  }
  else
  {
    target.element = Element.View();
    target.verdict = VerdictOf.View();
    target.xi = Xi.View();
    target.precision = Of->precision;
    target.check = &check;
    SampleTile(locator, field, Positions(), target);
  }
  for (std::size_t i = 0; Slots->HasStatuses() && i < count; ++i)
  {
    if (VerdictOf[i] == Verdict::Inside && StatusOf(i) == HitStatus::Undecided)
    {
      VerdictOf[i] = Verdict::Unknown;
    }
  }
  Reduce(components);
}

/// Elements and xi come from the surface. The field is evaluated element by element, so that points
/// fill whole packs even if hits alternate between elements.
void TileHits::EvaluateInElements(const Mesh& mesh, const Field* field, const SampleTarget& target)
{
  for (std::size_t i = 0; i < Size(); ++i)
  {
    const SurfacePoint point = PointOf(i);
    Element[i] = point.element;
    Xi[i] = point.xi;
    VerdictOf[i] = Verdict::Inside;
  }
  if (field == nullptr)
  {
    return;
  }
  SamplingSink sink(mesh, field, Positions(), target);
  ForEachKey(
    Size(), [this](std::size_t i) { return Element[i]; }, Runs,
    [&](std::int32_t element, std::span<const KeyRun> runs)
    {
      OfElement.clear();
      for (const KeyRun& run : runs)
      {
        for (std::size_t i = run.begin; i < run.end; ++i)
        {
          OfElement.push_back(static_cast<int>(i));
        }
      }
      const auto stride = static_cast<std::size_t>(PaddedCount(static_cast<int>(OfElement.size())));
      XiLanes.Resize(3 * stride);
      for (std::size_t k = 0; k < stride; ++k)
      {
        const int i = OfElement[std::min(k, OfElement.size() - 1)];
        const Vec3& xi = Xi[static_cast<std::size_t>(i)];
        XiLanes[k] = xi.x;
        XiLanes[stride + k] = xi.y;
        XiLanes[2 * stride + k] = xi.z;
      }
      const double* const lanes = XiLanes.View().data();
      const double* const xi[3] = { lanes, lanes + stride, lanes + 2 * stride };
      sink.Inside(element, OfElement, xi, nullptr);
    });
}

/// Reduces all components to the layer's component.
void TileHits::Reduce(std::size_t components)
{
  const int component = Of->component;
  const std::size_t values = Value.IsEmpty() ? 0 : Size();
  const std::size_t bounds = Lower.IsEmpty() ? 0 : Size();
  // The components of later hits have not been overwritten yet.
  for (std::size_t i = 0; components > 1 && i < values; ++i)
  {
    Value[i] = ComponentOf(Value.View().subspan(i * components, components), component);
  }
  for (std::size_t i = 0; i < bounds; ++i)
  {
    const Interval interval = BoundsOf(Lower.View().subspan(i * components, components),
      Upper.View().subspan(i * components, components), component);
    Lower[i] = interval.lower;
    Upper[i] = interval.upper;
  }
  Value.Resize(values);
  Lower.Resize(bounds);
  Upper.Resize(bounds);
}

/// Computes the normals of all hits, or of those that are not outside.
void TileHits::FindNormals(bool ofAll)
{
  const std::size_t count = Size();
  const auto isNeeded = [&](std::size_t i) { return ofAll || VerdictOf[i] != Verdict::Outside; };
  Points.clear();
  for (std::size_t i = 0; i < count; ++i)
  {
    if (isNeeded(i))
    {
      Points.push_back(PointOf(i));
    }
  }
  Normal.Resize(count);
  if (Points.empty())
  {
    return;
  }
  std::size_t found = Points.size();
  Of->surface->Normals(Points, Normal.View().first(found));
  // Normals move from the front of the array to their hits, the last one first.
  for (std::size_t i = count; found > 0;)
  {
    --i;
    if (isNeeded(i))
    {
      Normal[i] = Normal[--found];
    }
  }
}

//--- To the buffers ---

void TileHits::Write(
  const Locator& locator, std::span<const int> depth, Sheets& sheets, FrameCounters& counters)
{
  SampleBuffers& nearest = sheets.At(0);
  int deepest = 0;
  Sheet.Resize(depth.empty() ? 0 : Size());
  for (std::size_t i = 0; i < Sheet.View().size(); ++i)
  {
    Sheet[i] = depth[static_cast<std::size_t>(Ray[i])];
    const bool isKept = VerdictOf[i] != Verdict::Outside && Sheet[i] < Sheets::kMax;
    deepest = isKept ? std::max(deepest, Sheet[i]) : deepest;
  }
  if (!nearest.coverage.empty())
  {
    WriteOwners(locator, nearest);
  }
  if (!nearest.normal.empty() && Normal.IsEmpty() && Of->surface->HasCostlyNormals())
  {
    FindNormals(false);
  }
  for (int sheet = 0; sheet <= deepest; ++sheet)
  {
    const std::span<const Verdict> verdicts = VerdictsOn(sheet);
    Writer.Sort(verdicts, Place, IsComplete);
    if (Writer.Exact() + Writer.Unknown() > 0)
    {
      WriteSheet(sheets.At(sheet));
      Count(sheet, verdicts, counters);
    }
  }
}

/// The verdicts of the hits on a sheet; all other hits count as outside.
std::span<const Verdict> TileHits::VerdictsOn(int sheet)
{
  if (Sheet.IsEmpty())
  {
    return VerdictOf.View();
  }
  OnSheet.Resize(Size());
  for (std::size_t i = 0; i < Size(); ++i)
  {
    OnSheet[i] = Sheet[i] == sheet ? VerdictOf[i] : Verdict::Outside;
  }
  return OnSheet.View();
}

/// Writes the hits that the writer has sorted. Every buffer except owners has a line here.
void TileHits::WriteSheet(SampleBuffers& to) const
{
  const auto of = [](const auto& column)
  { return [all = column.View()](std::size_t i) { return all[i]; }; };
  Writer.WriteInside(to.value, of(Value));
  Writer.WriteHeld(to.position, [this](std::size_t i) { return PositionOf(i); });
  Writer.WriteHeld(to.normal,
    [this](std::size_t i)
    { return Normal.IsEmpty() ? Of->surface->Normal(PointOf(i)) : Normal[i]; });
  Writer.WriteInside(to.xi, of(Xi));
  Writer.WriteHeld(to.element, of(Element));
  Writer.WriteHeld(to.depth, [t = T](std::size_t i) { return t[i]; });
  Writer.WriteHeld(to.verdict,
    [all = VerdictOf.View()](std::size_t i)
    { return all[i] == Verdict::Inside ? kExactPixel : kUnknownPixel; });
  Writer.WriteInside(to.valueLower, of(Lower));
  Writer.WriteInside(to.valueUpper, of(Upper));
  Writer.WriteHeld(to.layer, [number = Number](std::size_t) { return number; });
  Writer.WriteInside(to.piece, [this](std::size_t i) { return PointOf(i).piece; });
  Writer.WriteInside(to.pieceU, [this](std::size_t i) { return PointOf(i).parameters[0]; });
  Writer.WriteInside(to.pieceV, [this](std::size_t i) { return PointOf(i).parameters[1]; });
}

/// Counts the preimages of the hits on the nearest sheet.
void TileHits::WriteOwners(const Locator& locator, SampleBuffers& nearest)
{
  WorldPositions.resize(Size());
  Counted.resize(Size());
  for (std::size_t i = 0; i < Size(); ++i)
  {
    WorldPositions[i] = PositionOf(i);
  }
  FindOwnersOfTile(locator, WorldPositions, Counted);
  for (std::size_t i = 0; i < Size(); ++i)
  {
    const bool isNearest = Sheet.IsEmpty() || Sheet[i] == 0;
    if (isNearest &&
      (VerdictOf[i] != Verdict::Outside || locator.Bounds().Contains(WorldPositions[i])))
    {
      nearest.owners[Place[i]] = Counted[i].preimages;
      nearest.coverage[Place[i]] = static_cast<std::uint8_t>(Counted[i].coverage);
    }
  }
}

void TileHits::Count(int sheet, std::span<const Verdict> verdicts, FrameCounters& counters) const
{
  for (std::size_t i = 0; Slots->HasStatuses() && i < Size(); ++i)
  {
    if (verdicts[i] != Verdict::Outside)
    {
      counters.numericHits += StatusOf(i) == HitStatus::Numeric ? 1 : 0;
      counters.undecidedHits += StatusOf(i) == HitStatus::Undecided ? 1 : 0;
    }
  }
  if (sheet > 0)
  {
    return;
  }
  counters.exact += Writer.Exact();
  counters.unknown += Writer.Unknown();
  const std::span<const double> values = Value.View();
  const bool allExact = Writer.Exact() == static_cast<std::int64_t>(Size());
  if (allExact && GetRayKernels().areFinite(values.data(), static_cast<int>(values.size())))
  {
    return;
  }
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    counters.nonFinite += verdicts[i] == Verdict::Inside && !std::isfinite(values[i]) ? 1 : 0;
  }
}

void SampleWriter::Sort(
  std::span<const Verdict> verdicts, std::span<const std::size_t> place, bool complete)
{
  constexpr std::size_t kRow = TileSamples::kRow;
  static constexpr auto kAllInside = []
  {
    std::array<Verdict, kRow> all{};
    all.fill(Verdict::Inside);
    return all;
  }();
  Place = place;
  Rows.clear();
  Singles.clear();
  Unknowns.clear();
  for (std::size_t i = 0; i < verdicts.size();)
  {
    if (i + kRow <= verdicts.size() &&
      std::memcmp(&verdicts[i], kAllInside.data(), sizeof kAllInside) == 0 &&
      AreRow(place.subspan(i).first<kRow>(), complete))
    {
      Rows.push_back(i);
      i += kRow;
      continue;
    }
    if (verdicts[i] == Verdict::Inside)
    {
      Singles.push_back(i);
    }
    else if (verdicts[i] == Verdict::Unknown)
    {
      Unknowns.push_back(i);
    }
    ++i;
  }
  ExactCount = static_cast<std::int64_t>(Rows.size() * kRow + Singles.size());
}
} // namespace pixelexact
