// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkHighOrderSurface.h"

namespace pixelexact
{
/// A surface of the command line for a mapper.
class GivenSurfaceOfLayer final : public vtkHighOrderSurface
{
public:
  static GivenSurfaceOfLayer* New();
  vtkTypeMacro(GivenSurfaceOfLayer, vtkHighOrderSurface);

  void Set(std::shared_ptr<const Surface> surface)
  {
    Given = std::move(surface);
    Modified();
  }
  std::shared_ptr<const Surface> MakeSurface(const std::shared_ptr<const HighOrderModel>& /*model*/,
    const SurfaceSearch& /*search*/) override
  {
    return Given;
  }

private:
  std::shared_ptr<const Surface> Given;
};
} // namespace pixelexact
