// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/SeveralProcesses.h"

#include "Base/Command.h"
#include "Base/Processes.h"
#include "Files/TimeSeries.h"
#include "Picture/RenderOptions.h"

#include <algorithm>

namespace pixelexact
{
void RefuseSeveralProcesses(const std::string& what)
{
  if (AreSeveralProcesses())
  {
    throw UsageError(what + ": is not shared by several processes; start one, without mpirun");
  }
}

void CheckForSeveralProcesses(const RenderOptions& options)
{
  const auto ofField = [](const RangeRule& range) { return range.of == RangeRule::Of::Field; };
  const auto layers = options.shot.MakeLayers();
  if (ofField(options.shot.colors.Range()) ||
    std::ranges::any_of(
      layers, [&](const LayerSettings& layer) { return layer.range && ofField(*layer.range); }))
  {
    RefuseSeveralProcesses("--range field, the range of all elements");
  }
  if (options.shot.edgesByKind)
  {
    RefuseSeveralProcesses("--edges-by-kind, which asks for all neighbours,");
  }
  if (options.outline.IsAsked())
  {
    RefuseSeveralProcesses("--mesh-outline, which draws all of the boundary,");
  }
  if (Has(options.debug.Needs(), Buffer::Jump))
  {
    RefuseSeveralProcesses("--show jumps, which asks for all neighbours,");
  }
  if (options.knobs.Stride() > 1)
  {
    RefuseSeveralProcesses("--stride");
  }
  if (options.shot.input.truncateOrder)
  {
    RefuseSeveralProcesses("--truncate-order, whose bound is that of all elements,");
  }
  if (LowerSuffix(options.shot.input.files.front()) == ".vtk")
  {
    RefuseSeveralProcesses("a legacy .vtk file");
  }
}
} // namespace pixelexact
