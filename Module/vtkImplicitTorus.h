// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkImplicitTorus
 * @brief   implicit function for a torus
 *
 * f(x) = (rho - Radius)^2 + z^2 - TubeRadius^2, where z is the height over the plane through Center
 * across Axis and rho the distance from the axis: negative within the tube. Beside VTK's own
 * implicit functions, none of which is a torus that can be cut with exactly.
 */

#ifndef vtkImplicitTorus_h
#define vtkImplicitTorus_h

#include "PixelExactDataModelModule.h"
#include "vtkImplicitFunction.h"

class PIXELEXACTDATAMODEL_EXPORT vtkImplicitTorus : public vtkImplicitFunction
{
public:
  static vtkImplicitTorus* New();
  vtkTypeMacro(vtkImplicitTorus, vtkImplicitFunction);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The function and its gradient, without the transform. On the axis, where the gradient has no
   * direction across it, it has none.
   */
  using vtkImplicitFunction::EvaluateFunction;
  double EvaluateFunction(double x[3]) override;
  void EvaluateGradient(double x[3], double gradient[3]) override;
  ///@}

  ///@{
  /**
   * The default is the origin.
   */
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /**
   * Of any length but zero. The default is (0, 0, 1).
   */
  vtkSetVector3Macro(Axis, double);
  vtkGetVector3Macro(Axis, double);
  ///@}

  ///@{
  /**
   * Of the circle that the tube's middle runs along. The default is 1.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Of the tube. The default is 0.25.
   */
  vtkSetMacro(TubeRadius, double);
  vtkGetMacro(TubeRadius, double);
  ///@}

protected:
  vtkImplicitTorus();
  ~vtkImplicitTorus() override;

  double Center[3] = { 0.0, 0.0, 0.0 };
  double Axis[3] = { 0.0, 0.0, 1.0 };
  double Radius = 1.0;
  double TubeRadius = 0.25;

private:
  vtkImplicitTorus(const vtkImplicitTorus&) = delete;
  void operator=(const vtkImplicitTorus&) = delete;
};

#endif
