// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Mesh.h"

#include <cstdint>
#include <vector>

namespace pixelexact
{
/// A face of an element, numbered as in FacesOf(shape); element -1: none.
struct ElementFace
{
  std::int32_t element = -1;
  std::int32_t face = -1;

  auto operator<=>(const ElementFace&) const = default;
};

/// The faces of all elements of a mesh, numbered through.
class FaceNumbers
{
public:
  explicit FaceNumbers(const Mesh& mesh);

  [[nodiscard]] std::size_t Faces() const { return First.back(); }
  [[nodiscard]] std::size_t NumberOf(int element, int face) const
  {
    return First[static_cast<std::size_t>(element)] + static_cast<std::size_t>(face);
  }
  [[nodiscard]] int FacesOfElement(int element) const
  {
    const auto e = static_cast<std::size_t>(element);
    return static_cast<int>(First[e + 1] - First[e]);
  }
  [[nodiscard]] std::size_t MemoryUsage() const { return First.capacity() * sizeof(std::size_t); }

private:
  std::vector<std::size_t> First; ///< per element, and the number of all
};
} // namespace pixelexact
