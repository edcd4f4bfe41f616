// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Frames/FrameCompositor.h"
#include "HighOrderModel.h"
#include "PixelExactRenderingModule.h"

#include <cstdint>
#include <span>
#include <vector>

class vtkHardwareSelector;

// A frame as hardware selection needs it: numbers in place of colours.
namespace pixelexact
{
/// The colours of one pass of vtkHardwareSelector.
struct SelectionPass
{
  enum class Shows
  {
    Nothing, ///< a pass for points, which frames do not have
    Prop,    ///< one colour for all pixels
    Block,   ///< the flat index of the cell's block, for composite data
    CellLow, ///< the cell's number, its lower 24 bits
    CellHigh ///< the next 24 bits
  };
  Shows shows = Shows::Nothing;
  std::uint8_t color[3] = {}; ///< for Shows::Prop
  bool needsCells = false;    ///< pixels without a cell are drawn as a miss and hide what is behind
};

/// The colours that the current pass of the renderer's selector needs for this prop. Reports the
/// prop to the selector.
SelectionPass PassOf(vtkHardwareSelector* selector, const HighOrderModel& model);

/// The pixels for a compositor.
struct SelectionImage
{
  std::vector<std::uint8_t> rgba;
  std::vector<float> depths;
};

/// Takes, for each pixel, the nearest visible sample, translucent or not, as VTK's mappers do.
/// `cells`: HighOrderModel::SelectedCells. `blocks`: the model's.
PIXELEXACTRENDERING_EXPORT SelectionImage MakeSelectionImage(const SelectionPass& pass,
  const Frame& frame, const DepthRows& rows, std::span<const std::int64_t> cells,
  std::span<const HighOrderModel::Block> blocks);
} // namespace pixelexact
