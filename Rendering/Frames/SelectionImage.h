// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Frames/FrameCompositor.h"
#include "HighOrderModel.h"
#include "PixelExactRenderingModule.h"

#include <cstdint>
#include <span>
#include <vector>

class vtkHardwareSelector;

// What hardware selection sees of a frame: numbers in the place of colours.
namespace pixelexact
{
/// The colour of `pass`, one of vtkHardwareSelector's, for a cell.
struct SelectionPass
{
  enum class Shows
  {
    Nothing, ///< the pass is of points, and there are none
    Prop,    ///< one colour for all pixels
    Block,   ///< of composite data: the flat index of the cell's block
    CellLow, ///< the cell's number, its lower 24 bits
    CellHigh ///< the 24 bits above these
  };
  Shows shows = Shows::Nothing;
  std::uint8_t color[3] = {}; ///< of Shows::Prop
  bool needsCells = false;    ///< pixels without a cell are a miss, and hide what is behind
};

/// What the present pass of the renderer's selector wants of a prop of ours, which it is told of.
SelectionPass PassOf(vtkHardwareSelector* selector, const HighOrderModel& model);

/// Pixels for a compositor.
struct SelectionImage
{
  std::vector<std::uint8_t> rgba;
  std::vector<float> depths;
};

/// Of each pixel the nearest sample that is shown, translucent or not, as VTK's own mappers are
/// selected. `cells`: HighOrderModel::SelectedCells; `blocks` as the model's.
PIXELEXACTRENDERING_EXPORT SelectionImage MakeSelectionImage(const SelectionPass& pass,
  const Frame& frame, const DepthRows& rows, std::span<const std::int64_t> cells,
  std::span<const HighOrderModel::Block> blocks);
} // namespace pixelexact
