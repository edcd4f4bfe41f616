// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"

#include <cstdint>
#include <memory>

class vtkDataObject;
class vtkInformationVector;

namespace pixelexact
{
class HighOrderModel;

/// RequestUpdateExtent: all of what is connected, whatever piece of the output is asked for.
PIXELEXACTRENDERING_EXPORT void AskForWhole(vtkInformationVector* input);

/// The model of somebody's grid, made anew when that is another one or has changed.
class PIXELEXACTRENDERING_EXPORT GridModel
{
public:
  /// The model of a vtkUnstructuredGrid, or of composite data of such, as it is now. Throws Error,
  /// after which there is none.
  const std::shared_ptr<HighOrderModel>& Of(vtkDataObject* grid);

  /// The model of the last call; null: there was none, or it failed.
  [[nodiscard]] const std::shared_ptr<HighOrderModel>& Last() const { return Model; }

  /// How many were made.
  [[nodiscard]] std::int64_t Builds() const { return Count; }

private:
  std::shared_ptr<HighOrderModel> Model;
  std::int64_t Count = 0;
};
} // namespace pixelexact
