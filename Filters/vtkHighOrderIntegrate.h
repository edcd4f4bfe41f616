// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderIntegrate
 * @brief   integrals of a high-order field over a cut or the boundary, with proven error bounds
 *
 * The input is a grid with high-order coefficients, a plain vtkUnstructuredGrid, which is
 * converted, or composite data of such grids, which are joined. The output is a table with a row
 * for each quantity: `Quantity`, its name; `Value`; `ErrorBound`, a proven bound of the error of
 * Value; `Lower` and `Upper`, which enclose the quantity. Quantities: `Area`; `Integral` and `Mean`
 * of a scalar, `Integral 0`, `Mean 0`, ... of fields with several components; `Flux` of a vector of
 * three components, along the gradient of the cut function, or out of the boundary.
 *
 * Supported surfaces are planes, spheres, cylinders, double cones, quadrics, the faces of boxes and
 * convex bodies (vtkBox, vtkPlanes), also after affine transforms, vtkImplicitTorus, iso-surfaces
 * and the boundary. Clip functions cut parts off: a disc is a plane clipped by a sphere. A warning
 * states why a table covers only a part of the surface.
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

namespace pixelexact
{
struct ImplicitPolynomial;
struct SurfacePatch;
} // namespace pixelexact

class PIXELEXACTFILTERS_EXPORT vtkHighOrderIntegrate
  : public PIXELEXACT_MESH_FILTER(vtkTableAlgorithm)
{
public:
  static vtkHighOrderIntegrate* New();
  vtkTypeMacro(vtkHighOrderIntegrate, PIXELEXACT_MESH_FILTER(vtkTableAlgorithm));
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The cut function's modification time counts as well.
  vtkMTimeType GetMTime() override;

  /// The surface of integration. Any: the cut function or the iso-surface where there is one, else
  /// the boundary.
  enum Surfaces
  {
    OverCutFunction,
    OverIsoSurface,
    OverBoundary,
    OverAny
  };
  ///@{
  /**
   * One of Surfaces; settings of other surfaces are ignored. OverAny by default, which refuses
   * settings of several surfaces.
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
   * Functions that clip the surface: the part where none of them is positive remains. Planes,
   * quadrics, boxes and convex bodies. None by default.
   */
  void AddClipFunction(vtkImplicitFunction* function);
  void ClearClipFunctions();
  int GetNumberOfClipFunctions();
  ///@}

  ///@{
  /**
   * The iso-surface that replaces a cut function: the points where a component of a field has a
   * value. The field may differ from the integrated one. Empty, the default: no iso-surface.
   * IsoComponent: -1, the default, is a scalar itself, or the magnitude. Mapped fields (H(curl),
   * H(div), density) are refused.
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
   * Adds the part of the boundary with this attribute, in the solver's numbering.
   */
  void AddBoundaryAttribute(int attribute);
  void ClearBoundaryAttributes();
  int GetNumberOfBoundaryAttributes();
  ///@}

  ///@{
  /**
   * The field. Empty, the default: that of SetInputArrayToProcess(0, ...), else the first one;
   * without fields only the area. A name that the grid lacks is an error.
   */
  vtkSetMacro(FieldName, std::string);
  vtkGetMacro(FieldName, std::string);
  ///@}

  ///@{
  /**
   * The target for errors, relative to the integrals of magnitudes; for a vector the largest
   * component's. Greater than 0; 1e-8 by default.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Time limit in seconds. 0, the default: no limit. The result at the limit is returned.
   */
  vtkSetMacro(Seconds, double);
  vtkGetMacro(Seconds, double);
  ///@}

  ///@{
  /**
   * More rows of the table, with proven bounds: `L1`, `L2` and `Linf`; `Minimum` and `Maximum` (of
   * vectors of the magnitude); `Variance`, `Deviation` and `Quantile 0.05`, ... by area, and
   * `Class 1`, ..., the parts of the area in classes of equal width between minimum and maximum;
   * the `Correlation` by area with another scalar. None by default.
   */
  vtkSetMacro(Norms, bool);
  vtkGetMacro(Norms, bool);
  vtkBooleanMacro(Norms, bool);
  vtkSetMacro(Extremes, bool);
  vtkGetMacro(Extremes, bool);
  vtkBooleanMacro(Extremes, bool);
  vtkSetClampMacro(StatisticsClasses, int, 0, 1000);
  vtkGetMacro(StatisticsClasses, int);
  vtkSetMacro(CorrelateWith, std::string);
  vtkGetMacro(CorrelateWith, std::string);
  ///@}

  ///@{
  /**
   * Where the last update found the minimum and the maximum; NaN where it did not look for them.
   */
  vtkGetVector3Macro(MinimumPoint, double);
  vtkGetVector3Macro(MaximumPoint, double);
  ///@}

  ///@{
  /**
   * Results of the last update: whether the tolerance was met; a bound of the area that is missing.
   */
  vtkGetMacro(ToleranceMet, bool);
  vtkGetMacro(UnresolvedArea, double);
  ///@}

protected:
  vtkHighOrderIntegrate();
  ~vtkHighOrderIntegrate() override;

  void ResetReport() override;
  bool Make(vtkDataObject* mesh, Output* output) override;

  ///@{
  /**
   * The patches of the cut-surface, with their clips, and the clips of an iso-surface and of the
   * boundary. `mesh` is the input as Make gets it. Throws pixelexact::Error.
   */
  virtual std::vector<pixelexact::SurfacePatch> PatchesFor(vtkDataObject* mesh);
  virtual std::vector<pixelexact::ImplicitPolynomial> ClipsFor(vtkDataObject* mesh);
  ///@}

private:
  vtkHighOrderIntegrate(const vtkHighOrderIntegrate&) = delete;
  void operator=(const vtkHighOrderIntegrate&) = delete;

  /// Returns one of OverCutFunction, OverIsoSurface, OverBoundary. Throws Error.
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
  bool Norms = false;
  bool Extremes = false;
  int StatisticsClasses = 0;
  std::string CorrelateWith;
  double MinimumPoint[3] = { 0.0, 0.0, 0.0 };
  double MaximumPoint[3] = { 0.0, 0.0, 0.0 };
  bool ToleranceMet = false;
  double UnresolvedArea = 0.0;
};

#endif
