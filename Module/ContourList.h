// SPDX-License-Identifier: BSD-3-Clause
#ifndef ContourList_h
#define ContourList_h

#include "PixelExactDataModelModule.h"

#include <vector>

namespace pixelexact
{
/// Contour values as VTK's filters keep them: numbered from 0. What changes them says whether
/// it did.
class PIXELEXACTDATAMODEL_EXPORT ContourList
{
public:
  /// Those between that were not set are 0. Nothing is done where i is negative.
  bool Set(int i, double value);
  /// NaN where there is no such value.
  [[nodiscard]] double At(int i) const;
  bool Resize(int number);
  [[nodiscard]] int Size() const { return static_cast<int>(Values.size()); }
  /// As vtkContourValues: evenly spaced, both ends among them.
  bool Generate(int number, double lower, double upper);

  [[nodiscard]] const std::vector<double>& All() const { return Values; }
  [[nodiscard]] double* Data() { return Values.data(); }

private:
  std::vector<double> Values;
};
} // namespace pixelexact
#endif
