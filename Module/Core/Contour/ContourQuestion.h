// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/CutFunction.h"
#include "Core/Element/Mesh.h"

namespace pixelexact
{
/// A field to contour on a cut-surface of a mesh. The views must outlive the object.
struct ContourQuestion
{
  Mesh mesh;
  const Field* field = nullptr; ///< Mapping::Identity
  /// -1: the Euclidean norm of all components. For a field of one component this is the component
  /// itself, with its sign.
  int component = 0;
  const CutFunction* cut = nullptr;
  /// The surface counts only where none of these polynomials is positive.
  std::span<const ImplicitPolynomial> clips{};

  [[nodiscard]] bool IsMagnitude() const { return component < 0 && field->values.components > 1; }
  /// The component to contour, if it is not the norm.
  [[nodiscard]] int Component() const { return component < 0 ? 0 : component; }
};
} // namespace pixelexact
