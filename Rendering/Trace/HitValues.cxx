// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/HitValues.h"

#include "Core/Element/FieldFunction.h"
#include "Core/Math/Interval.h"
#include "Trace/Room.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
Interval Component(std::span<const double> lower, std::span<const double> upper, int component)
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

std::size_t ComponentsOf(const Layer& layer)
{
  return layer.field != nullptr ? static_cast<std::size_t>(layer.field->values.components) : 0;
}
} // namespace

void HitValues::Evaluate(const Locator& locator, const SampleBuffers& wanted, std::size_t count,
  HitResults& found, PrecisionCheck& check)
{
  const Layer& layer = *found.layer;
  const bool known = found.slots->HasElements();
  const std::size_t components = ComponentsOf(layer);
  const auto sizeIf = [&](bool isWanted, std::size_t each) { return isWanted ? count * each : 0; };
  Element = Room(Elements, sizeIf(known || !wanted.element.empty(), 1));
  TheVerdict = Room(Verdicts, count);
  Xi = Room(Xis, sizeIf(known || !wanted.xi.empty(), 1));
  Value = Room(Values, sizeIf(!wanted.value.empty(), components));
  Lower = Room(Lowers, sizeIf(!wanted.valueLower.empty(), components));
  Upper = Room(Uppers, Lower.size());
  const Field* field = Value.empty() && Lower.empty() ? nullptr : layer.field;
  if (known)
  {
    EvaluateKnown(locator.GetMesh(), field, found);
  }
  else
  {
    Locate(locator, field, found, check);
  }
  if (found.slots->HasStatuses())
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      if (TheVerdict[i] == Verdict::Inside && found.Status(i) == HitStatus::Undecided)
      {
        TheVerdict[i] = Verdict::Unknown;
      }
    }
  }
  found.verdict = TheVerdict;
  found.element = Element;
  found.xi = Xi;
  Reduce(layer, found);
}

void HitValues::Locate(
  const Locator& locator, const Field* field, const HitResults& found, PrecisionCheck& check)
{
  SampleTarget target;
  target.element = Element;
  target.verdict = TheVerdict;
  target.xi = Xi;
  target.value = Value;
  target.valueLower = Lower;
  target.valueUpper = Upper;
  target.precision = found.layer->precision;
  target.check = &check;
  target.normals = NormalsFor(field, found);
  const auto count = static_cast<int>(TheVerdict.size());
  SampleTile(
    locator, field, { { found.position[0], found.position[1], found.position[2] }, count }, target);
}

void HitValues::EvaluateKnown(const Mesh& mesh, const Field* field, const HitResults& found)
{
  const std::size_t count = TheVerdict.size();
  const std::size_t components = count > 0 ? Value.size() / count : 0;
  const std::size_t bounds = count > 0 ? Lower.size() / count : 0;
  const bool isFunction = field != nullptr && field->function != nullptr;
  const auto positions = Room(Positions, Lower.empty() && !isFunction ? 0 : count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const SurfacePoint point = found.slots->PointOf(found.SlotOf(i), found.RayOf(i));
    Element[i] = point.element;
    Xi[i] = point.xi;
    TheVerdict[i] = Verdict::Inside;
    if (!positions.empty())
    {
      positions[i] = point.position;
    }
  }
  if (field == nullptr)
  {
    return;
  }
  const std::span<const Vec3> normals = NormalsFor(field, found);
  ForEachKey(
    count, [&](std::size_t i) { return Element[i]; }, Runs,
    [&](std::int32_t element, std::span<const KeyRun> of)
    {
      // From where the hits lie to beside each other, and back.
      const auto gather = [of](auto from, auto& to)
      {
        to.clear();
        for (const KeyRun& run : of)
        {
          to.insert(to.end(), &from[run.begin], &from[run.begin] + (run.end - run.begin));
        }
      };
      const auto scatter = [of](const std::vector<double>& from, std::size_t each, auto to)
      {
        auto next = from.begin();
        for (const KeyRun& run : of)
        {
          const auto numbers = static_cast<std::ptrdiff_t>(each * (run.end - run.begin));
          std::copy_n(next, numbers, to.begin() + static_cast<std::ptrdiff_t>(each * run.begin));
          next += numbers;
        }
      };
      gather(Xi, XiOfElement);
      PositionsOfElement.clear();
      if (!positions.empty())
      {
        gather(positions, PositionsOfElement);
      }
      if (components > 0)
      {
        ValuesOfElement.resize(components * XiOfElement.size());
        NormalsOfElement.clear();
        if (!normals.empty())
        {
          gather(normals, NormalsOfElement);
        }
        EvaluateAt(mesh, *field, element, XiOfElement, ValuesOfElement, {},
          { PositionsOfElement, NormalsOfElement });
        scatter(ValuesOfElement, components, Value);
      }
      if (bounds > 0)
      {
        ValuesOfElement.resize(bounds * XiOfElement.size());
        UppersOfElement.resize(ValuesOfElement.size());
        EncloseAt(
          mesh, *field, element, XiOfElement, PositionsOfElement, ValuesOfElement, UppersOfElement);
        scatter(ValuesOfElement, bounds, Lower);
        scatter(UppersOfElement, bounds, Upper);
      }
    });
}

std::span<const Vec3> HitValues::NormalsFor(const Field* field, const HitResults& found)
{
  if (field == nullptr || field->function == nullptr || !field->function->NeedsNormals())
  {
    return {};
  }
  Points.clear();
  for (std::size_t i = 0; i < TheVerdict.size(); ++i)
  {
    Points.push_back(found.Point(i));
  }
  Normals.resize(Points.size());
  found.layer->surface->Normals(Points, Normals);
  return Normals;
}

/// To the component that is shown.
void HitValues::Reduce(const Layer& layer, HitResults& found)
{
  const std::size_t count = TheVerdict.size();
  const std::size_t components = ComponentsOf(layer);
  if (components > 1)
  {
    // Of later hits nothing has been overwritten yet.
    for (std::size_t i = 0; i < count && !Value.empty(); ++i)
    {
      Value[i] = ComponentOf(Value.subspan(i * components, components), layer.component);
    }
  }
  for (std::size_t i = 0; i < count && !Lower.empty(); ++i)
  {
    const Interval bounds = Component(Lower.subspan(i * components, components),
      Upper.subspan(i * components, components), layer.component);
    Lower[i] = bounds.lower;
    Upper[i] = bounds.upper;
  }
  found.value = Value.first(Value.empty() ? 0 : count);
  found.lower = Lower.first(Lower.empty() ? 0 : count);
  found.upper = Upper.first(Upper.empty() ? 0 : count);
}
} // namespace pixelexact
