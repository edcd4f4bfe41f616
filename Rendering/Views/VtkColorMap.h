// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Modules/ColorMapping.h"

#include "vtkSmartPointer.h"

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

class vtkColorTransferFunction;
class vtkLookupTable;
class vtkScalarsToColors;

namespace pixelexact
{
/// VTK's own mapping of each value: range, log scale, and colours for NaN and outside the range are
/// the table's. With a log scale, values that are not positive get the colour of NaN. Builds the
/// table. The result keeps the table alive and may be called from several threads while nobody
/// changes it. Throws Error for a null table, a table without colours, and a range that
/// RequireRange refuses. Throws Unsupported for a table that maps vectors as RGB colours.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT ColorMap ToColorMap(vtkScalarsToColors* table);

/// The same for any range. Sets the table's range, so that scalar bars show it. A logarithmic table
/// refuses a range that is not positive, and keeps its own. Two objects of one table are the same
/// until the table is changed elsewhere.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::shared_ptr<const ColorTable> ColorTableOf(
  vtkScalarsToColors* table);

/// Throws Error, with the remedy, for a range of colours that is not finite or reversed. Tables
/// would give all values one colour, or those of the previous range.
PIXELEXACTRENDERING_EXPORT void RequireRange(const std::array<double, 2>& range);

/// Layer::component as VTK's mappers choose it: 0 for a field of one component, else the table's
/// vector component or the magnitude. For a null table, component 0, as for a new table. Throws
/// Error if the field lacks the component.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT int ComponentOf(
  vtkScalarsToColors* table, int fieldComponents);

/// Returns the names of the colour maps of MakeColorMap, without those of reversed maps.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::vector<std::string> ColorMapNames();

/// Returns whether MakeColorMap takes the name.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT bool HasColorMap(std::string_view name);

/// Returns a new colour map over [range[0], range[1]], as a table of 1024 colours. `name` with _r
/// after it reverses the map. The table differs from the published one of 256 colours, where there
/// is one, by at most 2 levels of 255. Values outside the range get the colours of the ends; NaN
/// gets a colour that is not in the map. Throws Error, listing the names, for an unknown name, and
/// for a range that is not finite or reversed.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT vtkSmartPointer<vtkLookupTable> MakeColorMap(
  const std::string& name, const std::array<double, 2>& range);

/// The same with the colours of a function over [0, 1]. `nan`: red, green and blue, 0 to 1.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT vtkSmartPointer<vtkLookupTable> MakeColorTable(
  vtkColorTransferFunction* colors, const std::array<double, 3>& nan,
  const std::array<double, 2>& range);
} // namespace pixelexact
