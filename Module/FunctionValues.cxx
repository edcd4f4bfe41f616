// SPDX-License-Identifier: BSD-3-Clause
#include "FunctionValues.h"

#include "CallbackWatch.h"
#include "Core/Base/Error.h"
#include "vtkImplicitCallback.h"

#include "vtkAbstractTransform.h"
#include "vtkCollection.h"
#include "vtkDoubleArray.h"
#include "vtkImplicitBoolean.h"
#include "vtkImplicitFunction.h"
#include "vtkImplicitFunctionCollection.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <glm/gtc/type_ptr.hpp>
#include <tbb/task_arena.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace pixelexact
{
namespace
{
std::vector<vtkImplicitFunction*> PartsOf(vtkImplicitBoolean* boolean)
{
  std::vector<vtkImplicitFunction*> parts;
  vtkCollectionSimpleIterator at;
  boolean->GetFunction()->InitTraversal(at);
  while (vtkImplicitFunction* part = boolean->GetFunction()->GetNextImplicitFunction(at))
  {
    parts.push_back(part);
  }
  return parts;
}

/// Null for another function, and for classes derived from it, which may be others.
vtkImplicitBoolean* BooleanOf(vtkImplicitFunction* function)
{
  return std::string_view(function->GetClassName()) == "vtkImplicitBoolean"
    ? vtkImplicitBoolean::SafeDownCast(function)
    : nullptr;
}

/// Whether a part's value takes the place of the whole's, of the parts before it.
bool Replaces(int operation, double part, double whole)
{
  return operation == vtkImplicitBoolean::VTK_UNION ||
      operation == vtkImplicitBoolean::VTK_UNION_OF_MAGNITUDES
    ? part < whole
    : part > whole;
}

/// The sign of a part's value: in a difference the parts after the first one are subtracted.
double SideOf(int operation, std::size_t part, double value)
{
  switch (operation)
  {
    case vtkImplicitBoolean::VTK_DIFFERENCE:
      return part > 0 ? -1.0 : 1.0;
    case vtkImplicitBoolean::VTK_UNION_OF_MAGNITUDES:
      return value < 0.0 ? -1.0 : 1.0;
    default:
      return 1.0;
  }
}

vtkSmartPointer<vtkDoubleArray> ToArray(std::span<const Vec3> x)
{
  auto points = vtkSmartPointer<vtkDoubleArray>::New();
  points->SetNumberOfComponents(3);
  points->SetNumberOfTuples(static_cast<vtkIdType>(x.size()));
  double* to = points->GetPointer(0);
  for (const Vec3& point : x)
  {
    to = std::copy_n(glm::value_ptr(point), 3, to);
  }
  return points;
}

/// Values without the function's transform. Booleans are put together here, as VTK does it, but for
/// many points at once.
void ValuesOf(vtkImplicitFunction* function, std::span<const Vec3> x, std::span<double> values);

void BooleanValues(vtkImplicitBoolean* boolean, std::span<const Vec3> x, std::span<double> values);

void MovedValues(vtkImplicitFunction* function, std::span<const Vec3> x, std::span<double> values)
{
  vtkAbstractTransform* const transform = function->GetTransform();
  if (transform == nullptr)
  {
    ValuesOf(function, x, values);
    return;
  }
  std::vector<Vec3> moved(x.size());
  std::ranges::transform(x, moved.begin(),
    [transform](const Vec3& from)
    {
      Vec3 to;
      transform->TransformPoint(glm::value_ptr(from), glm::value_ptr(to));
      return to;
    });
  ValuesOf(function, moved, values);
}

void ValuesOf(vtkImplicitFunction* function, std::span<const Vec3> x, std::span<double> values)
{
  vtkImplicitBoolean* const boolean = BooleanOf(function);
  if (boolean != nullptr && HasCallbacks(boolean))
  {
    BooleanValues(boolean, x, values);
    return;
  }
  const auto points = ToArray(x);
  vtkNew<vtkDoubleArray> answers;
  answers->SetNumberOfTuples(static_cast<vtkIdType>(x.size()));
  // Some functions evaluate in parallel. A thread that waits for them must not begin another tile,
  // which would evaluate the same function.
  tbb::this_task_arena::isolate([&] { function->EvaluateFunction(points, answers); });
  std::copy_n(answers->GetPointer(0), x.size(), values.begin());
}

void BooleanValues(vtkImplicitBoolean* boolean, std::span<const Vec3> x, std::span<double> values)
{
  const std::vector<vtkImplicitFunction*> parts = PartsOf(boolean);
  const int operation = boolean->GetOperationType();
  std::vector<double> part(x.size());
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    MovedValues(parts[p], x, part);
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      const double value = SideOf(operation, p, part[i]) * part[i];
      values[i] = p == 0 || Replaces(operation, value, values[i]) ? value : values[i];
    }
  }
}

/// Central differences, one-sided at the faces of the box.
void Differences(vtkImplicitFunction* function, const DifferenceRule& rule, std::span<const Vec3> x,
  std::span<Vec3> gradients)
{
  std::vector<Vec3> points;
  points.reserve(6 * x.size());
  for (const Vec3& at : x)
  {
    for (int d = 0; d < 3; ++d)
    {
      Vec3 below = at;
      Vec3 above = at;
      below[d] = std::max(at[d] - rule.step, std::min(at[d], rule.box.lower[d]));
      above[d] = std::min(at[d] + rule.step, std::max(at[d], rule.box.upper[d]));
      points.push_back(below);
      points.push_back(above);
    }
  }
  std::vector<double> values(points.size());
  MovedValues(function, points, values);
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    for (int d = 0; d < 3; ++d)
    {
      const std::size_t k = 6 * i + 2 * static_cast<std::size_t>(d);
      const double width = points[k + 1][d] - points[k][d];
      gradients[i][d] = width > 0.0 ? (values[k + 1] - values[k]) / width : 0.0;
    }
  }
}

void GradientsOf(vtkImplicitFunction* function, const DifferenceRule& rule, std::span<const Vec3> x,
  std::span<Vec3> gradients)
{
  auto* const callback = vtkImplicitCallback::SafeDownCast(function);
  const bool moved = function->GetTransform() != nullptr;
  vtkImplicitBoolean* const boolean = BooleanOf(function);
  if (!HasCallbacks(function))
  {
    std::ranges::transform(x, gradients.begin(),
      [function](const Vec3& at)
      {
        Vec3 gradient;
        function->FunctionGradient(glm::value_ptr(at), glm::value_ptr(gradient));
        return gradient;
      });
  }
  else if (moved || (callback != nullptr && !callback->HasGradient()))
  {
    Differences(function, rule, x, gradients);
  }
  else if (callback != nullptr)
  {
    const auto points = ToArray(x);
    vtkNew<vtkDoubleArray> answers;
    callback->EvaluateGradients(points, answers);
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      answers->GetTuple(static_cast<vtkIdType>(i), glm::value_ptr(gradients[i]));
    }
  }
  else
  {
    // Selects the gradient of the part whose value is that of the whole.
    const std::vector<vtkImplicitFunction*> parts = PartsOf(boolean);
    const int operation = boolean->GetOperationType();
    std::vector<double> values(x.size());
    std::vector<double> part(x.size());
    std::vector<Vec3> ofPart(x.size());
    for (std::size_t p = 0; p < parts.size(); ++p)
    {
      MovedValues(parts[p], x, part);
      GradientsOf(parts[p], rule, x, ofPart);
      for (std::size_t i = 0; i < x.size(); ++i)
      {
        const double side = SideOf(operation, p, part[i]);
        if (p == 0 || Replaces(operation, side * part[i], values[i]))
        {
          values[i] = side * part[i];
          gradients[i] = side * ofPart[i];
        }
      }
    }
  }
}

/// Runs an evaluation and throws the errors that callbacks reported.
template <class Asking>
void Watched(const Asking& asking)
{
  const CallbackWatch watch;
  asking();
  if (!watch.failure.empty())
  {
    throw Error(watch.failure);
  }
}
} // namespace

bool HasCallbacks(vtkImplicitFunction* function)
{
  vtkImplicitBoolean* const boolean = BooleanOf(function);
  return vtkImplicitCallback::SafeDownCast(function) != nullptr ||
    (boolean != nullptr && std::ranges::any_of(PartsOf(boolean), HasCallbacks));
}

void FunctionValues(
  vtkImplicitFunction* function, std::span<const Vec3> x, std::span<double> values)
{
  if (!x.empty())
  {
    Watched([&] { MovedValues(function, x, values); });
  }
}

void FunctionGradients(vtkImplicitFunction* function, const DifferenceRule& rule,
  std::span<const Vec3> x, std::span<Vec3> gradients)
{
  Watched([&] { GradientsOf(function, rule, x, gradients); });
}
} // namespace pixelexact
