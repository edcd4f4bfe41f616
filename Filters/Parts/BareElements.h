// SPDX-License-Identifier: BSD-3-Clause
#ifndef BareElements_h
#define BareElements_h

#include "vtkBoundingBox.h"
#include "vtkType.h"

#include <vector>

namespace pixelexact
{
class HighOrderModel;

/// The faces of an element that have something behind them, as bits.
unsigned char InnerOf(const HighOrderModel& model, int element);
/// The same of all elements.
std::vector<unsigned char> InnerOfAll(const HighOrderModel& model);

/// The elements with other faces, in their order. `inner`: InnerOfAll.
std::vector<vtkIdType> BareElements(
  const HighOrderModel& model, const std::vector<unsigned char>& inner);

/// The box of the elements, with some room.
vtkBoundingBox BoxAround(const HighOrderModel& model);
} // namespace pixelexact
#endif
