// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkImplicitCallback
 * @brief   implicit function whose values an observer gives, for many points at once
 *
 * For functions that are written in Python, where EvaluateFunction cannot be overridden: see
 * pixelexact.implicit_function, which makes one of a function of NumPy arrays. An observer of
 * EvaluateEvent finds points in GetPoints() and puts as many values into GetValues(); one of
 * GradientEvent, which may be missing, puts gradients into GetGradients(). What they cannot answer
 * they say by SetFailure. All values have to be finite.
 *
 * As a cut function of vtkHighOrderMapper, alone or within vtkImplicitBoolean, it is asked by the
 * thread alone that renders, for some 16,000 points at once, so that observers need no lock of
 * Python's interpreter that this thread holds: frames use one core. A frame in which it fails is
 * not drawn, and the mapper's error says why.
 *
 * Threads other than the one that made the function get NaN and an error, and so do questions
 * from within an observer of the same function.
 */

#ifndef vtkImplicitCallback_h
#define vtkImplicitCallback_h

#include "PixelExactDataModelModule.h"
#include "vtkCommand.h" // for the events
#include "vtkImplicitFunction.h"

#include "vtkNew.h" // for the arrays

#include <string> // for the failure
#include <thread> // for the thread that made it

class vtkDoubleArray;

class PIXELEXACTDATAMODEL_EXPORT vtkImplicitCallback : public vtkImplicitFunction
{
public:
  static vtkImplicitCallback* New();
  vtkTypeMacro(vtkImplicitCallback, vtkImplicitFunction);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum
  {
    EvaluateEvent = vtkCommand::UserEvent + 5101,
    GradientEvent
  };

  ///@{
  /**
   * For observers: the points to evaluate, with three components, and the arrays to fill with one
   * value (one component) and one gradient (three components) per point. Their entries are NaN at
   * first. The arrays are valid until the observer returns.
   */
  vtkDoubleArray* GetPoints();
  vtkDoubleArray* GetValues();
  vtkDoubleArray* GetGradients();
  ///@}

  /**
   * For observers: the reason why there are no values. The error message contains it.
   */
  void SetFailure(const char* why);

  ///@{
  /**
   * The function and its gradient, without the transform; NaN and an error where the observer
   * fails.
   */
  using vtkImplicitFunction::EvaluateFunction;
  double EvaluateFunction(double x[3]) override;
  void EvaluateFunction(vtkDataArray* input, vtkDataArray* output) override;
  void EvaluateGradient(double x[3], double gradient[3]) override;
  ///@}

  ///@{
  /**
   * Whether an observer gives gradients, and the gradients at many points. They are NaN without
   * such an observer.
   */
  bool HasGradient();
  void EvaluateGradients(vtkDataArray* input, vtkDataArray* output);
  ///@}

  ///@{
  /**
   * The step of the central differences that EvaluateGradient takes without an observer of
   * GradientEvent. It is above 0; the default is 1e-6. Mappers use 6e-6 of the size of the mesh.
   */
  vtkSetClampMacro(DifferenceStep, double, 1e-300, VTK_DOUBLE_MAX);
  vtkGetMacro(DifferenceStep, double);
  ///@}

protected:
  vtkImplicitCallback();
  ~vtkImplicitCallback() override;

  double DifferenceStep = 1e-6;

private:
  vtkImplicitCallback(const vtkImplicitCallback&) = delete;
  void operator=(const vtkImplicitCallback&) = delete;

  /**
   * Invokes an event whose observers compute `answers` at Points. If they fail, it reports an
   * error, sets the answers to NaN and returns false.
   */
  bool Ask(unsigned long event, vtkDoubleArray* answers, int components);
  void Ask(unsigned long event, vtkDoubleArray* answers, int components, vtkDataArray* in,
    vtkDataArray* out);
  std::string WhyNot(unsigned long event);
  std::string WrongIn(vtkDoubleArray* answers, vtkIdType count, int components);

  vtkNew<vtkDoubleArray> Points;
  vtkNew<vtkDoubleArray> Values;
  vtkNew<vtkDoubleArray> GradientsOfPoints;
  std::string Failure;
  std::thread::id Maker = std::this_thread::get_id();
  bool Asking = false;
};

#endif
