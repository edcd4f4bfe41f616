// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/Picture.h"

#include "Base/Output.h"
#include "Base/VtkMessages.h"

#include "Core/Base/Error.h"
#include "Frames/FrameImage.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationDoubleVectorKey.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <array>

namespace pixelexact
{
namespace
{
/// Throws Error where a writer fails to encode the file.
template <class Writer>
void Encode(Writer& writer, const std::string& file, vtkDataObject* data)
{
  const ErrorsOfObject errors(writer);
  writer.SetInputData(data);
  writer.Write();
  if (!errors.First().empty())
  {
    throw Error("cannot write '" + file + "': " + errors.First());
  }
}

/// Data are inline, not appended: ParaView 5.11 of Debian 12 cannot read appended data with the
/// newest expat. Higher levels of compression take longer and save a few percent. A header of 32
/// bits would limit data to 4 GB.
void SetFormat(vtkXMLWriter& writer)
{
  writer.SetDataModeToBinary();
  writer.SetCompressorTypeToZLib();
  writer.SetCompressionLevel(1);
  writer.SetHeaderTypeToUInt64();
}

/// Removes all arrays except these; keeps all where `arrays` is empty.
void Keep(const std::vector<std::string>& arrays, vtkPointData& data)
{
  for (int i = data.GetNumberOfArrays(); i-- > 0 && !arrays.empty();)
  {
    if (std::ranges::find(arrays, data.GetArrayName(i)) == arrays.end())
    {
      data.RemoveArray(i);
    }
  }
}

/// Sets an empty range of lengths for vectors whose values are all NaN. VTK's writers would store
/// it as a text that VTK's readers warn about.
void NameEmptyRanges(vtkPointData& data)
{
  for (int i = 0; i < data.GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data.GetArray(i);
    if (array == nullptr || array->GetNumberOfComponents() < 2)
    {
      continue;
    }
    std::array<double, 2> lengths{};
    array->GetRange(lengths.data(), -1);
    if (!(lengths[0] <= lengths[1]))
    {
      constexpr std::array<double, 2> kEmptyRange{ 1.0, -1.0 };
      array->GetInformation()->Set(vtkDataArray::L2_NORM_RANGE(), kEmptyRange.data(), 2);
    }
  }
}

std::string EncodeImage(const std::string& file, vtkImageData* image)
{
  NameEmptyRanges(*image->GetPointData());
  vtkNew<vtkXMLImageDataWriter> writer;
  SetFormat(*writer);
  writer->WriteToOutputStringOn();
  Encode(*writer, file, image);
  return writer->GetOutputString();
}
} // namespace

std::string EncodeBuffers(const std::string& file, const std::vector<std::string>& arrays,
  const Frame& frame, std::span<const std::int64_t> sourceCells,
  std::span<const std::uint8_t> contours)
{
  const vtkSmartPointer<vtkImageData> image = ToImageData(frame, sourceCells);
  AddContours(*image, contours);
  Keep(arrays, *image->GetPointData());
  return EncodeImage(file, image);
}

void WriteImage(const std::string& file, vtkImageData* image)
{
  WriteBytes(file, EncodeImage(file, image));
}

void WriteLines(const std::string& file, vtkPolyData* lines)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  SetFormat(*writer);
  writer->WriteToOutputStringOn();
  Encode(*writer, file, lines);
  WriteBytes(file, writer->GetOutputString());
}
} // namespace pixelexact
