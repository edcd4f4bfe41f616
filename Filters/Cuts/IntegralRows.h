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

  /// The middle of the interval and a bound of its error; NaN and infinity where the interval is
  /// unbounded.
  [[nodiscard]] PIXELEXACTFILTERS_EXPORT double Middle() const;
  [[nodiscard]] PIXELEXACTFILTERS_EXPORT double Error() const;
};
[[nodiscard]] PIXELEXACTFILTERS_EXPORT std::vector<IntegralRow> RowsOf(
  const IntegralQuestion& question, const SurfaceIntegral& found);

/// One sentence for each reason why the rows do not cover the whole surface; empty where they do.
[[nodiscard]] PIXELEXACTFILTERS_EXPORT std::vector<std::string> DoubtsOf(
  const SurfaceIntegral& found, double tolerance);

/// The faces of the mesh's boundary with these attributes, in ascending order; without attributes
/// the whole boundary, with faces that other elements cover partly. Throws InvalidData for an
/// attribute that does not exist.
[[nodiscard]] std::vector<ElementFace> BoundaryOf(
  const HighOrderModel& model, std::span<const std::int32_t> attributes);

/// Integrates over the faces of the mesh's boundary with these attributes. Without attributes it
/// integrates over the whole boundary, where partly covered faces count whole. `question`: its mesh
/// must be the model's; its cut is ignored. Throws InvalidData for an attribute that does not
/// exist.
[[nodiscard]] PIXELEXACTFILTERS_EXPORT SurfaceIntegral IntegrateBoundary(
  const IntegralQuestion& question, std::span<const std::int32_t> attributes,
  const HighOrderModel& model, const IntegralEffort& effort);
} // namespace pixelexact
#endif
