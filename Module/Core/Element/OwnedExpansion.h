// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Mesh.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <vector>

namespace pixelexact
{
/// Coefficients in one block of malloc's memory, which others can take over without a copy. They
/// are not initialised. Throws std::bad_alloc where memory runs out.
class CoefficientBlock
{
public:
  CoefficientBlock() = default;
  explicit CoefficientBlock(std::size_t size);

  [[nodiscard]] std::size_t size() const { return Count; }
  [[nodiscard]] double* data() { return Values.get(); }
  [[nodiscard]] const double* data() const { return Values.get(); }
  [[nodiscard]] double* begin() { return data(); }
  [[nodiscard]] const double* begin() const { return data(); }
  [[nodiscard]] double* end() { return data() + Count; }
  [[nodiscard]] const double* end() const { return data() + Count; }

  /// Keeps the first `size` coefficients, and returns the memory of the others.
  void Shrink(std::size_t size);

  /// The memory, which the caller frees by std::free. The block is empty then.
  [[nodiscard]] double* Release();

private:
  struct Free
  {
    void operator()(double* values) const { std::free(values); }
  };
  std::unique_ptr<double[], Free> Values;
  std::size_t Count = 0;
};

/// Expansion that owns its arrays.
struct OwnedExpansion
{
  std::vector<Space> spaces;         ///< the distinct spaces
  std::vector<std::int32_t> spaceOf; ///< per element, index into spaces
  std::vector<std::int64_t> offset;  ///< per element
  CoefficientBlock coefficients;
  int components = 1;

  /// Sets `offset` for elements that follow each other, and allocates their coefficients, by
  /// `spaces`, `spaceOf` and `components`.
  void Allocate();

  /// Sets the spaces of the elements and allocates their coefficients.
  void Allocate(std::span<const Space> spaceOfElement, int numberOfComponents);

  [[nodiscard]] const Space& SpaceOf(std::size_t element) const
  {
    return spaces[static_cast<std::size_t>(spaceOf[element])];
  }

  /// Coefficients of an element, component by component.
  [[nodiscard]] std::span<double> Coefficients(std::size_t element)
  {
    return { coefficients.data() + offset[element], SizeOf(element) };
  }
  [[nodiscard]] std::span<const double> Coefficients(std::size_t element) const
  {
    return { coefficients.data() + offset[element], SizeOf(element) };
  }

  [[nodiscard]] Expansion View() const
  {
    return { spaces, spaceOf, offset, coefficients, components };
  }

private:
  [[nodiscard]] std::size_t SizeOf(std::size_t element) const
  {
    return static_cast<std::size_t>(SpaceOf(element).Modes()) *
      static_cast<std::size_t>(components);
  }
};
} // namespace pixelexact
