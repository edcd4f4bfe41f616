// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderLinearCut
 * @brief   a cut-surface as triangles with the fields at their corners: a linear baseline
 *
 * The cut-surface of a function is triangulated, as finely as asked for, and the fields are
 * evaluated at the triangles' corners: exact there, up to rounding, and only there. VTK's mappers
 * interpolate linearly between them. What that costs is what vtkHighOrderMapper is for.
 *
 * A plane becomes a grid of squares, each two triangles. Through any other function's surface cubes
 * are marched, and the corners brought onto the surface, to rounding; what lies between corners of
 * the cubes is missed. Triangles of which some corners are outside of
 * the mesh, or undecided, end where the mesh does, to 2^-16 of their sides; what lies between
 * corners of one kind, a hole or a tip smaller than a triangle, is not seen.
 *
 * Point data: the fields, and Element, Xi, Verdict and Residual as of vtkHighOrderProbe, of
 * composite data, which is one mesh, also Block.
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
