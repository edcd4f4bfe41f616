// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Frame.h"

#include <limits>

namespace pixelexact
{
void SampleBuffers::Allocate(Buffer wanted, int newWidth, int newHeight)
{
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  width = newWidth;
  height = newHeight;
  const auto size = [&](Buffer buffer) { return Has(wanted, buffer) ? Size() : 0; };
  value.assign(size(Buffer::Value), kNan);
  position.assign(size(Buffer::Position), Vec3(kNan));
  normal.assign(size(Buffer::Normal), Vec3(kNan));
  xi.assign(size(Buffer::Xi), Vec3(kNan));
  element.assign(size(Buffer::Element), -1);
  depth.assign(size(Buffer::Depth), std::numeric_limits<double>::infinity());
  verdict.assign(size(Buffer::Verdict), static_cast<std::uint8_t>(PixelVerdict::Nothing));
  owners.assign(size(Buffer::Coverage), -1);
  coverage.assign(size(Buffer::Coverage), kNotCovered);
  valueLower.assign(size(Buffer::Enclosure), kNan);
  valueUpper.assign(size(Buffer::Enclosure), kNan);
}
} // namespace pixelexact
