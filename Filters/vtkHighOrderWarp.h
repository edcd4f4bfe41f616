// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderWarp
 * @brief   deforms a high-order mesh by a field, with the exact map of the deformed shape
 *
 * The output is the input with the map x + ScaleFactor * u on each element. u is a vector field,
 * `vec(u,v,w)` of scalar fields, or a scalar field times Direction (as vtkWarpScalar moves points).
 * The map is computed from the coefficients of map and field, in the space that contains both, so
 * location, proofs and pictures of the deformed shape are as exact as those of the input. The
 * points move with it.
 *
 * Other fields are the same functions of the reference coordinates xi. Derivatives in expressions
 * are those by the deformed coordinates. H(curl), H(div) and density fields depend on the map; they
 * are left out, with a warning.
 *
 * Expressions other than vec(), mapped, rational and discontinuous fields, and displacements out of
 * the plane of a 2-D mesh are errors, which name the remedy. A scale at which elements invert is no
 * error: FindLimit finds it.
 *
 * The input is a grid that carries high-order coefficients, or a plain vtkUnstructuredGrid, which
 * is converted. Composite data are deformed block by block.
 */

#ifndef vtkHighOrderWarp_h
#define vtkHighOrderWarp_h

#include "MeshFilter.h"
#include "PixelExactFiltersModule.h"
#include "vtkDataObject.h" // for the output
#include "vtkPassInputTypeAlgorithm.h"

#include <string> // for names

class PIXELEXACTFILTERS_EXPORT vtkHighOrderWarp
  : public PIXELEXACT_MESH_FILTER(vtkPassInputTypeAlgorithm)
{
public:
  static vtkHighOrderWarp* New();
  vtkTypeMacro(vtkHighOrderWarp, PIXELEXACT_MESH_FILTER(vtkPassInputTypeAlgorithm));
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The displacement: the name of a vector field, or of a scalar field with a Direction, or
   * vec(u,v,w) of scalar fields or 0; in the plane vec(u,v). Empty: the first array that the filter
   * processes (SetInputArrayToProcess).
   */
  vtkSetMacro(FieldName, std::string);
  vtkGetMacro(FieldName, std::string);
  ///@}

  ///@{
  /**
   * The scale of the displacement, a finite number; 1 by default.
   */
  vtkSetMacro(ScaleFactor, double);
  vtkGetMacro(ScaleFactor, double);
  ///@}

  ///@{
  /**
   * The direction of a scalar's displacement, which is not normalised. (0, 0, 0), the default:
   * none.
   */
  vtkSetVector3Macro(Direction, double);
  vtkGetVector3Macro(Direction, double);
  ///@}

  ///@{
  /**
   * Whether to find, at each update, the scales up to which the deformed mesh is proven valid; off
   * by default. Of ScaleFactor only the sign matters, which the scales have, too.
   */
  vtkSetMacro(FindLimit, bool);
  vtkGetMacro(FindLimit, bool);
  vtkBooleanMacro(FindLimit, bool);
  ///@}

  ///@{
  /**
   * After an update with FindLimit on: det J of all elements is proven positive for scales between
   * 0 and ValidScale. At InvertedScale it is proven not to be positive in the cell InvertedCell,
   * a number of the source file, at the reference point InvertedPoint. Where no such scale was
   * found these are infinite, -1 and NaN. ElementsWithoutLimit counts the elements that are not
   * proven valid without a displacement, which are left out. Without FindLimit, ValidScale is 0. Of
   * composite data the numbers are those of the last block.
   */
  vtkGetMacro(ValidScale, double);
  vtkGetMacro(InvertedScale, double);
  vtkGetMacro(InvertedCell, vtkIdType);
  vtkGetVector3Macro(InvertedPoint, double);
  vtkGetMacro(ElementsWithoutLimit, vtkIdType);
  ///@}

protected:
  vtkHighOrderWarp();
  ~vtkHighOrderWarp() override;

  void ResetReport() override;
  bool Make(vtkDataObject* mesh, Output* output) override;

private:
  vtkHighOrderWarp(const vtkHighOrderWarp&) = delete;
  void operator=(const vtkHighOrderWarp&) = delete;

  std::string FieldName;
  double ScaleFactor = 1.0;
  double Direction[3] = { 0.0, 0.0, 0.0 };
  bool FindLimit = false;
  double ValidScale;
  double InvertedScale;
  vtkIdType InvertedCell;
  double InvertedPoint[3];
  vtkIdType ElementsWithoutLimit;
};

#endif
