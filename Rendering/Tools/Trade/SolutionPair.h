// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/Input.h"
#include "Scene/Model.h"

#include "Trace/Compare/FieldDifference.h"

#include <string>

namespace pixelexact
{
class ColorOptions;
struct ShotOptions;
struct Shot;

/// A solution that is compared with a shot's solution.
struct OtherSolution
{
  LoadedModel input;
  const Field* field = nullptr;
  std::string name; ///< of its last file, with the time step where the input has several

  [[nodiscard]] Solution Of() const { return { &input.model->GetLocator(), field }; }
};

/// The name that distinguishes a solution from others: "p8.gf", "run.pvd step 3".
std::string SolutionName(const InputRequest& request, const LoadedModel& input);

/// Reads a solution. Mesh and locator are shared with the shot's where the meshes are the same.
/// `fieldName` as DifferenceOptions::FieldName. Throws Error, naming files and fields.
OtherSolution LoadOther(const InputRequest& request, const std::string& fieldName, const Shot& shot,
  Stopwatch& stopwatch);

/// The difference of the shot's only layer from another solution, with proven bounds, and the
/// buffers that the shot's colours need. Shows progress.
FieldDifference TraceDifferenceOf(
  const ColorOptions& colors, const Shot& shot, const OtherSolution& other);

/// The resolution of a solution.
struct SolutionSize
{
  std::int64_t elements = 0;
  std::array<int, 2> orders{}; ///< the lowest and highest of its field
  std::int64_t modes = 0;      ///< of a component, summed over the elements
  double length =
    0.0; ///< edge of a cube (of a plane mesh: square) of an element's share of the box
  int dimensions = 3;
};
SolutionSize SizeOf(const LoadedModel& input, const Field& field);
} // namespace pixelexact
