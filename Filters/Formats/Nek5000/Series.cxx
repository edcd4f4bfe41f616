// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nek5000/Series.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Core/Base/ParseWhole.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <functional>
#include <set>

namespace pixelexact::nek5000
{
namespace
{
namespace fs = std::filesystem;

constexpr int kMaxDigits = 20;

std::string Padded(std::int64_t number, int digits)
{
  const std::string text = std::to_string(number);
  const auto missing =
    static_cast<std::ptrdiff_t>(digits) - static_cast<std::ptrdiff_t>(text.size());
  return std::string(static_cast<std::size_t>(std::max<std::ptrdiff_t>(missing, 0)), '0') + text;
}

bool IsFile(const std::string& path)
{
  std::error_code failure;
  return fs::is_regular_file(path, failure);
}

bool IsSeriesName(const std::string& path)
{
  std::string suffix = fs::path(path).extension().string();
  std::ranges::transform(suffix, suffix.begin(),
    [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return suffix == ".nek5000";
}

Header ReadHeader(const std::string& file)
{
  RequireRegularFile(file);
  return ParseHeader(file, ReadFileHead(file, kHeaderBytes));
}

//------------------------------------------------------------------------------
// Templates of names.

/// A template's texts between its numbers, and the digits of these.
struct Template
{
  std::vector<std::string> literals{ "" };
  std::vector<int> digits;
};

/// Parses a template as C's printf does, with %d, %5d, %05d and %%.
Template ParseTemplate(const std::string& text)
{
  Template parsed;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    if (text[i] != '%')
    {
      parsed.literals.back() += text[i];
      continue;
    }
    const std::size_t end = std::min(text.find_first_not_of("0123456789", i + 1), text.size());
    const std::string_view width = std::string_view(text).substr(i + 1, end - i - 1);
    const char kind = end < text.size() ? text[end] : '\0';
    int digits = 1;
    if (kind == '%' && width.empty())
    {
      parsed.literals.back() += '%';
    }
    else if ((kind == 'd' || kind == 'i') &&
      (width.empty() || (ParseWhole(width, digits) && digits <= kMaxDigits)))
    {
      parsed.digits.push_back(digits);
      parsed.literals.emplace_back();
    }
    else
    {
      throw InvalidData("'" + text.substr(i, end - i + 1) +
        "' in the filetemplate is no number of a file; write %d or %05d.");
    }
    i = end;
  }
  if (parsed.digits.empty())
  {
    throw InvalidData("the filetemplate '" + text +
      "' has no %d for the number of the step; write it as x%01d.f%05d.");
  }
  return parsed;
}

//------------------------------------------------------------------------------
// Names of the other parts of a step, from that of one.

/// The ways in which a text may end with the number of a part: how many of its last digits spell
/// it. The first one is that of Nek5000, which writes as many digits as the number of parts has.
std::vector<int> EndingsOf(const std::string& text, const Header& header)
{
  const std::size_t digits = text.size() - (text.find_last_not_of("0123456789") + 1);
  std::vector<int> endings;
  for (int n = 1; n <= kMaxDigits && static_cast<std::size_t>(n) <= digits; ++n)
  {
    const std::string number = Padded(header.part, n);
    if (number.size() == static_cast<std::size_t>(n) && text.ends_with(number))
    {
      endings.push_back(n);
    }
  }
  const auto usual = static_cast<int>(std::to_string(header.parts).size());
  std::stable_partition(endings.begin(), endings.end(), [usual](int n) { return n == usual; });
  return endings;
}

/// A text's part before its last `digits` digits.
std::string Before(const std::string& text, int digits)
{
  return text.substr(0, text.size() - static_cast<std::size_t>(digits));
}

/// The names of all parts of a step: the number of a part stands before the suffix, and may stand
/// at the end of the folder's name (A00/x00.f00001).
PartNames NamesFromOne(const std::string& file, const Header& header)
{
  if (header.parts == 1)
  {
    return PartNames(file);
  }
  const fs::path path(file);
  const std::string suffix = path.extension().string();
  const std::string stem = path.stem().string();
  const std::string folder = path.parent_path().string();
  const std::string separator = path.has_parent_path() ? "/" : "";
  std::vector<PartNames> candidates;
  for (const int digits : EndingsOf(stem, header))
  {
    PartNames names(folder + separator + Before(stem, digits));
    names.Append(digits, suffix);
    candidates.push_back(names);
  }
  for (const int inFolder : EndingsOf(folder, header))
  {
    for (const int digits : EndingsOf(stem, header))
    {
      PartNames names(Before(folder, inFolder));
      names.Append(inFolder, "/" + Before(stem, digits));
      names.Append(digits, suffix);
      candidates.push_back(names);
    }
  }
  if (candidates.empty())
  {
    throw InvalidData(file + ": it is part " + std::to_string(header.part) + " of " +
      std::to_string(header.parts) +
      " of a step, but its name does not have this number before the suffix; restore the files' "
      "names, or name an x.nek5000 that gives them (filetemplate: x%02d.f%05d).");
  }
  const auto countParts = [&header](const PartNames& names)
  {
    std::int64_t part = 0;
    while (part < header.parts && IsFile(names.Of(part)))
    {
      ++part;
    }
    return part;
  };
  return *std::ranges::max_element(candidates, {}, countParts); // the first of equal ones
}

std::string LineOf(const NamedText& file, std::size_t line)
{
  return file.name + ", line " + std::to_string(line) + ": ";
}

[[noreturn]] void RefuseMissing(
  const std::string& missing, std::int64_t step, std::int64_t count, const std::string& list)
{
  throw InvalidData(missing + " is missing: it is step " + std::to_string(step) + " of the " +
    std::to_string(count) + " that " + list +
    " lists; have it in place, or correct filetemplate, firsttimestep and numtimesteps.");
}
} // namespace

bool IsStepName(const std::string& path)
{
  const std::string suffix = fs::path(path).extension().string();
  return suffix.size() >= 7 && suffix.starts_with(".f") &&
    std::all_of(suffix.begin() + 2, suffix.end(), &IsDigit);
}

std::string PartNames::Of(std::int64_t part) const
{
  std::string name = Literals.front();
  for (std::size_t i = 0; i < Digits.size(); ++i)
  {
    name += Padded(part, Digits[i]) + Literals[i + 1];
  }
  return name;
}

void PartNames::Append(int digits, const std::string& literal)
{
  Digits.push_back(digits);
  Literals.push_back(literal);
}

PartNames SeriesFile::NamesOf(const std::string& path, std::int64_t step) const
{
  const Template parsed = ParseTemplate(fileTemplate);
  // The last number is the step's.
  const std::size_t last = parsed.digits.size() - 1;
  const auto literal = [&](std::size_t i)
  {
    return i < last
      ? parsed.literals[i]
      : parsed.literals[last] + Padded(step, parsed.digits[last]) + parsed.literals[last + 1];
  };
  PartNames names((fs::path(path).parent_path() / literal(0)).string());
  for (std::size_t i = 0; i < last; ++i)
  {
    names.Append(parsed.digits[i], literal(i + 1));
  }
  return names;
}

SeriesFile ParseSeriesFile(const NamedText& file)
{
  SeriesFile series;
  std::set<std::string> found;
  std::string_view rest = file.text;
  for (std::size_t line = 1; !rest.empty(); ++line)
  {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view text = WithoutBlanks(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (text.empty() || text.starts_with('#'))
    {
      continue;
    }
    const std::size_t colon = std::min(text.find(':'), text.size());
    const std::string key(text.substr(0, colon));
    const std::string_view value = WithoutBlanks(text.substr(std::min(colon + 1, text.size())));
    const auto readCount = [&](std::int64_t low)
    {
      std::int64_t number = 0;
      if (!ParseWhole(value, number) || number < low)
      {
        throw InvalidData(LineOf(file, line) + key + " must be a whole number from " +
          std::to_string(low) + "; correct it.");
      }
      return number;
    };
    if (key == "filetemplate")
    {
      series.fileTemplate = value;
      NameErrors(
        file.name + ", line " + std::to_string(line), [&] { ParseTemplate(series.fileTemplate); });
    }
    else if (key == "firsttimestep")
    {
      series.first = readCount(0);
    }
    else if (key == "numtimesteps")
    {
      series.count = readCount(1);
    }
    else if (key != "type" && key != "version" && key != "NEK3D")
    {
      // The format of the fields follows from their own headers.
      series.notes.push_back(
        LineOf(file, line) + "'" + key.substr(0, 40) + "' is not known here and was passed over.");
      continue;
    }
    if (!found.insert(key).second)
    {
      throw InvalidData(LineOf(file, line) + key + " occurs twice; remove one.");
    }
  }
  for (const char* key : { "filetemplate", "firsttimestep", "numtimesteps" })
  {
    if (!found.contains(key))
    {
      throw InvalidData(file.name + ": the line '" + key +
        ":' is missing; add it, or name the files of the steps themselves (x0.f00001).");
    }
  }
  return series;
}

//------------------------------------------------------------------------------

Series::Series(const std::vector<std::string>& files)
{
  if (IsSeriesName(files.front()))
  {
    if (files.size() > 1)
    {
      throw InvalidData(
        files.front() + ": it lists the files of its steps; leave out " + files[1] + ".");
    }
    AddListed(files.front());
  }
  else
  {
    AddFiles(files);
  }
  std::ranges::transform(
    Steps, std::back_inserter(TimeOf), [](const Step& step) { return step.header.time; });
  if (std::ranges::adjacent_find(TimeOf, std::greater_equal()) != TimeOf.end())
  {
    Noted.push_back(
      files.front() + ": the times of its steps do not ascend; numbers from 0 stand for them.");
    for (std::size_t i = 0; i < TimeOf.size(); ++i)
    {
      TimeOf[i] = static_cast<double>(i);
    }
  }
}

void Series::AddListed(const std::string& file)
{
  const std::string text = ReadFileText(file);
  const SeriesFile series = ParseSeriesFile({ file, text });
  Noted = series.notes;
  for (std::int64_t i = 0; i < series.count; ++i)
  {
    const PartNames names = series.NamesOf(file, series.first + i);
    const std::string first = names.Of(0);
    if (!IsFile(first))
    {
      RefuseMissing(first, i, series.count, file);
    }
    Steps.push_back({ names, first, ReadHeader(first) });
  }
}

void Series::AddFiles(const std::vector<std::string>& files)
{
  std::set<std::string> known;
  for (const std::string& file : files)
  {
    const Header header = ReadHeader(file);
    const PartNames names = NamesFromOne(file, header);
    // Parts of one step have the name of its first part.
    if (known.insert(names.Of(0)).second)
    {
      Steps.push_back({ names, file, header });
    }
  }
  std::ranges::stable_sort(Steps, {}, [](const Step& step) { return step.header.time; });
}

std::vector<std::string> Series::FilesOf(int step) const
{
  const auto& [names, file, header] = Steps.at(static_cast<std::size_t>(step));
  if (header.parts == 1)
  {
    return { file };
  }
  if (!names.HasNumber())
  {
    throw InvalidData(file + ": it is one of " + std::to_string(header.parts) +
      " parts of a step, but the filetemplate has one number; give the part's number before the "
      "step's (x%02d.f%05d).");
  }
  std::vector<std::string> files;
  for (std::int64_t part = 0; part < header.parts; ++part)
  {
    files.push_back(names.Of(part));
    if (!IsFile(files.back()))
    {
      throw InvalidData(files.back() + " is missing: the step of " + file + " has " +
        Counted(header.parts, "part") + "; have all of them in place.");
    }
  }
  return files;
}

std::vector<std::string> Series::FieldNames() const
{
  std::vector<std::string> names;
  for (const Step& step : Steps)
  {
    for (const HeaderField& field : step.header.Fields())
    {
      if (field.isRead && std::ranges::find(names, field.name) == names.end())
      {
        names.push_back(field.name);
      }
    }
  }
  return names;
}

int Series::StepOfMesh(int step) const
{
  const auto own = Steps.begin() + step;
  const auto hasMesh = [](const Step& s) { return s.header.hasMesh; };
  const auto before = std::find_if(std::make_reverse_iterator(own + 1), Steps.rend(), hasMesh);
  const auto found =
    before != Steps.rend() ? before.base() - 1 : std::find_if(own, Steps.end(), hasMesh);
  if (found == Steps.end())
  {
    throw InvalidData(own->file +
      ": neither this file nor those of other steps have a mesh (X in the header's fields); name "
      "the run's first file before it, or an x.nek5000 that lists all.");
  }
  if (found->header.elementsOfAll != own->header.elementsOfAll ||
    found->header.Dimension() != own->header.Dimension())
  {
    throw InvalidData(own->file + ": it has " + Counted(own->header.elementsOfAll, "element") +
      " in " + std::to_string(own->header.Dimension()) + "-D and no mesh, but the mesh in " +
      found->file + " has " + std::to_string(found->header.elementsOfAll) + " in " +
      std::to_string(found->header.Dimension()) +
      "-D; write the mesh with each step, or name the files of one run.");
  }
  return static_cast<int>(found - Steps.begin());
}
} // namespace pixelexact::nek5000
