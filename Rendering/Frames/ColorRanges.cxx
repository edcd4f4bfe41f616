// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/ColorRanges.h"

#include "HighOrderModel.h"
#include "Views/FieldRange.h"

#include "vtkScalarsToColors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
void Add(const ColorRanges::Range& range, ColorRanges::Range& sum)
{
  if (range)
  {
    sum = sum ? std::array{ std::min((*sum)[0], (*range)[0]), std::max((*sum)[1], (*range)[1]) }
              : *range;
  }
}
} // namespace

ColorRanges::Range ColorRanges::OfFields(const FrameRequest& request, vtkScalarsToColors* table)
{
  if (Model.lock() != request.model)
  {
    Known.clear();
    Model = request.model;
  }
  Range sum;
  for (const LayerRequest& layer : request.layers)
  {
    if (TableOf(layer) != table)
    {
      continue;
    }
    const Field& field = layer.field.In(*request.model);
    const int component = ComponentOf(layer, field);
    auto at = Known.find({ &field, component });
    if (at == Known.end())
    {
      // Nothing is kept where this throws, so that it throws the next time as well.
      const Range range = FieldRange(request.model->GetMesh(), field, component);
      at = Known.emplace(std::pair(&field, component), range).first;
    }
    Add(at->second, sum);
  }
  return sum;
}

bool ColorRanges::Set(vtkScalarsToColors* table, const std::array<double, 2>& range)
{
  const double* old = table->GetRange();
  if (std::equal(range.begin(), range.end(), old) ||
    (table->UsingLogScale() != 0 && !(range[0] > 0.0)))
  {
    return false;
  }
  table->SetRange(range.data());
  return true;
}

ColorRanges::Range ColorRanges::OfFrame(
  const Frame& frame, const FrameRequest& request, vtkScalarsToColors* table)
{
  const bool many = request.layers.size() > 1;
  double lower = std::numeric_limits<double>::infinity();
  double upper = -lower;
  const auto add = [&](const SampleBuffers& sheet)
  {
    for (std::size_t i = 0; i < sheet.value.size(); ++i)
    {
      const double value = sheet.value[i];
      if (std::isfinite(value) && TableOf(request.layers[many ? sheet.layer[i] : 0]) == table)
      {
        lower = std::min(lower, value);
        upper = std::max(upper, value);
      }
    }
  };
  add(frame.centres);
  std::ranges::for_each(frame.centres.behind, add);
  if (!(lower <= upper))
  {
    return std::nullopt;
  }
  std::array range{ lower, upper };
  for (const LayerRequest& layer : request.layers)
  {
    // Of several fields, the one whose values are rounded most.
    range = TableOf(layer) == table ? BeyondRounding(layer.field.In(*request.model), range) : range;
  }
  return range;
}
} // namespace pixelexact
