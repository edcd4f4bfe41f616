// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderLinearResample
 * @brief   high-order fields resampled to a regular grid: a linear baseline
 *
 * Fields are exact at the nodes of the vtkImageData, up to rounding, and only there: VTK's filters
 * interpolate linearly between them. What that costs is what vtkHighOrderGrid is for.
 *
 * Nodes outside of the mesh, or undecided, hold NaN, have 0 in the point array vtkValidPointMask
 * and are blanked, as are the cells that touch them, so that vtkCutter, vtkContourFilter and others
 * leave them out. Of composite data of grids one image is made, of the fields that all of them
 * have. The output is a vtkUniformGrid, the vtkImageData whose blanking filters respect.
 */

#ifndef vtkHighOrderLinearResample_h
#define vtkHighOrderLinearResample_h

#include "FieldSelection.h"
#include "PixelExactFiltersModule.h"
#include "vtkImageAlgorithm.h"

#include <memory> // for the model
#include <string> // for names

namespace pixelexact
{
class ModelSource;
class WholeMesh;
} // namespace pixelexact

class PIXELEXACTFILTERS_EXPORT vtkHighOrderLinearResample : public vtkImageAlgorithm
{
public:
  static vtkHighOrderLinearResample* New();
  vtkTypeMacro(vtkHighOrderLinearResample, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Number of nodes along x, y and z; each at least 1. Default 64 each.
   */
  vtkSetVector3Macro(Dimensions, int);
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  ///@{
  /**
   * The box (xmin, xmax, ymin, ymax, zmin, zmax) whose corners are nodes. With xmin > xmax, the
   * default, the box of the grid's points.
   */
  vtkSetVector6Macro(SamplingBounds, double);
  vtkGetVector6Macro(SamplingBounds, double);
  ///@}

  ///@{
  /**
   * Names of the fields to resample; none: all. A name that the grid lacks is an error.
   */
  void AddField(const std::string& name) { this->Fields.Add(name); }
  void ClearFields() { this->Fields.Clear(); }
  ///@}

protected:
  vtkHighOrderLinearResample();
  ~vtkHighOrderLinearResample() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHighOrderLinearResample(const vtkHighOrderLinearResample&) = delete;
  void operator=(const vtkHighOrderLinearResample&) = delete;

  /// Throws Error. False where it was aborted.
  bool Resample(vtkDataObject* grid, vtkImageData* output);

  int Dimensions[3] = { 64, 64, 64 };
  double SamplingBounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  pixelexact::FieldSelection Fields{ this };
  std::unique_ptr<pixelexact::ModelSource> Source;
  std::unique_ptr<pixelexact::WholeMesh> Mesh;
};

#endif
