// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "HighOrderModel.h"

#include <vtkSmartPointer.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

class vtkUnstructuredGrid;

namespace pixelexact
{
class Stopwatch;

/// An input, converted where it is plain.
struct LoadedModel
{
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  std::shared_ptr<HighOrderModel> model;
  bool converted = false;               ///< else the file carried our coefficients
  vtkIdType skippedCells = 0;           ///< of the file, that are no element
  std::vector<std::string> diagnostics; ///< what looks wrong in the file
};

/// Reads and converts, telling the seconds as stages "read" and "convert". Of a plain file only
/// `field` is converted, all of them where that is empty or not there. Throws Error, naming the
/// file.
LoadedModel LoadModel(
  const std::vector<std::string>& files, const std::string& field, Stopwatch& stopwatch);

/// Says on stderr what looks wrong in the file.
void WarnOfDiagnostics(const LoadedModel& input);

/// The field of that name; Error naming those that there are.
const Field& FieldNamed(const HighOrderModel& model, const std::string& name);

/// Such as " (3 components, order 4 to 6)", to follow the field's name.
std::string FieldKind(const Field& field);

/// The lowest and highest order of any element; (0, -1) when there is none.
std::array<int, 2> OrderRange(const Expansion& expansion);
/// "3" or "3 to 6".
std::string OrderText(const std::array<int, 2>& range);
} // namespace pixelexact
