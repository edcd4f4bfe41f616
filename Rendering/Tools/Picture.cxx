// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "VtkMessages.h"

#include "Core/Base/Error.h"
#include "FrameImage.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLImageDataWriter.h>

#include <algorithm>
#include <fstream>

namespace pixelexact
{
namespace
{
[[noreturn]] void CannotWrite(const std::string& file)
{
  throw Error("cannot write '" + file + "'; does its folder exist and is there room?");
}

/// VTK's writers say little about why; whether the file can be written at all shows before.
template <class Writer>
void WriteWith(Writer& writer, const std::string& file, vtkImageData* image)
{
  if (!std::ofstream(file, std::ios::binary))
  {
    CannotWrite(file);
  }
  const VtkMessages messages;
  writer.SetFileName(file.c_str());
  writer.SetInputData(image);
  writer.Write();
  if (writer.GetErrorCode() != 0 || !messages.FirstError().empty())
  {
    CannotWrite(file);
  }
}
} // namespace

void WritePng(const std::string& file, int width, int height, const std::vector<std::uint8_t>& rgb)
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
  WriteWith(*writer, file, image);
}

void WriteBuffers(
  const std::string& file, const Frame& frame, std::span<const std::int64_t> sourceCells)
{
  vtkNew<vtkXMLImageDataWriter> writer;
  // Inline and not appended: ParaView 5.11 of Debian 12 cannot read the latter with the newest
  // expat. Doubles of a smooth field hardly compress. A header of 32 bits would end at 4 GB.
  writer->SetDataModeToBinary();
  writer->SetCompressorTypeToNone();
  writer->SetHeaderTypeToUInt64();
  WriteWith(*writer, file, ToImageData(frame, sourceCells));
}
} // namespace pixelexact
