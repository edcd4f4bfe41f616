// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Tile.h"

#include "Core/Location/Owners.h"
#include "Core/Location/Sample.h"
#include "Core/Math/Interval.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pixelexact
{
namespace
{
class TileWork
{
public:
  TileWork(const Scene& scene, const Camera& camera, const TileArea& area, double offset,
    SampleBuffers& buffers, FrameCounters& counters)
    : TheScene(scene)
    , Buffers(buffers)
    , Counters(counters)
  {
    const int count = (area.x1 - area.x0) * (area.y1 - area.y0);
    Rays.reserve(count);
    for (int y = area.y0; y < area.y1; ++y)
    {
      for (int x = area.x0; x < area.x1; ++x)
      {
        Rays.push_back(camera.At(x + offset, y + offset));
        Place.push_back(static_cast<std::size_t>(y) * buffers.width + x);
      }
    }
    TMin.assign(count, 0.0);
    counters.rays += count;
  }

  void Run()
  {
    // Each round takes every ray to its next hit; rays whose hit is outside of the mesh go on.
    while (!Rays.empty())
    {
      FindNearest();
      DropMisses();
      if (!Rays.empty())
      {
        Evaluate();
        KeepOutside();
      }
    }
  }

private:
  void FindNearest()
  {
    const std::size_t count = Rays.size();
    T.assign(count, kNoHit);
    Position.resize(count);
    Hit.assign(count, 0);
    for (std::size_t s = 0; s < TheScene.surfaces.size(); ++s)
    {
      NextT.resize(count);
      NextPosition.resize(count);
      TheScene.surfaces[s]->NextHit(Rays, TMin, NextT, NextPosition);
      for (std::size_t i = 0; i < count; ++i)
      {
        if (NextT[i] < T[i])
        {
          T[i] = NextT[i];
          Position[i] = NextPosition[i];
          Hit[i] = static_cast<int>(s);
        }
      }
    }
  }

  template <class Keep>
  void Filter(const Keep& keep)
  {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < Rays.size(); ++i)
    {
      if (keep(i))
      {
        Rays[kept] = Rays[i];
        Place[kept] = Place[i];
        TMin[kept] = TMin[i];
        T[kept] = T[i];
        Position[kept] = Position[i];
        Hit[kept] = Hit[i];
        ++kept;
      }
    }
    for (const auto shrink : { &TMin, &T })
    {
      shrink->resize(kept);
    }
    Rays.resize(kept);
    Place.resize(kept);
    Position.resize(kept);
    Hit.resize(kept);
  }

  void DropMisses()
  {
    Filter([&](std::size_t i) { return T[i] < kNoHit; });
    Counters.surfaceHits += static_cast<std::int64_t>(Rays.size());
  }

  void Evaluate()
  {
    const std::size_t count = Rays.size();
    const auto components = static_cast<std::size_t>(TheScene.field->values.components);
    Element.resize(count);
    Verdicts.resize(count);
    Xi.resize(Buffers.xi.empty() ? 0 : count);
    Values.resize(Buffers.value.empty() ? 0 : count * components);
    SampleTarget target;
    target.element = Element;
    target.verdict = Verdicts;
    target.xi = Xi;
    target.value = Values;
    Lower.resize(Buffers.valueLower.empty() ? 0 : count * components);
    Upper.resize(Lower.size());
    target.valueLower = Lower;
    target.valueUpper = Upper;
    const bool evaluate = !Buffers.value.empty() || !Buffers.valueLower.empty();
    SampleTile(*TheScene.locator, evaluate ? TheScene.field : nullptr, Position, target);
    if (!Buffers.coverage.empty())
    {
      CountOwners();
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      if (Verdicts[i] != Verdict::Outside)
      {
        Write(i, components);
      }
    }
  }

  void CountOwners()
  {
    Found.resize(Position.size());
    FindOwnersOfTile(*TheScene.locator, Position, Found);
    const Box3& bounds = TheScene.locator->Bounds();
    for (std::size_t i = 0; i < Position.size(); ++i)
    {
      if (Verdicts[i] != Verdict::Outside || bounds.Contains(Position[i]))
      {
        Buffers.owners[Place[i]] = Found[i].preimages;
        Buffers.coverage[Place[i]] = static_cast<std::uint8_t>(Found[i].coverage);
      }
    }
  }

  void KeepOutside()
  {
    Filter(
      [&](std::size_t i)
      {
        TMin[i] = T[i];
        return Verdicts[i] == Verdict::Outside;
      });
  }

  void Write(std::size_t i, std::size_t components)
  {
    const std::size_t at = Place[i];
    const bool exact = Verdicts[i] == Verdict::Inside;
    const auto write = [at](auto& buffer, const auto& value)
    {
      if (!buffer.empty())
      {
        buffer[at] = value;
      }
    };
    ++(exact ? Counters.exact : Counters.unknown);
    write(Buffers.verdict,
      static_cast<std::uint8_t>(exact ? PixelVerdict::Exact : PixelVerdict::Unknown));
    write(Buffers.position, Position[i]);
    write(Buffers.depth, T[i]);
    write(Buffers.element, static_cast<std::int64_t>(Element[i]));
    if (!Buffers.normal.empty())
    {
      Buffers.normal[at] = TheScene.surfaces[Hit[i]]->Normal(Position[i]);
    }
    if (exact && !Buffers.xi.empty())
    {
      Buffers.xi[at] = Xi[i];
    }
    if (exact && !Buffers.value.empty())
    {
      const double value = Component({ &Values[i * components], components });
      Counters.nonFinite += std::isfinite(value) ? 0 : 1;
      Buffers.value[at] = value;
    }
    if (exact && !Buffers.valueLower.empty())
    {
      const Interval value = Enclosure(i * components, components);
      Buffers.valueLower[at] = value.lower;
      Buffers.valueUpper[at] = value.upper;
    }
  }

  /// Of the component that is shown, from those of all components.
  [[nodiscard]] Interval Enclosure(std::size_t first, std::size_t components) const
  {
    if (TheScene.component != Scene::kMagnitude || components == 1)
    {
      const std::size_t at = first + static_cast<std::size_t>(std::max(TheScene.component, 0));
      return { Lower[at], Upper[at] };
    }
    Interval sum(0.0);
    for (std::size_t at = first; at < first + components; ++at)
    {
      sum += Square({ Lower[at], Upper[at] });
    }
    return Sqrt(sum);
  }

  [[nodiscard]] double Component(std::span<const double> values) const
  {
    if (TheScene.component != Scene::kMagnitude || values.size() == 1)
    {
      return values[std::max(TheScene.component, 0)];
    }
    // hypot neither overflows nor underflows on the way.
    return std::accumulate(
      values.begin(), values.end(), 0.0, [](double sum, double v) { return std::hypot(sum, v); });
  }

  const Scene& TheScene;
  SampleBuffers& Buffers;
  FrameCounters& Counters;
  std::vector<Ray> Rays;
  std::vector<std::size_t> Place; ///< in the buffers
  std::vector<double> TMin;
  std::vector<double> T;
  std::vector<Vec3> Position;
  std::vector<int> Hit; ///< number of the surface
  std::vector<double> NextT;
  std::vector<Vec3> NextPosition;
  std::vector<std::int32_t> Element;
  std::vector<Verdict> Verdicts;
  std::vector<Vec3> Xi;
  std::vector<double> Values;
  std::vector<double> Lower;
  std::vector<double> Upper;
  std::vector<Owners> Found;
};
} // namespace

void TraceTile(const Scene& scene, const Camera& camera, const TileArea& area, double offset,
  SampleBuffers& buffers, FrameCounters& counters)
{
  TileWork(scene, camera, area, offset, buffers, counters).Run();
}
} // namespace pixelexact
