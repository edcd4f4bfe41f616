// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellElements_h
#define CellElements_h

#include "ArrayViews.h"
#include "Core/Element/Mesh.h"
#include "Fingerprint.h"

#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <string>
#include <vector>

class vtkUnstructuredGrid;

namespace pixelexact
{
/// Maps each cell of a grid to a stored element.
class CellElements
{
public:
  /// `elements` is the number of stored elements. Throws StaleData where cells were added or two
  /// cells claim one element.
  CellElements(vtkUnstructuredGrid* grid, vtkIdType elements);

  [[nodiscard]] std::size_t Cells() const { return Element.size(); }

  /// Returns the cell of each stored element, -1 where the cell was dropped.
  [[nodiscard]] std::vector<std::int32_t> CellOfElements(vtkIdType elements) const;

  /// Whether the fingerprint of each cell is that of its element. Both hashes are accepted: the
  /// present one and that of the first versions.
  [[nodiscard]] bool Fit(const std::function<std::vector<std::int64_t>(Hash)>& now,
    std::span<const std::int64_t> then) const;

  /// Throws StaleData with `problem` and the remedy for the first cell of `grid` that does not fit.
  void Compare(vtkUnstructuredGrid* grid, const std::function<std::vector<std::int64_t>(Hash)>& now,
    std::span<const std::int64_t> then, const std::string& problem) const;

  /// Returns `values`, with `stride` entries per element, in the order of the cells. Copies them
  /// only where that order differs from the stored one.
  template <class T>
  std::span<const T> Select(
    std::span<const T> values, std::deque<std::vector<T>>& copies, int stride = 1) const
  {
    if (Whole)
    {
      return values;
    }
    auto& copy = copies.emplace_back();
    copy.reserve(Element.size() * stride);
    for (const auto element : Element)
    {
      const auto from = values.subspan(element * stride, stride);
      copy.insert(copy.end(), from.begin(), from.end());
    }
    return copy;
  }

private:
  /// The first cell that does not fit, or the number of cells.
  [[nodiscard]] std::size_t FirstMisfit(const std::function<std::vector<std::int64_t>(Hash)>& now,
    std::span<const std::int64_t> then) const;

  std::vector<std::int64_t> Element;
  bool Whole = false; ///< cell i is element i
};

/// Owns what views of a grid point to: its arrays, and copies where the cells have another order.
struct ViewStorage
{
  ArrayKeeper arrays;
  std::deque<std::vector<Space>> spaces;
  std::deque<std::vector<std::int32_t>> ints;
  std::deque<std::vector<std::int64_t>> longs;
  std::deque<std::vector<double>> doubles;

  Expansion Assemble(ExpansionView view, const CellElements& cells, int components);
};
} // namespace pixelexact
#endif
