// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Frame.h"

#include "Trace/BufferTable.h"

namespace pixelexact
{
void SampleBuffers::Allocate(Buffer wanted, int newWidth, int newHeight)
{
  width = newWidth;
  height = newHeight;
  ForEachBuffer(
    [&](const auto& row)
    {
      auto& values = this->*row.member;
      if (Has(wanted, row.buffer))
      {
        values.assign(Size(), row.nothing);
      }
      else
      {
        values = {};
      }
    });
  color.clear();
  behind.clear();
}

bool SampleBuffers::Holds(Buffer wanted) const
{
  bool holds = Size() > 0;
  ForEachBuffer([&](const auto& row)
    { holds = holds && (!Has(wanted, row.buffer) || !(this->*row.member).empty()); });
  return holds;
}
} // namespace pixelexact
