// SPDX-License-Identifier: BSD-3-Clause
#include "FrameImage.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
template <typename Array>
auto* AddArray(vtkImageData* image, const char* name, int components, std::size_t tuples)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  image->GetPointData()->AddArray(array);
  return array->GetPointer(0);
}

void AddDoubles(vtkImageData* image, const char* name, const std::vector<double>& values)
{
  if (!values.empty())
  {
    std::copy(
      values.begin(), values.end(), AddArray<vtkDoubleArray>(image, name, 1, values.size()));
  }
}

void AddVectors(vtkImageData* image, const char* name, const std::vector<Vec3>& values)
{
  if (values.empty())
  {
    return;
  }
  double* out = AddArray<vtkDoubleArray>(image, name, 3, values.size());
  for (const Vec3& value : values)
  {
    *out++ = value.x;
    *out++ = value.y;
    *out++ = value.z;
  }
}

void AddBytes(
  vtkImageData* image, const char* name, int components, const std::vector<std::uint8_t>& values)
{
  if (!values.empty())
  {
    std::copy(values.begin(), values.end(),
      AddArray<vtkUnsignedCharArray>(
        image, name, components, values.size() / static_cast<std::size_t>(components)));
  }
}
} // namespace

vtkSmartPointer<vtkImageData> ToImageData(
  const Frame& frame, std::span<const std::int64_t> sourceCells)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(frame.width, frame.height, 1);
  const SampleBuffers& samples = frame.centres;
  AddDoubles(image, "Value", samples.value);
  AddVectors(image, "Position", samples.position);
  AddVectors(image, "Normal", samples.normal);
  AddVectors(image, "Xi", samples.xi);
  if (!samples.element.empty())
  {
    auto* out = AddArray<vtkTypeInt64Array>(image, "Element", 1, samples.element.size());
    std::transform(samples.element.begin(), samples.element.end(), out,
      [sourceCells](std::int64_t element)
      {
        return element < 0 || sourceCells.empty() ? element
                                                  : sourceCells[static_cast<std::size_t>(element)];
      });
  }
  AddDoubles(image, "Depth", samples.depth);
  AddBytes(image, "Verdict", 1, samples.verdict);
  if (!samples.owners.empty())
  {
    std::copy(samples.owners.begin(), samples.owners.end(),
      AddArray<vtkTypeInt32Array>(image, "Owners", 1, samples.owners.size()));
  }
  AddBytes(image, "Coverage", 1, samples.coverage);
  AddDoubles(image, "Value_lower", samples.valueLower);
  AddDoubles(image, "Value_upper", samples.valueUpper);
  AddBytes(image, "Color", 4, frame.color);
  return image;
}
} // namespace pixelexact
