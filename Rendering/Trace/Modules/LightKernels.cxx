// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Trace/Modules/LightKernels.cxx"
#include <hwy/foreach_target.h>

#include "Trace/LanePoint-inl.h"
#include "Trace/Modules/LightKernels.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// A matrix, with its columns in lanes.
struct Columns
{
  LanePoint column[3];

  explicit HWY_INLINE Columns(const Mat3& m)
    : column{ SplatPoint(m[0]), SplatPoint(m[1]), SplatPoint(m[2]) }
  {
  }
  [[nodiscard]] HWY_INLINE LanePoint Times(const LanePoint& x) const
  {
    return column[0] * x.x[0] + column[1] * x.x[1] + column[2] * x.x[2];
  }
};

// Sums in the same order as Lighting does for a single sample.
void Shine(const MattLights& lights, const LitSamples& samples)
{
  const LitView& view = lights.view;
  const Material& material = lights.material;
  const Columns linear(view.linear);
  const Columns toNormal(lights.normalMatrix);
  const LanePoint offset = SplatPoint(view.offset);
  const LanePoint eye = SplatPoint(view.eye);
  const LanePoint along = SplatPoint(view.direction);
  const LanePoint ambient = SplatPoint(material.ambientColor.value_or(Vec3(0.0)));
  const Lanes zero = Splat(0.0);
  for (int i = 0; i < samples.count; i += LaneCount())
  {
    const LanePoint normal = Normalized(toNormal.Times(LoadPoint<Lanes>(samples.normal, i)));
    LanePoint seen = along;
    if (!view.parallel)
    {
      seen = Normalized(linear.Times(LoadPoint<Lanes>(samples.position, i)) + offset - eye);
    }
    const LaneMask away = zero < Dot(normal, seen);
    LanePoint facing;
    ForEachAxis([&](auto d) PIXELEXACT_INLINED
      { facing.x[d] = Select(away, zero - normal.x[d], normal.x[d]); });
    LanePoint diffuse{ { zero, zero, zero } };
    for (const ParallelLight& light : lights.lights)
    {
      const Lanes falling = zero - Dot(facing, SplatPoint(light.direction));
      const LaneMask falls = zero < falling;
      const LanePoint color = SplatPoint(light.color);
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
