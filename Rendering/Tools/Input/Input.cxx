// SPDX-License-Identifier: BSD-3-Clause
#include "Input/Input.h"

#include "Base/Command.h"
#include "Base/Report.h"
#include "Input/ExodusName.h"
#include "Input/Format.h"

#include "Conversion/SourceCells.h"
#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Files/TimeSeries.h"
#include "Formats/FileText.h"
#include "Formats/MFEM/Text/PieceNames.h"
#include "Formats/Nek5000/Series.h"

#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <new>
#include <string_view>
#include <utility>
#include <vector>

namespace pixelexact
{
namespace
{
/// The format with this suffix; null where there is none.
const Format* FindFormat(std::string suffix)
{
  // Pieces of MFEM's parallel runs have a number as suffix.
  suffix = mfem::IsPieceName("x" + suffix) ? ".mesh" : suffix;
  // Nek5000's steps have theirs in the suffix.
  suffix = nek5000::IsStepName("x" + suffix) ? ".f00000" : suffix;
  const std::span<const Format> formats = Formats();
  const auto format = std::ranges::find(formats, suffix, &Format::suffix);
  return format == formats.end() ? nullptr : &*format;
}

/// Checks that a file exists and may be read, before a reader opens it.
void CheckFile(const std::string& file)
{
  std::error_code failure;
  const auto status = std::filesystem::status(file, failure);
  if (!std::filesystem::exists(status))
  {
    CannotRead(file, "there is no such file");
  }
  if (std::filesystem::is_directory(status))
  {
    // Parallel runs of Nektar++ write a folder of parts.
    if (const Format* format = FindFormat(LowerSuffix(file));
        format != nullptr && format->mayBeFolder)
    {
      return;
    }
    CannotRead(file, "it is a folder; name a file");
  }
  if (IsPipeOrDevice(file))
  {
    CannotRead(file, kPipeRemedy);
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
  {
    CannotRead(file, "it cannot be opened; check its permissions");
  }
  if (stream.peek() == std::ifstream::traits_type::eof())
  {
    CannotRead(file, "it is empty");
  }
  constexpr std::string_view kPointer = "version https://git-lfs.github.com/spec/";
  std::string begin(kPointer.size(), '\0');
  stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  if (begin == kPointer)
  {
    CannotRead(file, "it is a pointer of Git LFS; bring the file itself: git lfs pull");
  }
}

/// The suffix of the format: that of the mesh for "x.mesh.gz", and ".e" for "x.e-s002" and
/// "x.e.4.0".
std::string SuffixOf(const std::string& file)
{
  if (IsExodusPart(file))
  {
    return ".e";
  }
  const std::string suffix = LowerSuffix(file);
  return suffix == ".gz" ? LowerSuffix(file.substr(0, file.size() - suffix.size())) : suffix;
}

/// Refuses further files that belong to an option or are another mesh.
void CheckCompanions(const std::vector<std::string>& files, const Format& format)
{
  for (std::size_t i = 1; i < files.size(); ++i)
  {
    const std::string suffix = SuffixOf(files[i]);
    if (suffix == ".csv")
    {
      throw UsageError("'" + files[i] +
        "' holds neither mesh nor field; points of probe are given "
        "as --points FILE");
    }
    const Format* other = FindFormat(suffix);
    if (other != nullptr && std::string_view(other->name) != format.name)
    {
      throw UsageError("'" + files[0] + "' (" + format.name + ") and '" + files[i] + "' (" +
        other->name + ") do not go together; name one mesh, and its own fields");
    }
    if (suffix == ".mesh")
    {
      throw UsageError(
        "'" + files[0] + "' and '" + files[i] + "' are two meshes; name one, and its fields");
    }
    const auto here = files.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(files.begin(), here, files[i]) != here)
    {
      throw UsageError("'" + files[i] + "' was given more than once; give it once");
    }
  }
}

std::string Span(std::span<const double> times)
{
  return Short(times.front()) + " to " + Short(times.back());
}
} // namespace

void CannotRead(const std::string& file, const std::string& why)
{
  throw Error("cannot read '" + file + "': " + why);
}

void CheckAlone(const std::vector<std::string>& files)
{
  if (files.size() > 1)
  {
    throw UsageError("'" + files[0] + "' holds mesh and fields, but " +
      std::to_string(files.size()) + " files were given; name it alone");
  }
}

int ChooseStep(const InputRequest& request, std::span<const double> times)
{
  const std::string& file = request.files[0];
  if (times.empty() && (request.time || request.step.value_or(0) > 0))
  {
    throw Error("'" + file + "' has no time steps; leave out --time and --time-step");
  }
  if (request.step)
  {
    if (*request.step > 0 && *request.step >= static_cast<int>(times.size()))
    {
      throw Error("--time-step: '" + file + "' has " + Counted(times.size(), "time step") +
        ", counted from 0");
    }
    return *request.step;
  }
  if (!request.time)
  {
    return 0;
  }
  const double time = *request.time;
  // A time that was printed may be slightly outside of the range.
  const double slack = 1e-5 * std::max(std::abs(times.front()), std::abs(times.back()));
  if (time < times.front() - slack || time > times.back() + slack)
  {
    throw Error("--time: the times of '" + file + "' are " + Span(times));
  }
  const auto nearest = std::ranges::min_element(
    times, {}, [time](double candidate) { return std::abs(candidate - time); });
  return static_cast<int>(nearest - times.begin());
}

namespace
{
/// The suffixes of mesh files, separated by commas.
std::string InputSuffixes()
{
  std::string suffixes;
  for (const Format& format : Formats())
  {
    if (format.hasMesh)
    {
      suffixes.append(suffixes.empty() ? "" : ", ").append(format.suffix);
    }
  }
  return suffixes;
}

/// What the beginning of a file with an unknown suffix says of its format, as the rest of a
/// sentence.
std::string RecognisedBy(const std::string& file)
{
  constexpr std::size_t kBeginning = 1024; // XML has lines before its first element
  std::string begin(kBeginning, '\0');
  std::ifstream(file, std::ios::binary).read(begin.data(), kBeginning);
  // Lines before the mark are XML's and those of VTK's legacy files; bytes, those of a signature.
  constexpr std::size_t kSignature = 4;
  const bool hasHead = begin.starts_with('<') || begin.starts_with("# vtk");
  std::string likely;
  std::vector<std::pair<std::string, std::string>> looked; // marks, and the formats that have them
  std::string_view last; // of the formats named, whose suffixes follow one another
  for (const Format& format : Formats())
  {
    for (const char* mark : format.marks)
    {
      if (mark == nullptr || !format.hasMesh || last == format.name)
      {
        continue;
      }
      const std::string shown(mark, std::string_view(mark).find_last_not_of("\r\n ") + 1);
      const auto known =
        std::ranges::find(looked, shown, &std::pair<std::string, std::string>::first);
      if (known == looked.end())
      {
        looked.emplace_back(shown, format.name);
      }
      else if (!known->second.ends_with(format.name))
      {
        known->second.append("; ").append(format.name);
      }
      const std::size_t at = begin.find(mark);
      if (at <= kSignature || (at != std::string::npos && hasHead))
      {
        last = format.name;
        likely.append(likely.empty() ? "" : " or ").append(format.name);
        likely.append(" (").append(format.suffix).append(")");
      }
    }
  }
  if (!likely.empty())
  {
    return "it begins as files of " + likely + " do; give it such a suffix";
  }
  std::string marks;
  for (const auto& [mark, formats] : looked)
  {
    marks.append(marks.empty() ? "'" : ", '").append(mark).append("' (").append(formats);
    marks.append(")");
  }
  return "it begins with none of the marks " + marks;
}

/// Reads the input without checking the result.
InputGrid Read(const InputRequest& request)
{
  const std::string& first = request.files[0];
  CheckFile(first);
  const Format* format = FindFormat(SuffixOf(first));
  if (format == nullptr)
  {
    throw UnknownFormat("cannot read '" + first + "': its suffix is of no format known here, and " +
      RecognisedBy(first) + "; suffixes are " + InputSuffixes() +
      ", and .000000 of a piece of an MFEM mesh");
  }
  if (format->remedy != nullptr)
  {
    throw UnknownFormat("cannot read '" + first + "': files of " + std::string(format->name) +
      " are not read; " + format->remedy);
  }
  CheckCompanions(request.files, *format);
  std::for_each(request.files.begin() + 1, request.files.end(), CheckFile);
  try
  {
    return format->read(request);
  }
  catch (const InvalidData& error)
  {
    CannotRead(first, error.what());
  }
  catch (const std::bad_alloc&)
  {
    // A damaged header may request any amount of memory, and so does a file that is too large.
    CannotRead(first, "it asks for more memory than there is");
  }
}
} // namespace

namespace
{
std::function<bool(double)> listening;
} // namespace

ReadListener::ReadListener(std::function<bool(double)> progress)
{
  listening = std::move(progress);
}

ReadListener::~ReadListener()
{
  listening = nullptr;
}

bool ReadListener::Report(double part)
{
  return !listening || listening(part);
}

std::vector<double> ReadTimes(InputRequest request)
{
  request.timesAlone = true;
  return Read(request).times;
}

bool HoldsFieldsAlone(const std::string& file)
{
  const Format* format = FindFormat(SuffixOf(file));
  return format != nullptr && !format->hasMesh;
}

bool IsMeshSuffix(const std::string& suffix)
{
  const Format* format = FindFormat(suffix);
  return format != nullptr && format->hasMesh;
}

InputGrid ReadInput(const InputRequest& request)
{
  InputGrid input = Read(request);
  try
  {
    CheckConsistency(*input.grid);
  }
  catch (const InvalidData& error)
  {
    CannotRead(request.files[0], error.what());
  }
  return input;
}
} // namespace pixelexact
