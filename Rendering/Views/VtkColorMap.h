// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Modules/ColorMapping.h"

#include "vtkSmartPointer.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

class vtkColorTransferFunction;
class vtkLookupTable;
class vtkScalarsToColors;

namespace pixelexact
{
/// VTK's own mapping of every single value: range, log scale, NaN, below- and above-range colours
/// are the table's. With a log scale values that are not above 0 have the colour of NaN. Builds the
/// table; the result keeps it alive and may be called from several threads as long as nobody
/// changes the table. Throws Error for a null table, one without colours, and where RequireRange
/// refuses its range; Unsupported for one that takes vectors for RGB colours.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT ColorMap ToColorMap(vtkScalarsToColors* table);

/// The same for any range, which the table gets: scalar bars show it. A logarithmic table refuses a
/// range that is not above 0, and keeps its own. Two are the same while nobody else changes the
/// table.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::shared_ptr<const ColorTable> ColorTableOf(
  vtkScalarsToColors* table);

/// Throws Error, with the remedy, for a range of colours that is not finite or runs backwards:
/// tables would give all values one colour, or those of the range before.
PIXELEXACTRENDERING_EXPORT void RequireRange(const std::array<double, 2>& range);

/// Layer::component as VTK's mappers choose it: 0 for a field of one component, else the table's
/// vector component or the magnitude. A null table chooses like a new one: component 0.
/// Throws Error when the field has no such component.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT int ComponentOf(
  vtkScalarsToColors* table, int fieldComponents);

/// Names of the colour maps that MakeColorMap knows.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::vector<std::string> ColorMapNames();

/// A new colour map over [range[0], range[1]], as a table of 1024 colours; values beyond take the
/// colours of the ends, NaN a colour that is not in the map. Throws Error listing the names for an
/// unknown one, and for a range that is not finite or runs backwards.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT vtkSmartPointer<vtkLookupTable> MakeColorMap(
  const std::string& name, const std::array<double, 2>& range);

/// The same of the colours of a function from 0 to 1; `nan`: red, green and blue, 0 to 1.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT vtkSmartPointer<vtkLookupTable> MakeColorTable(
  vtkColorTransferFunction* colors, const std::array<double, 3>& nan,
  const std::array<double, 2>& range);
} // namespace pixelexact
