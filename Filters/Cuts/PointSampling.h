// SPDX-License-Identifier: BSD-3-Clause
#ifndef PointSampling_h
#define PointSampling_h

#include "Grids/FilterWork.h"
#include "HighOrderModel.h"

#include "Core/Base/Verdict.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkPointData;

namespace pixelexact
{
struct SamplingOptions
{
  std::vector<std::string> fields; ///< none: all
  bool gradients = false;
  bool enclosures = false;
};

/// Locates points once, then evaluates any number of fields there. Parallel.
class PointSampling
{
public:
  /// Bytes per point, without the arrays that AddFields adds.
  static constexpr double kBytesPerPoint = 66.0;

  /// Locates `points`, reporting to `progress`.
  PointSampling(
    const HighOrderModel& model, std::vector<Vec3> points, const StepProgress& progress = {});

  /// Whether `progress` aborted the location. The functions below must not be called then.
  [[nodiscard]] bool IsAborted() const { return Aborted; }

  /// Adds to `output`, one tuple per point: each field (NaN where not inside) and, on request,
  /// <field>_Gradient (3 per component, d/dx, d/dy, d/dz in world units), <field>_lower and
  /// <field>_upper (see EncloseValues). Returns false where `progress` aborted it. Throws
  /// InvalidData for a field that does not exist and, as the other two, for an array name that is
  /// taken.
  bool AddFields(
    const SamplingOptions& options, vtkPointData* output, const StepProgress& progress = {}) const;

  /// Adds Xi (reference coordinates, NaN where not inside), Element (number of the source cell, -1
  /// outside, a candidate where undecided), Verdict (0 outside, 1 inside, 2 unknown) and Residual
  /// (the last correction of Newton's iteration, in xi). For composite data it adds Block (flat
  /// index, -1 where Element is -1).
  void AddLocations(vtkPointData* output) const;

  /// Adds Owners (int, preimages in all elements) and Coverage (unsigned char: 0 none, 1 once, 2
  /// several, 3 undecided; see Owners.h).
  void AddOwners(vtkPointData* output) const;

  [[nodiscard]] std::span<const Verdict> Verdicts() const { return verdicts_; }

private:
  /// Calls work(run) for the runs of points in an element. Only the calling thread reports
  /// progress.
  template <class Work>
  bool ForRuns(const StepProgress& progress, const Work& work) const;
  bool AddField(
    const Field& field, bool gradients, vtkPointData* output, const StepProgress& progress) const;
  void AddBlocks(vtkPointData* output) const;
  bool AddEnclosures(const Field& field, vtkPointData* output, const StepProgress& progress) const;

  const HighOrderModel& Model;
  bool Aborted = false;
  std::vector<Vec3> Points;
  std::vector<std::int32_t> Element;
  std::vector<Vec3> Xi;
  std::vector<Verdict> verdicts_;
  std::vector<double> Residual;
  std::vector<int> Order;  ///< points inside, sorted by element
  std::vector<int> Starts; ///< of the elements' runs in Order, and the end
};

std::vector<Vec3> PointsOf(vtkDataSet* data);
} // namespace pixelexact
#endif
