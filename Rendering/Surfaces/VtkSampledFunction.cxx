// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/VtkSampledFunction.h"

#include "Views/CallbackWatch.h"
#include "vtkImplicitCallback.h"

#include "Core/Base/Error.h"

#include "vtkAbstractTransform.h"
#include "vtkCollection.h"
#include "vtkDoubleArray.h"
#include "vtkImplicitBoolean.h"
#include "vtkImplicitFunction.h"
#include "vtkImplicitFunctionCollection.h"
#include "vtkNew.h"

#include <glm/gtc/type_ptr.hpp>
#include <tbb/task_arena.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace pixelexact
{
namespace
{
/// Of a box's size; the cube root of the unit roundoff, where central differences are best.
constexpr double kStep = 6e-6;

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

bool HasCallback(vtkImplicitFunction* function)
{
  vtkImplicitBoolean* const boolean = BooleanOf(function);
  return vtkImplicitCallback::SafeDownCast(function) != nullptr ||
    (boolean != nullptr && std::ranges::any_of(PartsOf(boolean), HasCallback));
}

/// Whether a part's value takes the place of the whole's, of the parts before it.
bool Replaces(int operation, double part, double whole)
{
  return operation == vtkImplicitBoolean::VTK_UNION ? part < whole : part > whole;
}

/// Parts after the first one are taken away: they count from the other side.
double SideOf(int operation, std::size_t part)
{
  return operation == vtkImplicitBoolean::VTK_DIFFERENCE && part > 0 ? -1.0 : 1.0;
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
  if (boolean != nullptr && HasCallback(boolean))
  {
    BooleanValues(boolean, x, values);
    return;
  }
  const auto points = ToArray(x);
  vtkNew<vtkDoubleArray> answers;
  answers->SetNumberOfTuples(static_cast<vtkIdType>(x.size()));
  // Some evaluate in parallel: whoever waits for that must not begin another tile, which would ask
  // the same function.
  tbb::this_task_arena::isolate([&] { function->EvaluateFunction(points, answers); });
  std::copy_n(answers->GetPointer(0), x.size(), values.begin());
}

void BooleanValues(vtkImplicitBoolean* boolean, std::span<const Vec3> x, std::span<double> values)
{
  const std::vector<vtkImplicitFunction*> parts = PartsOf(boolean);
  const int operation = boolean->GetOperationType();
  MovedValues(parts.front(), x, values);
  std::vector<double> part(x.size());
  for (std::size_t p = 1; p < parts.size(); ++p)
  {
    MovedValues(parts[p], x, part);
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      const double value = SideOf(operation, p) * part[i];
      values[i] = Replaces(operation, value, values[i]) ? value : values[i];
    }
  }
}

/// Central differences, one-sided at the faces of the box.
void Differences(vtkImplicitFunction* function, const Box3& box, std::span<const Vec3> x,
  std::span<Vec3> gradients)
{
  const Vec3 size = box.upper - box.lower;
  const double step = kStep * std::max({ size.x, size.y, size.z });
  std::vector<Vec3> points;
  points.reserve(6 * x.size());
  for (const Vec3& at : x)
  {
    for (int d = 0; d < 3; ++d)
    {
      Vec3 below = at;
      Vec3 above = at;
      below[d] = std::max(at[d] - step, std::min(at[d], box.lower[d]));
      above[d] = std::min(at[d] + step, std::max(at[d], box.upper[d]));
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

void GradientsOf(vtkImplicitFunction* function, const Box3& box, std::span<const Vec3> x,
  std::span<Vec3> gradients)
{
  auto* const callback = vtkImplicitCallback::SafeDownCast(function);
  const bool moved = function->GetTransform() != nullptr;
  vtkImplicitBoolean* const boolean = BooleanOf(function);
  if (!HasCallback(function))
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
    Differences(function, box, x, gradients);
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
    // That of the part that the whole's value is of.
    const std::vector<vtkImplicitFunction*> parts = PartsOf(boolean);
    const int operation = boolean->GetOperationType();
    std::vector<double> values(x.size());
    std::vector<double> part(x.size());
    std::vector<Vec3> ofPart(x.size());
    MovedValues(parts.front(), x, values);
    GradientsOf(parts.front(), box, x, gradients);
    for (std::size_t p = 1; p < parts.size(); ++p)
    {
      const double side = SideOf(operation, p);
      MovedValues(parts[p], x, part);
      GradientsOf(parts[p], box, x, ofPart);
      for (std::size_t i = 0; i < x.size(); ++i)
      {
        if (Replaces(operation, side * part[i], values[i]))
        {
          values[i] = side * part[i];
          gradients[i] = side * ofPart[i];
        }
      }
    }
  }
}

void ThrowFailure(const CallbackWatch& watch)
{
  if (!watch.failure.empty())
  {
    throw Error(watch.failure);
  }
}
} // namespace

VtkSampledFunction::VtkSampledFunction(vtkImplicitFunction* function, const Box3& box)
  : Function(function)
  , Box(box)
  , HasCallbacks(HasCallback(function))
{
}

VtkSampledFunction::~VtkSampledFunction() = default;

void VtkSampledFunction::Evaluate(std::span<const Vec3> x, std::span<double> values) const
{
  const std::scoped_lock lock(Mutex);
  if (!x.empty())
  {
    const CallbackWatch watch;
    MovedValues(Function, x, values);
    ThrowFailure(watch);
  }
}

void VtkSampledFunction::Gradients(std::span<const Vec3> x, std::span<Vec3> gradients) const
{
  const std::scoped_lock lock(Mutex);
  const CallbackWatch watch;
  GradientsOf(Function, Box, x, gradients);
  ThrowFailure(watch);
}
} // namespace pixelexact
