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

/// Requests the whole input in RequestUpdateExtent, for any requested piece of the output.
PIXELEXACTRENDERING_EXPORT void AskForWhole(vtkInformationVector* input);

/// The model of a grid, reconstructed when the grid changes or is replaced.
class PIXELEXACTRENDERING_EXPORT GridModel
{
public:
  /// The current model of a vtkUnstructuredGrid, or of a composite data set of these. Throws Error;
  /// then there is no model.
  const std::shared_ptr<HighOrderModel>& Of(vtkDataObject* grid);

  /// The model of the last call; null if there was none, or it failed.
  [[nodiscard]] const std::shared_ptr<HighOrderModel>& Last() const { return Model; }

  /// Count of constructed models.
  [[nodiscard]] std::int64_t Builds() const { return Count; }

private:
  std::shared_ptr<HighOrderModel> Model;
  std::int64_t Count = 0;
};
} // namespace pixelexact
