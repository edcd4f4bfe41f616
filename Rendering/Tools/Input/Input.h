// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Options.h"

#include "Conversion/WarpRequest.h"
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
/// Reads FIELD or FIELD=SCALE, the value of this option.
void ReadWarp(const char* option, const std::string& text, WarpRequest& warp);

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
  bool surfaceElements = false;     ///< of files that mix them with solids
  bool cornerCells = true;          ///< cells of solvers' grids; false: Lagrange cells
  std::optional<WarpRequest> warp;  ///< how the mesh is deformed; without a direction
  std::vector<double> warpDirection; ///< of a scalar's displacement; empty: none
  std::optional<double> phase;       ///< in degrees, of complex fields
  bool timesAlone = false;           ///< readers return after reading the times, without a grid

  /// Declares INPUT as the command's positional arguments, and the options.
  void AddTo(CLI::App& command);
  /// The displacement by a field, with the direction that is given.
  [[nodiscard]] WarpRequest WarpBy(const std::string& field, double scale) const;
};

struct InputGrid
{
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  std::vector<double> times;      ///< of all steps, ascending; empty: the input has no time
  int step = 0;                   ///< the one that was read
  std::vector<std::string> notes; ///< lines for the user
};

/// Receives the progress of reading a solver's file during its lifetime. Where `progress` returns
/// false, reading may end, and its result must not be used. Must not be nested; for one thread.
class ReadListener
{
public:
  explicit ReadListener(std::function<bool(double)> progress);
  ~ReadListener();
  ReadListener(const ReadListener&) = delete;
  ReadListener& operator=(const ReadListener&) = delete;

  /// Reports progress to the current instance. Returns whether reading continues.
  static bool Report(double part);
};

/// No reader supports the file's suffix.
class UnknownFormat : public Error
{
public:
  using Error::Error;
};

/// Reads INPUT for the program and for pixelexact.read: one mesh file and, in formats with separate
/// field files, these; or a time series. The suffix of the first file chooses the reader. Throws
/// Error, naming the file, when it cannot be read, its cells contradict its points, or it has no
/// such time; UnknownFormat where there is no reader; UsageError when the files do not belong
/// together.
InputGrid ReadInput(const InputRequest& request);

/// The times of INPUT's steps, ascending; empty where it has no time. Throws as ReadInput.
std::vector<double> ReadTimes(InputRequest request);

/// Whether a file of this name holds fields without their mesh.
bool HoldsFieldsAlone(const std::string& file);

// Functions for readers of further formats.

/// Whether files with this suffix (".xml") hold a mesh of a format that is read.
bool IsMeshSuffix(const std::string& suffix);

/// Throws Error.
[[noreturn]] void CannotRead(const std::string& file, const std::string& why);

/// Throws UsageError where several files were given for a format of single files.
void CheckAlone(const std::vector<std::string>& files);

/// The requested step: the first one without a request, else the one nearest to a time. `times`
/// ascend; empty: the input has no time. Throws Error where there is no such step.
int ChooseStep(const InputRequest& request, std::span<const double> times);
} // namespace pixelexact
