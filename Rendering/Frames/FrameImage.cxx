// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/FrameImage.h"

#include "HighOrderModel.h"
#include "Trace/BufferTable.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace pixelexact
{
vtkSmartPointer<vtkImageData> ToImageData(
  const Renderer& frames, const HighOrderModel& model, const Frame& frame)
{
  auto image = ToImageData(frame, model.SourceCells(), model.Blocks());
  if (const ContourCertifier* contours = frames.LastContours())
  {
    AddContours(*image, contours->Verdicts());
  }
  return image;
}

vtkSmartPointer<vtkImageData> TracePicture(Renderer& frames, const View& view,
  const RenderWork& work, const HighOrderModel& model, bool allBuffers, const Progress& progress)
{
  const Frame* frame = &frames.Render(view, work, progress);
  return frames.IsComplete()
    ? ToImageData(frames, model, allBuffers ? *frames.FrameWithAllBuffers() : *frame)
    : nullptr;
}

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

/// The VTK array type that stores a buffer's numbers.
template <class T>
struct ArrayFor;
template <>
struct ArrayFor<double>
{
  using Type = vtkDoubleArray;
};
template <>
struct ArrayFor<std::int32_t>
{
  using Type = vtkTypeInt32Array;
};
template <>
struct ArrayFor<std::int64_t>
{
  using Type = vtkTypeInt64Array;
};
template <>
struct ArrayFor<std::uint8_t>
{
  using Type = vtkUnsignedCharArray;
};

template <class T>
void AddBuffer(vtkImageData* image, const char* name, const std::vector<T>& values)
{
  std::ranges::copy(values, AddArray<typename ArrayFor<T>::Type>(image, name, 1, values.size()));
}
void AddBuffer(vtkImageData* image, const char* name, const std::vector<Vec3>& values)
{
  double* out = AddArray<vtkDoubleArray>(image, name, 3, values.size());
  for (const Vec3& value : values)
  {
    out = std::copy_n(glm::value_ptr(value), 3, out);
  }
}

void AddBlocks(vtkImageData* image, const std::vector<std::int64_t>& elements,
  std::span<const HighOrderModel::Block> blocks)
{
  std::ranges::transform(elements, AddArray<vtkTypeInt64Array>(image, "Block", 1, elements.size()),
    [&](std::int64_t element)
    { return element < 0 ? -1 : HighOrderModel::BlockOf(element, blocks).flatIndex; });
}

void TranslateElements(vtkImageData* image, std::span<const std::int64_t> sourceCells)
{
  auto* elements = vtkTypeInt64Array::SafeDownCast(image->GetPointData()->GetArray("Element"));
  for (vtkIdType i = 0; elements != nullptr && i < elements->GetNumberOfTuples(); ++i)
  {
    const std::int64_t element = elements->GetValue(i);
    if (element >= 0)
    {
      elements->SetValue(i, sourceCells[static_cast<std::size_t>(element)]);
    }
  }
}
} // namespace

vtkSmartPointer<vtkImageData> ToImageData(const Frame& frame,
  std::span<const std::int64_t> sourceCells, std::span<const HighOrderModel::Block> blocks)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(frame.width, frame.height, 1);
  ForEachBuffer(
    [&](const auto& row)
    {
      const auto& values = frame.centres.*row.member;
      if (!values.empty())
      {
        AddBuffer(image, row.name, values);
      }
    });
  if (!blocks.empty() && !frame.centres.element.empty())
  {
    AddBlocks(image, frame.centres.element, blocks);
  }
  if (!sourceCells.empty())
  {
    TranslateElements(image, sourceCells);
  }
  const std::vector<std::uint8_t>& color = frame.Image();
  if (!color.empty())
  {
    std::ranges::copy(color, AddArray<vtkUnsignedCharArray>(image, "Color", 4, color.size() / 4));
  }
  return image;
}

void AddContours(vtkImageData& image, std::span<const std::uint8_t> verdicts)
{
  if (!verdicts.empty())
  {
    std::ranges::copy(
      verdicts, AddArray<vtkUnsignedCharArray>(&image, "Contour", 1, verdicts.size()));
  }
}
} // namespace pixelexact
