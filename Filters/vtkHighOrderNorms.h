// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderNorms
 * @brief   L1, L2 and Linf of a high-order field over a mesh, and over each element
 *
 * The input is a grid with high-order coefficients, a plain vtkUnstructuredGrid, which is
 * converted, or composite data of such grids, which are joined. The field may be an expression,
 * such as an error `u - sin(x)`; |f| is the Euclidean norm where it has several components. The
 * output is a table with a row for each element: `Element`, the number of its cell in the source;
 * `Volume` (of a plane mesh the area), `L1`, `L2`, `L2Error`, `Largest` (at the samples). All
 * numbers of an element are NaN where a value is not finite.
 *
 * Integrals are numeric: Gauss rules of two numbers of points, whose difference estimates the
 * error; boxes are subdivided until it is at most 1e-6 of the integral, or 4 million evaluations
 * were added.
 * Linf is proven (LinfLower, LinfUpper) where the field has a proven range.
 */

#ifndef vtkHighOrderNorms_h
#define vtkHighOrderNorms_h

#include "MeshFilter.h"
#include "PixelExactFiltersModule.h"
#include "vtkTableAlgorithm.h"

#include <string> // for the name

class PIXELEXACTFILTERS_EXPORT vtkHighOrderNorms : public PIXELEXACT_MESH_FILTER(vtkTableAlgorithm)
{
public:
  static vtkHighOrderNorms* New();
  vtkTypeMacro(vtkHighOrderNorms, PIXELEXACT_MESH_FILTER(vtkTableAlgorithm));
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The field, or an expression. Empty, the default: that of SetInputArrayToProcess(0, ...), else
   * the first one.
   */
  vtkSetMacro(FieldName, std::string);
  vtkGetMacro(FieldName, std::string);
  ///@}

  ///@{
  /**
   * Results of the last update, with estimates of their errors. LinfLower and LinfUpper are proven
   * to hold the largest |f|; NaN where nothing is proven. LargestSample is numeric.
   */
  vtkGetMacro(Volume, double);
  vtkGetMacro(VolumeError, double);
  vtkGetMacro(L1, double);
  vtkGetMacro(L1Error, double);
  vtkGetMacro(L2, double);
  vtkGetMacro(L2Error, double);
  vtkGetMacro(LinfLower, double);
  vtkGetMacro(LinfUpper, double);
  vtkGetMacro(LargestSample, double);
  ///@}

  ///@{
  /**
   * Results of the last update: whether the estimates are as small as stated; elements with a value
   * that is not finite, which are left out; elements with det J <= 0 at a sample; the smallest
   * number of elements that carry 90 % of the square of L2.
   */
  vtkGetMacro(ToleranceMet, bool);
  vtkGetMacro(NotFiniteElements, vtkIdType);
  vtkGetMacro(FoldedElements, vtkIdType);
  vtkGetMacro(ElementsWith90Percent, vtkIdType);
  ///@}

protected:
  vtkHighOrderNorms();
  ~vtkHighOrderNorms() override;

  void ResetReport() override;
  bool Make(vtkDataObject* mesh, Output* output) override;

private:
  vtkHighOrderNorms(const vtkHighOrderNorms&) = delete;
  void operator=(const vtkHighOrderNorms&) = delete;

  std::string FieldName;
  double Volume;
  double VolumeError;
  double L1;
  double L1Error;
  double L2;
  double L2Error;
  double LinfLower;
  double LinfUpper;
  double LargestSample;
  bool ToleranceMet;
  vtkIdType NotFiniteElements;
  vtkIdType FoldedElements;
  vtkIdType ElementsWith90Percent;
};

#endif
