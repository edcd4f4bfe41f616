// SPDX-License-Identifier: BSD-3-Clause
#ifndef ContourList_h
#define ContourList_h

#include "PixelExactDataModelModule.h"

#include <vector>

namespace pixelexact
{
/// Contour values, numbered from 0 as in VTK's filters. Functions that change them return whether
/// they did.
class PIXELEXACTDATAMODEL_EXPORT ContourList
{
public:
  /// Values before it that were not set are 0. Does nothing where i is negative.
  bool Set(int i, double value);
  /// NaN where there is no such value.
  [[nodiscard]] double At(int i) const;
  bool Resize(int number);
  [[nodiscard]] int Size() const { return static_cast<int>(Values.size()); }
  /// Sets evenly spaced values, both ends included, as vtkContourValues does.
  bool Generate(int number, double lower, double upper);

  [[nodiscard]] const std::vector<double>& All() const { return Values; }
  [[nodiscard]] double* Data() { return Values.data(); }

private:
  std::vector<double> Values;
};
} // namespace pixelexact
#endif
