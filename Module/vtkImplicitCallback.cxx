// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImplicitCallback.h"

#include "CallbackWatch.h"

#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <array>
#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkImplicitCallback);

//------------------------------------------------------------------------------
vtkImplicitCallback::vtkImplicitCallback()
{
  this->Points->SetNumberOfComponents(3);
  this->GradientsOfPoints->SetNumberOfComponents(3);
}

//------------------------------------------------------------------------------
vtkImplicitCallback::~vtkImplicitCallback() = default;

//------------------------------------------------------------------------------
vtkDoubleArray* vtkImplicitCallback::GetPoints()
{
  return this->Points;
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkImplicitCallback::GetValues()
{
  return this->Values;
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkImplicitCallback::GetGradients()
{
  return this->GradientsOfPoints;
}

//------------------------------------------------------------------------------
void vtkImplicitCallback::SetFailure(const char* why)
{
  this->Failure = why != nullptr && why[0] != '\0' ? why : "no reason given";
}

//------------------------------------------------------------------------------
bool vtkImplicitCallback::HasGradient()
{
  return this->HasObserver(GradientEvent) != 0;
}

//------------------------------------------------------------------------------
std::string vtkImplicitCallback::WhyNot(unsigned long event)
{
  if (std::this_thread::get_id() != this->Maker)
  {
    return "it is asked by another thread than the one that made it; let the thread that renders "
           "make it, and use it alone or within vtkImplicitBoolean";
  }
  if (this->Asking)
  {
    return "its observer asks for its values";
  }
  return this->HasObserver(event) != 0
    ? ""
    : "nobody gives its values; add an observer of EvaluateEvent";
}

//------------------------------------------------------------------------------
std::string vtkImplicitCallback::WrongIn(vtkDoubleArray* answers, vtkIdType count, int components)
{
  std::ostringstream text;
  if (answers->GetNumberOfTuples() != count || answers->GetNumberOfComponents() != components)
  {
    text << "its observer gave " << answers->GetNumberOfTuples() << " answers of "
         << answers->GetNumberOfComponents() << " components for " << count << " points and "
         << components;
    return text.str();
  }
  for (vtkIdType i = 0; i < count * components; ++i)
  {
    if (!std::isfinite(answers->GetValue(i)))
    {
      const double* x = this->Points->GetPointer(3 * (i / components));
      text << "its " << (components == 1 ? "value" : "gradient") << " at (" << x[0] << ", " << x[1]
           << ", " << x[2] << ") is " << answers->GetValue(i) << "; give a finite one everywhere";
      return text.str();
    }
  }
  return "";
}

//------------------------------------------------------------------------------
bool vtkImplicitCallback::Ask(unsigned long event, vtkDoubleArray* answers, int components)
{
  pixelexact::CallbackWatch* const watch = pixelexact::CallbackWatch::Current();
  const bool failedBefore = watch != nullptr && !watch->failure.empty();
  std::string why = failedBefore ? "it failed before" : this->WhyNot(event);
  if (why.empty())
  {
    const vtkIdType count = this->Points->GetNumberOfTuples();
    answers->SetNumberOfComponents(components);
    answers->SetNumberOfTuples(count);
    answers->Fill(vtkMath::Nan());
    this->Failure.clear();
    this->Asking = true;
    this->InvokeEvent(event, nullptr);
    this->Asking = false;
    why = this->Failure.empty() ? this->WrongIn(answers, count, components) : this->Failure;
  }
  if (why.empty())
  {
    return true;
  }
  if (watch == nullptr)
  {
    vtkErrorMacro(<< "no values: " << why);
  }
  else if (!failedBefore)
  {
    watch->failure = std::string(this->GetClassName()) + ": " + why;
  }
  return false;
}

//------------------------------------------------------------------------------
void vtkImplicitCallback::Ask(
  unsigned long event, vtkDoubleArray* answers, int components, vtkDataArray* in, vtkDataArray* out)
{
  out->SetNumberOfComponents(components);
  out->SetNumberOfTuples(in->GetNumberOfTuples());
  if (in->GetNumberOfTuples() == 0)
  {
    return;
  }
  // Else nothing may be touched; Ask says so.
  if (std::this_thread::get_id() == this->Maker && !this->Asking)
  {
    this->Points->DeepCopy(in);
  }
  if (this->Ask(event, answers, components))
  {
    out->DeepCopy(answers);
  }
  else
  {
    out->Fill(vtkMath::Nan());
  }
}

//------------------------------------------------------------------------------
void vtkImplicitCallback::EvaluateFunction(vtkDataArray* input, vtkDataArray* output)
{
  this->Ask(EvaluateEvent, this->Values, 1, input, output);
}

//------------------------------------------------------------------------------
void vtkImplicitCallback::EvaluateGradients(vtkDataArray* input, vtkDataArray* output)
{
  this->Ask(GradientEvent, this->GradientsOfPoints, 3, input, output);
}

//------------------------------------------------------------------------------
double vtkImplicitCallback::EvaluateFunction(double x[3])
{
  vtkNew<vtkDoubleArray> point;
  point->SetNumberOfComponents(3);
  point->InsertNextTuple(x);
  vtkNew<vtkDoubleArray> value;
  this->EvaluateFunction(point, value);
  return value->GetValue(0);
}

//------------------------------------------------------------------------------
void vtkImplicitCallback::EvaluateGradient(double x[3], double gradient[3])
{
  if (this->HasGradient())
  {
    vtkNew<vtkDoubleArray> point;
    point->SetNumberOfComponents(3);
    point->InsertNextTuple(x);
    vtkNew<vtkDoubleArray> there;
    this->EvaluateGradients(point, there);
    there->GetTuple(0, gradient);
    return;
  }
  vtkNew<vtkDoubleArray> points;
  points->SetNumberOfComponents(3);
  for (int k = 0; k < 6; ++k)
  {
    std::array<double, 3> at = { x[0], x[1], x[2] };
    at[static_cast<std::size_t>(k / 2)] +=
      k % 2 == 0 ? -this->DifferenceStep : this->DifferenceStep;
    points->InsertNextTuple(at.data());
  }
  vtkNew<vtkDoubleArray> values;
  this->EvaluateFunction(points, values);
  for (int d = 0; d < 3; ++d)
  {
    gradient[d] = (values->GetValue(2 * d + 1) - values->GetValue(2 * d)) /
      (points->GetComponent(2 * d + 1, d) - points->GetComponent(2 * d, d));
  }
}

//------------------------------------------------------------------------------
void vtkImplicitCallback::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DifferenceStep: " << this->DifferenceStep << "\n";
  os << indent << "Gradient: " << (this->HasGradient() ? "given" : "by differences") << "\n";
}
