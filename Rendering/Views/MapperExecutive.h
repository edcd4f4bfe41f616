// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

class vtkAlgorithm;

namespace pixelexact
{
/// The executive of a mapper whose picture is not that of its input's cells. Whoever asks the
/// mapper for its input by VTK's own functions (vtkMapper::GetInput, GetInputDataObject) wants the
/// polygons that are seen: pickers, exporters. These would take the outside of the uncut mesh; so
/// they get an empty vtkPolyData and the mapper gives a warning. The pipeline itself is that of the
/// superclass, without its loop over the blocks of composite data.
class MapperExecutive : public vtkStreamingDemandDrivenPipeline
{
public:
  static MapperExecutive* New();
  vtkTypeMacro(MapperExecutive, vtkStreamingDemandDrivenPipeline);

  /// The input of an algorithm with any executive, null where there is none.
  static vtkDataObject* InputOf(vtkAlgorithm* algorithm);
  /// The next who asks is warned again.
  static void WarnAgain(vtkAlgorithm* algorithm);

  vtkDataObject* GetInputData(int port, int connection) override;
  vtkDataObject* GetInputData(int port, int connection, vtkInformationVector** inInfoVec) override;

  MapperExecutive(const MapperExecutive&) = delete;
  void operator=(const MapperExecutive&) = delete;

protected:
  MapperExecutive() = default;
  ~MapperExecutive() override = default;

  /// The input stays, as that of stock mappers of polygons does, where ReleaseDataFlag asks
  /// producers to release what was consumed: a mapper draws after its pipeline's update.
  void ExecuteDataEnd(vtkInformation* request, vtkInformationVector** inInfoVec,
    vtkInformationVector* outInfoVec) override;

private:
  vtkNew<vtkPolyData> Nothing;
  bool Warned = false;
};
} // namespace pixelexact
