// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Trace/Modules/LightKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Element/Matrix-inl.h"
#include "Trace/Modules/LightKernels.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
// Sums and products are rounded one by one, in the order in which Lighting makes those of a sample
// alone.
using LitPoint = Point<Lanes>;

HWY_INLINE LitPoint SplatPoint(const Vec3& x)
{
  return { { Splat(x.x), Splat(x.y), Splat(x.z) } };
}

HWY_INLINE Lanes Dot(const LitPoint& a, const LitPoint& b)
{
  return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2];
}

HWY_INLINE LitPoint UnitOf(const LitPoint& x)
{
  const Lanes scale = Splat(1.0) / Sqrt(Dot(x, x));
  return { { x.x[0] * scale, x.x[1] * scale, x.x[2] * scale } };
}

HWY_INLINE LitPoint LoadAt(const std::array<const double*, 3>& from, int i)
{
  using Traits = NumberTraits<Lanes>;
  return { { Traits::Load(from[0] + i), Traits::Load(from[1] + i), Traits::Load(from[2] + i) } };
}

/// A matrix, its columns in lanes.
struct Columns
{
  LitPoint column[3];

  explicit HWY_INLINE Columns(const Mat3& m)
    : column{ SplatPoint(m[0]), SplatPoint(m[1]), SplatPoint(m[2]) }
  {
  }
  [[nodiscard]] HWY_INLINE LitPoint Times(const LitPoint& x) const
  {
    LitPoint y;
    ForEachAxis([&](auto d) PIXELEXACT_INLINED
      { y.x[d] = column[0].x[d] * x.x[0] + column[1].x[d] * x.x[1] + column[2].x[d] * x.x[2]; });
    return y;
  }
};

void Shine(const MattLights& lights, const LitSamples& samples)
{
  const LitView& view = lights.view;
  const Material& material = lights.material;
  const Columns linear(view.linear);
  const Columns toNormal(lights.normalMatrix);
  const LitPoint offset = SplatPoint(view.offset);
  const LitPoint eye = SplatPoint(view.eye);
  const LitPoint along = SplatPoint(view.direction);
  const LitPoint ambient = SplatPoint(material.ambientColor.value_or(Vec3(0.0)));
  const Lanes zero = Splat(0.0);
  for (int i = 0; i < samples.count; i += LaneCount())
  {
    const LitPoint normal = UnitOf(toNormal.Times(LoadAt(samples.normal, i)));
    LitPoint seen = along;
    if (!view.parallel)
    {
      LitPoint way = linear.Times(LoadAt(samples.position, i));
      ForEachAxis(
        [&](auto d) PIXELEXACT_INLINED { way.x[d] = (way.x[d] + offset.x[d]) - eye.x[d]; });
      seen = UnitOf(way);
    }
    const LaneMask away = zero < Dot(normal, seen);
    LitPoint facing;
    ForEachAxis([&](auto d) PIXELEXACT_INLINED
      { facing.x[d] = Select(away, zero - normal.x[d], normal.x[d]); });
    LitPoint diffuse{ { zero, zero, zero } };
    for (const ParallelLight& light : lights.lights)
    {
      const Lanes falling = zero - Dot(facing, SplatPoint(light.direction));
      const LaneMask falls = zero < falling;
      const LitPoint color = SplatPoint(light.color);
      ForEachAxis([&](auto d) PIXELEXACT_INLINED
        { diffuse.x[d] = diffuse.x[d] + Select(falls, falling * color.x[d], zero); });
    }
    Lanes sum = normal.x[0] + normal.x[1] + normal.x[2];
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        const auto c = static_cast<std::size_t>(d);
        const Lanes color = NumberTraits<Lanes>::Load(samples.color[c] + i);
        const Lanes lit = Splat(material.ambient) * (material.ambientColor ? ambient.x[d] : color) +
          Splat(material.diffuse) * diffuse.x[d] * color;
        sum = sum + lit;
        Store(lit, samples.color[c] + i);
      });
    Store(Select(IsFinite(sum), Splat(1.0), zero), samples.isLit + i);
  }
}

const LightKernels& LightTable()
{
  static constexpr LightKernels kTable{ &Shine };
  return kTable;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(LightTable);

const LightKernels& GetLightKernels()
{
  return HWY_DYNAMIC_DISPATCH(LightTable)();
}
} // namespace pixelexact
#endif
