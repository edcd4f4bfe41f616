// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/CutFunction.h"
#include "Core/Element/Mesh.h"

namespace pixelexact
{
/// What is contoured on which surface. The views must outlive whoever holds it.
struct ContourQuestion
{
  Mesh mesh;
  const Field* field = nullptr; ///< Mapping::Identity
  int component = 0;            ///< -1: the Euclidean norm of all components
  const CutFunction* cut = nullptr;

  [[nodiscard]] bool IsMagnitude() const { return component < 0; }
};
} // namespace pixelexact
