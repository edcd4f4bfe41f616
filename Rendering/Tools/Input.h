// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkUnstructuredGrid;

namespace CLI
{
class App;
}

namespace pixelexact
{
/// Reads INPUT: one mesh file and, where the format keeps them apart, its field files. The reader
/// is chosen by the suffix of the first. Throws Error, naming the file, when it cannot be read or
/// its cells contradict its points; UsageError when the files do not go together.
vtkSmartPointer<vtkUnstructuredGrid> ReadInput(const std::vector<std::string>& files);

/// Declares INPUT as the command's positional arguments.
void AddInputOption(CLI::App& command, std::vector<std::string>& files);
} // namespace pixelexact
