// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/LaneBuffer.h"
#include "Core/Element/Mesh.h"

#include <array>
#include <span>
#include <vector>

namespace pixelexact
{
/// Phi(xi), and its Jacobian where wanted, of some points of an element, in the element's units.
class MappedPoints
{
public:
  MappedPoints(const Mesh& mesh, int element, std::span<const Vec3> xi, bool withJacobians)
    : Stride(static_cast<std::size_t>(PaddedCount(static_cast<int>(xi.size()))))
    , Storage((withJacobians ? 12 : 3) * Stride)
  {
    double* arrays[12];
    for (std::size_t k = 0; k < Storage.size() / Stride; ++k)
    {
      arrays[k] = &Storage[k * Stride];
    }
    const Space& space = mesh.map.SpaceOf(element);
    const KernelSet kernels = KernelsFor(space);
    const LaneBuffer lanes(xi);
    const double* const coefficients = mesh.map.Coefficients(element);
    if (withJacobians)
    {
      kernels.gradient(space, coefficients, 3, lanes.View(), arrays, arrays + 3);
    }
    else
    {
      kernels.value(space, coefficients, 3, lanes.View(), arrays);
    }
  }
  [[nodiscard]] Vec3 At(std::size_t i) const
  {
    return { Storage[i], Storage[Stride + i], Storage[2 * Stride + i] };
  }
  /// Of the Jacobian, entry by entry, row by row.
  [[nodiscard]] std::array<const double*, 9> Jacobians() const
  {
    std::array<const double*, 9> columns;
    for (std::size_t k = 0; k < columns.size(); ++k)
    {
      columns[k] = &Storage[(3 + k) * Stride];
    }
    return columns;
  }
  [[nodiscard]] Mat3 Jacobian(std::size_t i) const
  {
    Mat3 jacobian;
    for (int c = 0; c < 3; ++c)
    {
      for (int d = 0; d < 3; ++d)
      {
        jacobian[d][c] = Storage[static_cast<std::size_t>(3 + 3 * c + d) * Stride + i];
      }
    }
    return jacobian;
  }

private:
  std::size_t Stride;
  std::vector<double> Storage;
};
} // namespace pixelexact
