// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/SelectionImage.h"

#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
void SetColor(std::int64_t number, std::uint8_t* color)
{
  for (int c = 0; c < 3; ++c)
  {
    color[c] = static_cast<std::uint8_t>(number >> (8 * c) & 0xff);
  }
}

bool IsExact(const SampleBuffers& sheet, std::size_t i)
{
  return sheet.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact);
}
} // namespace

SelectionPass PassOf(vtkHardwareSelector* selector, const HighOrderModel& model)
{
  SelectionPass pass;
  pass.needsCells = !selector->GetActorPassOnly();
  if (pass.needsCells && selector->GetFieldAssociation() == vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    return pass;
  }
  selector->BeginRenderProp();
  const std::span<const std::int64_t> cells = model.SelectedCells();
  selector->UpdateMaximumCellId(cells.empty() ? 0 : std::ranges::max(cells));
  switch (selector->GetCurrentPass())
  {
    case vtkHardwareSelector::CELL_ID_LOW24:
      pass.shows = SelectionPass::Shows::CellLow;
      break;
    case vtkHardwareSelector::CELL_ID_HIGH24:
      pass.shows = SelectionPass::Shows::CellHigh;
      break;
    case vtkHardwareSelector::COMPOSITE_INDEX_PASS:
      if (!model.Blocks().empty())
      {
        pass.shows = SelectionPass::Shows::Block;
        break;
      }
      // The index that VTK's mappers report for data of one block.
      selector->RenderCompositeIndex(1);
      [[fallthrough]];
    case vtkHardwareSelector::ACTOR_PASS:
    case vtkHardwareSelector::PROCESS_PASS:
      pass.shows = SelectionPass::Shows::Prop;
      std::transform(selector->GetPropColorValue(), selector->GetPropColorValue() + 3, pass.color,
        [](float part) { return static_cast<std::uint8_t>(std::lround(255.0F * part)); });
      break;
    default:
      break;
  }
  selector->EndRenderProp();
  return pass;
}

SelectionImage MakeSelectionImage(const SelectionPass& pass, const Frame& frame,
  const DepthRows& rows, std::span<const std::int64_t> cells,
  std::span<const HighOrderModel::Block> blocks)
{
  const std::size_t pixels = frame.centres.Size();
  SelectionImage image;
  image.rgba.assign(4 * pixels, 0);
  image.depths.assign(pixels, kNoDepth);
  const auto add = [&](const SampleBuffers& sheet)
  {
    std::vector<float> depths;
    WindowDepth(sheet, rows, depths);
    for (std::size_t i = 0; i < pixels; ++i)
    {
      if (image.depths[i] <= 1.0F || !(depths[i] <= 1.0F) || sheet.color[4 * i + 3] == 0)
      {
        continue;
      }
      image.depths[i] = depths[i];
      std::uint8_t* color = &image.rgba[4 * i];
      color[3] = 255;
      if (pass.needsCells && !IsExact(sheet, i))
      {
        continue;
      }
      const auto cell = [&] { return cells[static_cast<std::size_t>(sheet.element[i])]; };
      switch (pass.shows)
      {
        case SelectionPass::Shows::Prop:
          std::copy_n(pass.color, 3, color);
          break;
        case SelectionPass::Shows::Block:
          SetColor(HighOrderModel::BlockOf(sheet.element[i], blocks).flatIndex, color);
          break;
        case SelectionPass::Shows::CellLow:
          SetColor(cell(), color);
          break;
        case SelectionPass::Shows::CellHigh:
          SetColor(cell() >> 24, color);
          break;
        case SelectionPass::Shows::Nothing:
          break;
      }
    }
  };
  add(frame.centres);
  for (const SampleBuffers& sheet : frame.centres.behind)
  {
    add(sheet);
  }
  return image;
}
} // namespace pixelexact
