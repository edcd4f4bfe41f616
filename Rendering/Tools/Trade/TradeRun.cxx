// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/TradeRun.h"

#include "Scene/Shot.h"

#include "Core/Base/Error.h"
#include "HighOrderModel.h"

#include <vtkUnstructuredGrid.h>

namespace pixelexact
{
const char* Name(TradeFamily family)
{
  switch (family)
  {
    case TradeFamily::Cut:
      return "cut";
    case TradeFamily::Resample:
      return "resample";
    case TradeFamily::Subdivide:
      return "subdivide";
    case TradeFamily::Cells:
      return "cells";
    case TradeFamily::Gradient:
      return "gradient";
    case TradeFamily::GradientCells:
      return "gradient-cells";
    default:
      return "exact";
  }
}

bool IsOfGradientFilter(TradeFamily family)
{
  return family == TradeFamily::Gradient || family == TradeFamily::GradientCells;
}

FreshModel::FreshModel(const Shot& shot)
  : grid(vtkSmartPointer<vtkUnstructuredGrid>::Take(shot.input.grid->NewInstance()))
{
  // Copies the arrays, because models with the same arrays share bounds and trees.
  grid->DeepCopy(shot.input.grid);
  model = HighOrderModel::From(grid.Get());
}

std::unique_ptr<TradeRun> MakeRun(const TradeScene& scene, const TradeSetting& setting)
{
  if (setting.family == TradeFamily::Exact)
  {
    return MakeExactRun(scene, setting);
  }
  if (IsOfGradientFilter(setting.family))
  {
    if (const std::string obstacle = GradientObstacle(scene); !obstacle.empty())
    {
      throw Unsupported(obstacle);
    }
  }
  if (IsOfPieces(scene))
  {
    return MakePiecesRun(scene, setting);
  }
  return IsOfFaces(scene) ? MakeFacesRun(scene, setting) : MakeLinearRun(scene, setting);
}
} // namespace pixelexact
