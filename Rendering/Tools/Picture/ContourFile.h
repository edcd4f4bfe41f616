// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
} // namespace CLI

namespace pixelexact
{
class Surface;
struct ContourSet;
struct Shot;

/// Contours as polylines, for other programs: see vtkHighOrderContour.
struct ContourFileOptions
{
  std::string file;                ///< empty: none
  std::optional<double> tolerance; ///< world units; none: 1e-4 of the diagonal of the mesh's box

  void AddTo(CLI::App& added);
};

/// Throws Error, naming the option and the remedy, for a shot with a surface that has no
/// polynomial, or without a field.
void CheckContourSurfaces(const Shot& shot);

/// The contours of a layer whose surface CheckContourSurfaces accepts, for these values.
ContourSet ContoursOfLayer(
  const Shot& shot, std::size_t layer, const std::vector<double>& values, double tolerance);

/// Writes the contours of each layer's field on its surface, for these values by layer, as a `.vtp`
/// file with a cell array Layer. Warns about lines that are not certified. Throws Error when the
/// file cannot be written.
void WriteContours(const ContourFileOptions& options, const Shot& shot,
  const std::vector<std::vector<double>>& values);
} // namespace pixelexact
