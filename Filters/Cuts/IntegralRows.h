// SPDX-License-Identifier: BSD-3-Clause
#ifndef IntegralRows_h
#define IntegralRows_h

#include "PixelExactFiltersModule.h"

#include "Core/Integral/Integrate.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pixelexact
{
class HighOrderModel;

/// A quantity of a surface, and what it is proven to be.
struct IntegralRow
{
  std::string quantity; ///< "Area", "Integral", "Mean", of vectors "Integral 0", ..., "Flux"
  Interval value;       ///< infinite: nothing is known

  /// The middle, and how far it may be off; NaN and infinity where nothing is known.
  [[nodiscard]] PIXELEXACTFILTERS_EXPORT double Middle() const;
  [[nodiscard]] PIXELEXACTFILTERS_EXPORT double Error() const;
};
[[nodiscard]] PIXELEXACTFILTERS_EXPORT std::vector<IntegralRow> RowsOf(
  const IntegralQuestion& question, const SurfaceIntegral& found);

/// What keeps the rows from being the integrals over all of the surface, a sentence each; none:
/// nothing.
[[nodiscard]] PIXELEXACTFILTERS_EXPORT std::vector<std::string> DoubtsOf(
  const SurfaceIntegral& found, double tolerance);

/// Over the faces of the mesh's boundary with these attributes; of no attributes the whole
/// boundary, whose faces that are covered in part count whole. `question`: its mesh is the model's;
/// its cut is not looked at. Throws InvalidData for an attribute that is not there.
[[nodiscard]] PIXELEXACTFILTERS_EXPORT SurfaceIntegral IntegrateBoundary(
  const IntegralQuestion& question, std::span<const std::int32_t> attributes,
  const HighOrderModel& model, const IntegralEffort& effort);
} // namespace pixelexact
#endif
