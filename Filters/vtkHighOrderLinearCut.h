// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderLinearCut
 * @brief   a cut-surface as triangles with the fields at their corners: a linear baseline
 *
 * Triangulates the zeros of a function at a given resolution and evaluates the fields at the
 * triangles' corners. Values are exact there, up to rounding. VTK's mappers interpolate linearly
 * between corners.
 *
 * A plane becomes a grid of squares, each divided into two triangles. Surfaces of other functions
 * are triangulated by marching cubes, and the corners are moved onto the surface, to rounding.
 * Parts of the surface between corners of the cubes are missed. Triangles that have corners outside
 * of the mesh, or undecided ones, end at the mesh's boundary, to 2^-16 of their sides. A hole or a
 * tip that is smaller than a triangle is missed.
 *
 * Point data: the fields, and Element, Xi, Verdict and Residual as in vtkHighOrderProbe; for
 * composite data, which are one mesh, also Block.
 */

#ifndef vtkHighOrderLinearCut_h
#define vtkHighOrderLinearCut_h

#include "FieldSelection.h"
#include "MeshFilter.h"
#include "PixelExactFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for the cut function

#include <string> // for names

class vtkImplicitFunction;

class PIXELEXACTFILTERS_EXPORT vtkHighOrderLinearCut
  : public PIXELEXACT_MESH_FILTER(vtkPolyDataAlgorithm)
{
public:
  static vtkHighOrderLinearCut* New();
  vtkTypeMacro(vtkHighOrderLinearCut, PIXELEXACT_MESH_FILTER(vtkPolyDataAlgorithm));
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Includes the cut function's.
  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * The function whose zeros are the cut-surface; there must be one.
   */
  void SetCutFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetCutFunction();
  ///@}

  ///@{
  /**
   * Of a plane: squares along the longer side of the rectangle about its part in the mesh's box.
   * Of others: cubes along the longest side of that box, above 64 rounded up to at most 64 times a
   * power of two. At least 1; default 256.
   */
  vtkSetClampMacro(Resolution, int, 1, 1000000);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Names of the fields that the output has; none: all. A name that the grid lacks is an error.
   */
  void AddField(const std::string& name) { this->Fields.Add(name); }
  void ClearFields() { this->Fields.Clear(); }
  ///@}

  ///@{
  /**
   * Of the last output: triangles that were cut where the mesh ends, and corners that could not be
   * brought onto the surface.
   */
  vtkGetMacro(NumberOfTrianglesAtTheRim, vtkIdType);
  vtkGetMacro(NumberOfPointsOffSurface, vtkIdType);
  ///@}

protected:
  vtkHighOrderLinearCut();
  ~vtkHighOrderLinearCut() override;

  void ResetReport() override;
  bool Make(vtkDataObject* mesh, Output* output) override;

private:
  vtkHighOrderLinearCut(const vtkHighOrderLinearCut&) = delete;
  void operator=(const vtkHighOrderLinearCut&) = delete;

  vtkSmartPointer<vtkImplicitFunction> CutFunction;
  int Resolution = 256;
  pixelexact::FieldSelection Fields{ this };
  vtkIdType NumberOfTrianglesAtTheRim = 0;
  vtkIdType NumberOfPointsOffSurface = 0;
};

#endif
