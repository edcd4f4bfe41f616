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
  /// -1: the Euclidean norm of all components, which of a single one is itself, sign and all.
  int component = 0;
  const CutFunction* cut = nullptr;
  /// The part of the surface that counts: where none of these is positive.
  std::span<const ImplicitPolynomial> clips{};

  [[nodiscard]] bool IsMagnitude() const { return component < 0 && field->values.components > 1; }
  /// The one that is contoured, where that is not the norm.
  [[nodiscard]] int Component() const { return component < 0 ? 0 : component; }
};
} // namespace pixelexact
