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
#include "MeshFilter.h"
#include "PixelExactFiltersModule.h"
#include "vtkImageAlgorithm.h"

#include <string> // for names

class PIXELEXACTFILTERS_EXPORT vtkHighOrderLinearResample
  : public PIXELEXACT_MESH_FILTER(vtkImageAlgorithm)
{
public:
  static vtkHighOrderLinearResample* New();
  vtkTypeMacro(vtkHighOrderLinearResample, PIXELEXACT_MESH_FILTER(vtkImageAlgorithm));
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

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool Make(vtkDataObject* mesh, Output* output) override;

private:
  vtkHighOrderLinearResample(const vtkHighOrderLinearResample&) = delete;
  void operator=(const vtkHighOrderLinearResample&) = delete;

  int Dimensions[3] = { 64, 64, 64 };
  double SamplingBounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  pixelexact::FieldSelection Fields{ this };
};

#endif
