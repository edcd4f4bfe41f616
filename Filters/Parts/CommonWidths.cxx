// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/CommonWidths.h"

#include "Parts/LargestOfAll.h"

namespace pixelexact
{
PackedWidths CommonWidths(const PackedWidths& own, vtkMultiProcessController* controller)
{
  const bool several = controller != nullptr && controller->GetNumberOfProcesses() > 1;
  return several ? LargestOfAll(own, controller) : own;
}
} // namespace pixelexact
