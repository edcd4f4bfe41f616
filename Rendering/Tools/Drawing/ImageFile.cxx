// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/ImageFile.h"

#include "Base/Command.h"
#include "Base/Output.h"
#include "Base/Provenance.h"
#include "Base/VtkMessages.h"
#include "Drawing/Picture.h"

#include "Core/Base/Error.h"

#include <png.h>
#include <tiffio.h>
#include <tiffio.hxx>
#include <vtkImageData.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <memory>
#include <sstream>

namespace pixelexact
{
namespace
{
struct Suffix
{
  const char* text;
  PictureFormat format;
};
constexpr std::array kSuffixes{ Suffix{ ".png", PictureFormat::Png },
  Suffix{ ".tif", PictureFormat::Tiff }, Suffix{ ".tiff", PictureFormat::Tiff },
  Suffix{ ".jpg", PictureFormat::Jpeg }, Suffix{ ".jpeg", PictureFormat::Jpeg },
  Suffix{ ".svg", PictureFormat::Svg }, Suffix{ ".pdf", PictureFormat::Pdf } };

constexpr double kInchesPerMetre = 1.0 / 0.0254;

vtkSmartPointer<vtkImageData> ToVtk(const Image& image)
{
  vtkNew<vtkUnsignedCharArray> pixels;
  pixels->SetName("Color");
  pixels->SetNumberOfComponents(image.channels);
  pixels->SetNumberOfTuples(static_cast<vtkIdType>(image.width) * image.height);
  std::ranges::copy(image.pixels, pixels->GetPointer(0));
  auto data = vtkSmartPointer<vtkImageData>::New();
  data->SetDimensions(image.width, image.height, 1);
  data->GetPointData()->SetScalars(pixels);
  return data;
}

/// Writes to memory, because VTK's writers do not detect a full disk.
template <class Writer>
std::string WriteToMemory(Writer& writer, const Image& image, const std::string& file)
{
  const ErrorsOfObject errors(writer);
  writer.WriteToMemoryOn();
  writer.SetInputData(ToVtk(image));
  writer.Write();
  if (!errors.First().empty())
  {
    throw Error("cannot write '" + file + "': " + errors.First());
  }
  vtkUnsignedCharArray* bytes = writer.GetResult();
  return { reinterpret_cast<const char*>(bytes->GetPointer(0)),
    static_cast<std::size_t>(bytes->GetNumberOfValues()) };
}

/// The most significant byte first.
std::string BigEndian(std::uint64_t number, int bytes)
{
  std::string text;
  for (int i = bytes; i-- > 0;)
  {
    text += static_cast<char>(number >> (8 * i) & 0xffU);
  }
  return text;
}

/// A chunk of a PNG: length, type, content and their sum (PNG specification, 5.3).
std::string PngChunk(const std::string& type, const std::string& content)
{
  const std::string summed = type + content;
  const auto sum =
    crc32(0, reinterpret_cast<const Bytef*>(summed.data()), static_cast<uInt>(summed.size()));
  return BigEndian(content.size(), 4) + summed + BigEndian(sum, 4);
}

/// A PNG without texts, for a picture that is shown once: no filters of rows, and a fast
/// level of zlib.
std::string EncodePngQuickly(const Image& image, const std::string& file)
{
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = image.channels == 4 ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
  header.flags = PNG_IMAGE_FLAG_FAST;
  // Rows are stored from the lowest to the highest.
  const png_int_32 row = -image.width * image.channels;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(
        &header, bytes.data(), &size, 0, image.pixels.data(), row, nullptr) == 0)
  {
    throw Error("cannot write '" + file + "': " + header.message);
  }
  bytes.resize(size);
  return bytes;
}

std::string EncodePng(const Image& image, const PictureFacts& facts, const std::string& file)
{
  if (facts.pngEffort == 1 && facts.texts.empty() && !facts.dpi)
  {
    return EncodePngQuickly(image, file);
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetCompressionLevel(facts.pngEffort);
  writer->AddText("Software", kPictureMark);
  for (const auto& [key, text] : facts.texts)
  {
    writer->AddText(key.c_str(), text.c_str());
  }
  std::string bytes = WriteToMemory(*writer, image, file);
  if (facts.dpi)
  {
    // Inserts pixels per metre, which VTK does not write, after the signature and the chunk IHDR,
    // as the PNG specification requires (11.3.4.3).
    constexpr std::size_t kBehindHeader = 8 + 25;
    const auto perMetre = static_cast<std::uint64_t>(std::lround(*facts.dpi * kInchesPerMetre));
    bytes.insert(
      kBehindHeader, PngChunk("pHYs", BigEndian(perMetre, 4) + BigEndian(perMetre, 4) + '\1'));
  }
  return bytes;
}

std::string EncodeJpeg(const Image& image, const PictureFacts& facts, const std::string& file)
{
  vtkNew<vtkJPEGWriter> writer;
  writer->SetQuality(facts.jpegQuality);
  std::string bytes = WriteToMemory(*writer, image, file);
  // The segment JFIF, which comes first, has units and density at its bytes 11 to 16 (ITU-T T.871,
  // 10.1).
  constexpr std::size_t kHeader = 2;
  if (bytes.compare(kHeader + 4, 4, "JFIF") != 0)
  {
    throw Error("cannot write '" + file + "': the JPEG has no JFIF header");
  }
  if (facts.dpi)
  {
    const auto dots = static_cast<std::uint64_t>(std::lround(*facts.dpi));
    bytes.replace(kHeader + 11, 5, '\1' + BigEndian(dots, 2) + BigEndian(dots, 2));
  }
  const std::size_t behind = kHeader + 2 + 256U * static_cast<unsigned char>(bytes[kHeader + 2]) +
    static_cast<unsigned char>(bytes[kHeader + 3]);
  PictureTexts texts{ { "Software", kPictureMark } };
  texts.insert(texts.end(), facts.texts.begin(), facts.texts.end());
  std::string comment = LinesOf(texts);
  // A segment's length has two bytes.
  comment.resize(std::min<std::size_t>(comment.size(), 65000));
  bytes.insert(behind, "\xff\xfe" + BigEndian(comment.size() + 2, 2) + comment);
  return bytes;
}

/// libtiff itself, because VTK's writer takes neither a resolution nor texts, and no memory.
std::string EncodeTiff(const Image& image, const PictureFacts& facts, const std::string& file)
{
  std::ostringstream stream;
  std::ostream& output = stream;
  const auto fail = [&file] { throw Error("cannot write '" + file + "': libtiff failed"); };
  bool written = true;
  {
    const std::unique_ptr<TIFF, decltype(&TIFFClose)> tiff(
      TIFFStreamOpen("picture", &output), &TIFFClose);
    if (!tiff)
    {
      fail();
    }
    TIFF* to = tiff.get();
    TIFFSetField(to, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(image.width));
    TIFFSetField(to, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(image.height));
    TIFFSetField(to, TIFFTAG_BITSPERSAMPLE, 8);
    TIFFSetField(to, TIFFTAG_SAMPLESPERPIXEL, image.channels);
    TIFFSetField(to, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
    TIFFSetField(to, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(to, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
    TIFFSetField(to, TIFFTAG_COMPRESSION, COMPRESSION_LZW);
    TIFFSetField(to, TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL);
    if (image.channels == 4)
    {
      std::array<std::uint16_t, 1> straight{ EXTRASAMPLE_UNASSALPHA };
      TIFFSetField(to, TIFFTAG_EXTRASAMPLES, 1, straight.data());
    }
    if (facts.dpi)
    {
      TIFFSetField(to, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
      TIFFSetField(to, TIFFTAG_XRESOLUTION, *facts.dpi);
      TIFFSetField(to, TIFFTAG_YRESOLUTION, *facts.dpi);
    }
    TIFFSetField(to, TIFFTAG_SOFTWARE, kPictureMark);
    if (!facts.texts.empty())
    {
      TIFFSetField(to, TIFFTAG_IMAGEDESCRIPTION, LinesOf(facts.texts).c_str());
    }
    TIFFSetField(to, TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(to, 0));
    const auto row =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
    std::vector<std::uint8_t> copy(row);
    for (int y = 0; y < image.height; ++y)
    {
      // libtiff may change what it is given.
      std::copy_n(
        &image.pixels[row * static_cast<std::size_t>(image.height - 1 - y)], row, copy.begin());
      written =
        written && TIFFWriteScanline(to, copy.data(), static_cast<std::uint32_t>(y), 0) == 1;
    }
    written = written && TIFFFlush(to) == 1;
  }
  if (!written || !stream)
  {
    fail();
  }
  return stream.str();
}
} // namespace

PictureFormat FormatOf(const char* option, const std::string& file)
{
  if (IsStandardStream(file))
  {
    return PictureFormat::Png;
  }
  std::string suffix = std::filesystem::path(file).extension().string();
  std::ranges::transform(
    suffix, suffix.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto* found = std::ranges::find(kSuffixes, suffix, &Suffix::text);
  if (found == kSuffixes.end())
  {
    throw UsageError(std::string(option) + ": '" + file +
      "' ends as no picture that is written here: .png, .tif, .jpg, .svg or .pdf; name it so");
  }
  return found->format;
}

bool IsVector(PictureFormat format)
{
  return format == PictureFormat::Svg || format == PictureFormat::Pdf;
}

bool HasAlpha(PictureFormat format)
{
  return format != PictureFormat::Jpeg;
}

std::string EncodeImage(
  const Image& image, PictureFormat format, const PictureFacts& facts, const std::string& file)
{
  switch (format)
  {
    case PictureFormat::Tiff:
      return EncodeTiff(image, facts, file);
    case PictureFormat::Jpeg:
      return EncodeJpeg(image, facts, file);
    default:
      return EncodePng(image, facts, file);
  }
}
} // namespace pixelexact
