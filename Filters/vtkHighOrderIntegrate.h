// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderIntegrate
 * @brief   integrals of a high-order field over a cut or the boundary, with proven error bounds
 *
 * The input is a grid that carries high-order coefficients, a plain vtkUnstructuredGrid, which is
 * converted, or composite data of such grids, which are then one. The output is a table with a row
 * for each quantity: `Quantity`, its name; `Value`; `ErrorBound`, which Value is proven not to be
 * off by more; `Lower` and `Upper`, which hold the quantity. Quantities: `Area`; `Integral` and
 * `Mean` of a scalar, `Integral 0`, `Mean 0`, ... of fields with several components; `Flux` of a
 * vector of three, along the gradient of the cut function, or out of the boundary.
 *
 * Planes, spheres, cylinders, cones (both halves), quadrics, boxes and convex bodies (vtkBox,
 * vtkPlanes: their faces) are taken, also moved by affine transforms, vtkImplicitTorus,
 * iso-surfaces and the boundary; and of each of them what clip functions leave: a disc is a plane
 * that a sphere clips. What keeps the table from being of all of the surface is warned of.
 */

#ifndef vtkHighOrderIntegrate_h
#define vtkHighOrderIntegrate_h

#include "MeshFilter.h"
#include "PixelExactFiltersModule.h"
#include "vtkSmartPointer.h" // for the cut function
#include "vtkTableAlgorithm.h"

#include <cstdint> // for attributes
#include <memory>  // for the model
#include <string>  // for names
#include <vector>  // for attributes

class vtkImplicitFunction;

class PIXELEXACTFILTERS_EXPORT vtkHighOrderIntegrate
  : public PIXELEXACT_MESH_FILTER(vtkTableAlgorithm)
{
public:
  static vtkHighOrderIntegrate* New();
  vtkTypeMacro(vtkHighOrderIntegrate, PIXELEXACT_MESH_FILTER(vtkTableAlgorithm));
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Includes the cut function's.
  vtkMTimeType GetMTime() override;

  /// What is integrated over; Any: the cut function or the iso-surface where there is one, else the
  /// boundary.
  enum Surfaces
  {
    OverCutFunction,
    OverIsoSurface,
    OverBoundary,
    OverAny
  };
  ///@{
  /**
   * One of Surfaces: those that it does not name are not looked at. OverAny by default; several at
   * once are then refused.
   */
  vtkSetClampMacro(Over, int, OverCutFunction, OverAny);
  vtkGetMacro(Over, int);
  ///@}

  ///@{
  /**
   * The function whose zeros are the cut-surface. None, the default: the boundary of the mesh, or
   * the parts of it that AddBoundaryAttribute names.
   */
  void SetCutFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetCutFunction();
  ///@}

  ///@{
  /**
   * Of the surface counts what is where none of these functions is positive: planes, quadrics,
   * boxes and convex bodies. None at first.
   */
  void AddClipFunction(vtkImplicitFunction* function);
  void ClearClipFunctions();
  int GetNumberOfClipFunctions();
  ///@}

  ///@{
  /**
   * In place of a cut function: where a component of a field has a value, also of another field
   * than the one that is integrated. Empty, the default: no iso-surface. IsoComponent: -1, the
   * default, is a scalar itself, or the magnitude. Mapped fields (H(curl), H(div), density) are
   * refused.
   */
  vtkSetMacro(IsoFieldName, std::string);
  vtkGetMacro(IsoFieldName, std::string);
  vtkSetMacro(IsoComponent, int);
  vtkGetMacro(IsoComponent, int);
  vtkSetMacro(IsoValue, double);
  vtkGetMacro(IsoValue, double);
  ///@}

  ///@{
  /**
   * The part of the boundary with this attribute, as the solver numbers its parts.
   */
  void AddBoundaryAttribute(int attribute);
  void ClearBoundaryAttributes();
  int GetNumberOfBoundaryAttributes();
  ///@}

  ///@{
  /**
   * The field. Empty, the default: that of SetInputArrayToProcess(0, ...), else the first one;
   * where there is none, the area alone. A name that the grid lacks is an error.
   */
  vtkSetMacro(FieldName, std::string);
  vtkGetMacro(FieldName, std::string);
  ///@}

  ///@{
  /**
   * What the errors are to be at most, as a part of the integrals of magnitudes; of a vector the
   * largest component's. Greater than 0; 1e-8 by default.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * How long it may take. 0, the default: as long as it takes. When they are over what is known by
   * then is given.
   */
  vtkSetMacro(Seconds, double);
  vtkGetMacro(Seconds, double);
  ///@}

  ///@{
  /**
   * Of the last update: whether the tolerance was met; the area that is at most not accounted for.
   */
  vtkGetMacro(ToleranceMet, bool);
  vtkGetMacro(UnresolvedArea, double);
  ///@}

protected:
  vtkHighOrderIntegrate();
  ~vtkHighOrderIntegrate() override;

  void ResetReport() override;
  bool Make(vtkDataObject* mesh, Output* output) override;

private:
  vtkHighOrderIntegrate(const vtkHighOrderIntegrate&) = delete;
  void operator=(const vtkHighOrderIntegrate&) = delete;

  /// One of OverCutFunction, OverIsoSurface, OverBoundary. Throws Error.
  [[nodiscard]] int Chosen() const;

  int Over = OverAny;
  vtkSmartPointer<vtkImplicitFunction> CutFunction;
  std::vector<vtkSmartPointer<vtkImplicitFunction>> ClipFunctions;
  std::string IsoFieldName;
  int IsoComponent = -1;
  double IsoValue = 0.0;
  std::vector<std::int32_t> Attributes;
  std::string FieldName;
  double Tolerance = 1e-8;
  double Seconds = 0.0;
  bool ToleranceMet = false;
  double UnresolvedArea = 0.0;
};

#endif
