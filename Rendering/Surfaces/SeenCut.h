// SPDX-License-Identifier: BSD-3-Clause
#ifndef SeenCut_h
#define SeenCut_h

#include "vtkSmartPointer.h"

#include "vtkCamera.h"
#include "vtkImplicitFunction.h"
#include "vtkIndent.h"

namespace pixelexact
{
/// Function and camera of filters that view a cut-surface through a camera.
struct SeenCut
{
  vtkSmartPointer<vtkImplicitFunction> function;
  vtkSmartPointer<vtkCamera> camera;

  /// The later of `time` and the modification times of function and camera.
  [[nodiscard]] vtkMTimeType Latest(vtkMTimeType time) const;
  void Print(ostream& os, vtkIndent indent, const int size[2]) const;
  /// Throws Error without a function, and for an empty image.
  void Require(const int size[2]) const;
};

/// Sets `held` to `object`. Returns true if this is another object.
template <class Object>
bool Replace(vtkSmartPointer<Object>& held, Object* object)
{
  const bool changed = held != object;
  held = object;
  return changed;
}
} // namespace pixelexact
#endif
