// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Options.h"

#include "Core/Base/Error.h"

#include <vtkSmartPointer.h>

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

class vtkUnstructuredGrid;

namespace pixelexact
{
/// INPUT, and which of its time steps.
struct InputRequest
{
  std::vector<std::string> files;
  std::optional<int> step; ///< counted from 0
  std::optional<double> time;
  bool mayBeAll = false;            ///< --time-step takes "all"
  bool allSteps = false;            ///< one after the other
  bool gaussLobatto = false;        ///< where the nodes of VTK's Lagrange cells are, not equispaced
  std::optional<int> truncateOrder; ///< of all fields; none: they stay as they are
  bool mirroredWedges = false;      ///< MFEM's order of the nodes of VTK's Lagrange wedges
  bool cornerCells = true; ///< of solvers' grids, which have the coefficients; false: Lagrange cells
  bool timesAlone = false;          ///< readers return when they know the times, without a grid

  /// Declares INPUT as the command's positional arguments, and the options.
  void AddTo(CLI::App& command);
};

struct InputGrid
{
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  std::vector<double> times;      ///< of all steps, ascending; none: the input knows no time
  int step = 0;                   ///< the one that was read
  std::vector<std::string> notes; ///< lines for the user
};

/// While it lives, hears which part of a solver's file is read; where `progress` returns false,
/// reading may end, and what was read is of no use. Not nested, one thread.
class ReadListener
{
public:
  explicit ReadListener(std::function<bool(double)> progress);
  ~ReadListener();
  ReadListener(const ReadListener&) = delete;
  ReadListener& operator=(const ReadListener&) = delete;

  /// Tells the one that lives. Whether reading goes on.
  static bool Report(double part);
};

/// The file's suffix is of no format that is read.
class UnknownFormat : public Error
{
public:
  using Error::Error;
};

/// Reads INPUT, for all who do (the program, pixelexact.read): one mesh file and, where the format
/// keeps them apart, its field files; or a time series. The reader is chosen by the suffix of the
/// first. Throws Error, naming the file, when it cannot be read or its cells contradict its points,
/// or has no such time, UnknownFormat where there is no reader; UsageError when the files do not go
/// together.
InputGrid ReadInput(const InputRequest& request);

/// The times of INPUT's steps, ascending; empty: it knows no time. Throws as ReadInput.
std::vector<double> ReadTimes(InputRequest request);

/// Whether a file of this name holds fields without their mesh.
bool HoldsFieldsAlone(const std::string& file);

// For those who add formats.

/// Whether files with this suffix (".xml") hold a mesh of a format that is read.
bool IsMeshSuffix(const std::string& suffix);

/// Throws Error.
[[noreturn]] void CannotRead(const std::string& file, const std::string& why);

/// Throws UsageError where more than one file was given for a format that knows no other.
void CheckAlone(const std::vector<std::string>& files);

/// The step that is asked for: the first one without a request, the one nearest to a time. `times`
/// ascend; none: the input knows no time. Throws Error where there is no such step.
int ChooseStep(const InputRequest& request, std::span<const double> times);
} // namespace pixelexact
