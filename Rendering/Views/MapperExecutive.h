// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

class vtkAlgorithm;

namespace pixelexact
{
/// The executive of a mapper that does not draw its input's cells. Callers of vtkMapper::GetInput
/// and GetInputDataObject, such as pickers and exporters, expect the visible polygons and would
/// take the outside of the uncut mesh. They get an empty vtkPolyData, and the mapper warns. The
/// pipeline itself is that of the superclass, without its loop over the blocks of composite data.
class MapperExecutive : public vtkStreamingDemandDrivenPipeline
{
public:
  static MapperExecutive* New();
  vtkTypeMacro(MapperExecutive, vtkStreamingDemandDrivenPipeline);

  /// The input of an algorithm with any executive; null if there is none.
  static vtkDataObject* InputOf(vtkAlgorithm* algorithm);
  /// Makes the next such call warn a second time.
  static void WarnAgain(vtkAlgorithm* algorithm);

  vtkDataObject* GetInputData(int port, int connection) override;
  vtkDataObject* GetInputData(int port, int connection, vtkInformationVector** inInfoVec) override;

  MapperExecutive(const MapperExecutive&) = delete;
  void operator=(const MapperExecutive&) = delete;

protected:
  MapperExecutive() = default;
  ~MapperExecutive() override = default;

  /// Keeps the input, as stock mappers of polygons do, even if ReleaseDataFlag requests its
  /// release, because a mapper draws after its pipeline's update.
  void ExecuteDataEnd(vtkInformation* request, vtkInformationVector** inInfoVec,
    vtkInformationVector* outInfoVec) override;

private:
  vtkNew<vtkPolyData> Nothing;
  bool Warned = false;
};
} // namespace pixelexact
