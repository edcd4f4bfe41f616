// SPDX-License-Identifier: BSD-3-Clause
#ifndef SeenCut_h
#define SeenCut_h

#include "vtkSmartPointer.h"

#include "vtkCamera.h"
#include "vtkImplicitFunction.h"
#include "vtkIndent.h"

namespace pixelexact
{
/// What filters that look at a cut-surface by a camera have in common.
struct SeenCut
{
  vtkSmartPointer<vtkImplicitFunction> function;
  vtkSmartPointer<vtkCamera> camera;

  /// The time, or that of what changed after it.
  [[nodiscard]] vtkMTimeType Latest(vtkMTimeType time) const;
  void Print(ostream& os, vtkIndent indent, const int size[2]) const;
  /// Throws Error where there is no function, or no pixel.
  void Require(const int size[2]) const;
};

/// Whether it is another one.
template <class Object>
bool Replace(vtkSmartPointer<Object>& held, Object* object)
{
  const bool changed = held != object;
  held = object;
  return changed;
}
} // namespace pixelexact
#endif
