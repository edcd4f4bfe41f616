// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/DifferenceImage.h"

#include "Frames/FrameImage.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <vector>

namespace pixelexact
{
namespace
{
template <class Array, class T>
void AddArray(vtkImageData& image, const char* name, const std::vector<T>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::ranges::copy(values, array->GetPointer(0));
  image.GetPointData()->AddArray(array);
}
} // namespace

vtkSmartPointer<vtkImageData> ToImageData(const FieldDifference& difference,
  std::span<const std::int64_t> firstCells, std::span<const std::int64_t> secondCells)
{
  Frame frame = difference.frame;
  std::vector<std::int64_t>& elements = frame.centres.element;
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    const auto& cells = difference.seen[i] == 2 ? secondCells : firstCells;
    if (elements[i] >= 0 && !cells.empty())
    {
      elements[i] = cells[static_cast<std::size_t>(elements[i])];
    }
  }
  auto image = ToImageData(frame, {});
  AddArray<vtkDoubleArray>(*image, "First", difference.first);
  AddArray<vtkDoubleArray>(*image, "Second", difference.second);
  AddArray<vtkUnsignedCharArray>(*image, "Side", difference.side);
  AddArray<vtkUnsignedCharArray>(*image, "Seen", difference.seen);
  return image;
}
} // namespace pixelexact
