// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "Output.h"
#include "VtkMessages.h"

#include "Core/Base/Error.h"
#include "FrameImage.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>

namespace pixelexact
{
namespace
{
/// Throws Error where a writer could not make the file's content.
template <class Writer>
void Encode(Writer& writer, const std::string& file, vtkDataObject* data)
{
  const VtkMessages messages;
  writer.SetInputData(data);
  writer.Write();
  if (const std::string error = messages.FirstError(); !error.empty())
  {
    throw Error("cannot write '" + file + "': " + error);
  }
}

void WriteBytes(const std::string& file, const char* bytes, std::size_t size)
{
  OutputFile output(file);
  output.Stream().write(bytes, static_cast<std::streamsize>(size));
  output.Close();
}

/// Inline and not appended: ParaView 5.11 of Debian 12 cannot read the latter with the newest
/// expat. Higher levels take longer for some percent less. A header of 32 bits would end at 4 GB.
void SetFormat(vtkXMLWriter& writer)
{
  writer.SetDataModeToBinary();
  writer.SetCompressorTypeToZLib();
  writer.SetCompressionLevel(1);
  writer.SetHeaderTypeToUInt64();
}

/// All arrays but these go; empty: none does.
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
} // namespace

void WritePng(const std::string& file, int width, int height, const std::vector<std::uint8_t>& rgb,
  const PictureTexts& texts)
{
  vtkNew<vtkUnsignedCharArray> pixels;
  pixels->SetName("Color");
  pixels->SetNumberOfComponents(3);
  pixels->SetNumberOfTuples(static_cast<vtkIdType>(width) * height);
  std::copy(rgb.begin(), rgb.end(), pixels->GetPointer(0));
  vtkNew<vtkImageData> image;
  image->SetDimensions(width, height, 1);
  image->GetPointData()->SetScalars(pixels);
  vtkNew<vtkPNGWriter> writer;
  // In memory, because VTK's writers do not see that a disk is full.
  writer->WriteToMemoryOn();
  writer->AddText("Software", kPictureMark);
  for (const auto& [key, text] : texts)
  {
    writer->AddText(key.c_str(), text.c_str());
  }
  Encode(*writer, file, image);
  vtkUnsignedCharArray* bytes = writer->GetResult();
  WriteBytes(file, reinterpret_cast<const char*>(bytes->GetPointer(0)),
    static_cast<std::size_t>(bytes->GetNumberOfValues()));
}

void WriteBuffers(const std::string& file, const std::vector<std::string>& arrays,
  const Frame& frame, std::span<const std::int64_t> sourceCells,
  std::span<const std::uint8_t> contours)
{
  vtkNew<vtkXMLImageDataWriter> writer;
  SetFormat(*writer);
  writer->WriteToOutputStringOn();
  const vtkSmartPointer<vtkImageData> image = ToImageData(frame, sourceCells);
  AddContours(*image, contours);
  Keep(arrays, *image->GetPointData());
  Encode(*writer, file, image);
  const std::string text = writer->GetOutputString();
  WriteBytes(file, text.data(), text.size());
}

void WriteLines(const std::string& file, vtkPolyData* lines)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  SetFormat(*writer);
  writer->WriteToOutputStringOn();
  Encode(*writer, file, lines);
  const std::string text = writer->GetOutputString();
  WriteBytes(file, text.data(), text.size());
}
} // namespace pixelexact
