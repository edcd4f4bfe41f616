// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/Input.h"

#include <span>
#include <string_view>

class vtkAlgorithm;
class vtkMultiBlockDataSet;

// Formats of several blocks. They throw as ReadInput.
namespace pixelexact
{
/// .e, .exo, .ex2, .exii, .g: element blocks and side sets as attributes; displacements are not
/// applied.
InputGrid ReadExodusFile(const InputRequest& request);
/// .cgns: all zones of all bases, by VTK's reader; refused where VTK was built without it.
InputGrid ReadCgnsFile(const InputRequest& request);

// Helpers of the readers of CGNS and Exodus files.

/// Throws Error, "it is no <what>", unless the file begins with one of the marks: libraries print,
/// or end the program, where they cannot open a file.
void RequireMark(
  const std::string& file, std::span<const std::string_view> marks, const char* what);
inline constexpr std::string_view kHdf5Mark = "\x89HDF\r\n\x1a\n";

/// The times that a reader offers; empty where it has none.
std::vector<double> TimesOf(vtkAlgorithm& reader);

/// Updates the reader to the requested step.
void UpdateToStep(vtkAlgorithm& reader, const InputRequest& request, InputGrid& input);

/// All blocks with cells as one grid, each with points of its own. Arrays that some blocks lack are
/// NaN there, which is noted. Throws Error where there is no block.
vtkSmartPointer<vtkUnstructuredGrid> JoinBlocks(
  vtkMultiBlockDataSet& blocks, const std::string& file, std::vector<std::string>& notes);
} // namespace pixelexact
