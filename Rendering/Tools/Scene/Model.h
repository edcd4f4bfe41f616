// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "HighOrderModel.h"

#include <nlohmann/json_fwd.hpp>
#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkUnstructuredGrid;

namespace pixelexact
{
class Stopwatch;
class Table;
class Truncation;
struct InputRequest;

/// An input, converted where it is plain.
struct LoadedModel
{
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  std::shared_ptr<HighOrderModel> model;
  /// The grid without the deformation of --warp; null where there is none.
  vtkSmartPointer<vtkUnstructuredGrid> undeformed;
  /// The grid before --warp and --phase, by which others need not read again.
  vtkSmartPointer<vtkUnstructuredGrid> source;
  std::int64_t elements = 0;            ///< of the whole input; the model may hold less of it
  bool converted = false;               ///< else the file carried our coefficients
  vtkIdType skippedCells = 0;           ///< of the file, that are no element
  std::vector<std::string> diagnostics; ///< what looks wrong in the file
  std::vector<double> times;            ///< of the time steps; none: the input knows no time
  int step = 0;                         ///< the one that this is
  /// Truncated fields by name; none: all fields are as in the file.
  std::map<std::string, std::shared_ptr<const Truncation>> truncations;
};

/// Reads and converts, reporting seconds of the stages "read" and "convert". Of a plain file only
/// `field` is converted, all of them where that is empty or not there. Throws Error, naming the
/// file.
/// `before`: what was read of another time step, whose mesh and locator it shares where its mesh is
/// the same.
LoadedModel LoadModel(const InputRequest& request, const std::string& field, Stopwatch& stopwatch,
  vtkUnstructuredGrid* before = nullptr);

/// The same input with the deformation, the phase and the truncation of another request.
LoadedModel Changed(const LoadedModel& before, const InputRequest& request);

/// Calls `visit` for the input at the requested time step, or at each one in order where all are
/// requested. Steps with the same mesh share mesh and locator. Throws as LoadModel, and Error where
/// all steps of an input without steps are requested.
void ForEachStep(const InputRequest& request, const std::string& field, Stopwatch& stopwatch,
  const std::function<void(const LoadedModel&)>& visit);

/// The name of a solution, whose last file is `name`: with the first file and the step where files
/// are time steps of which one is requested.
std::string SolutionName(
  const std::string& name, const InputRequest& request, const LoadedModel& input);

/// The time of the step; 0 where the input has no time.
double TimeOf(const LoadedModel& input);
/// Reports which time step this is; nothing where the input has no time.
void AddTime(Table& table, const LoadedModel& input);
void AddTime(nlohmann::ordered_json& summary, const LoadedModel& input);

/// A box that is proven to hold the mesh; one about 0 where there is no element.
Box3 BoxOf(const HighOrderModel& model);

/// Warns on stderr about errors in the file.
void WarnOfDiagnostics(const LoadedModel& input);

/// As HighOrderModel::GetField; where the name is empty the first one, with a note on stderr. The
/// model has one.
const Field& FieldOrFirst(const HighOrderModel& model, const std::string& name);

/// The field of an option that needs vectors. Throws Error where the model has none of this name,
/// or it has neither 3 nor, for vectors in a plane, 2 components.
const Field& VectorField(
  const HighOrderModel& model, const std::string& option, const std::string& name);

/// Such as " (3 components, order 4 to 6)", to follow the field's name.
std::string FieldKind(const Field& field);

/// The lowest and highest order of any element; (0, -1) when there is none.
std::array<int, 2> OrderRange(const Expansion& expansion);
/// "3" or "3 to 6".
std::string OrderText(const std::array<int, 2>& range);
} // namespace pixelexact
