// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/FileText.h"
#include "Formats/Nek5000/Header.h"

#include <cstdint>
#include <string>
#include <vector>

// The files of a run of Nek5000, nekRS or neko: one or several for each of its steps.
namespace pixelexact::nek5000
{
/// Whether a file's name ends as that of a step: ".f" and five digits or more.
bool IsStepName(const std::string& path);

/// The names of the files of a step, with their part's number in some places.
class PartNames
{
public:
  /// One file.
  explicit PartNames(const std::string& path)
    : Literals{ path }
  {
  }

  [[nodiscard]] std::string Of(std::int64_t part) const;
  [[nodiscard]] bool HasNumber() const { return !Digits.empty(); }

  /// Continues the names with a number of at least so many digits, and a text after it.
  void Append(int digits, const std::string& literal);

private:
  std::vector<std::string> Literals; ///< one more than there are numbers
  std::vector<int> Digits;
};

/// The contents of a file "x.nek5000".
struct SeriesFile
{
  std::string fileTemplate; ///< "x%01d.f%05d": numbers of the part, then the step's number
  std::int64_t first = 0;
  std::int64_t count = 1;
  std::vector<std::string> notes;

  /// The names of a step's files beside `path`.
  [[nodiscard]] PartNames NamesOf(const std::string& path, std::int64_t step) const;
};

/// Parses such a file. Throws InvalidData: "<file>, line <n>: what; remedy".
SeriesFile ParseSeriesFile(const NamedText& file);

/// The steps of a run. Reads the headers of all steps at construction.
class Series
{
public:
  /// `files`: one "x.nek5000", or files of steps, which are ordered by their times. One file of a
  /// step represents all its parts. Throws InvalidData or Unsupported, with the name of a file that
  /// is missing or damaged.
  explicit Series(const std::vector<std::string>& files);

  /// The times of the steps, ascending; the steps' numbers where times do not ascend.
  [[nodiscard]] const std::vector<double>& Times() const { return TimeOf; }
  [[nodiscard]] const std::vector<std::string>& Notes() const { return Noted; }

  /// The fields that any step has and that are read.
  [[nodiscard]] std::vector<std::string> FieldNames() const;

  /// The files of all parts of a step, counted from 0. Throws InvalidData, with the name of a
  /// missing file.
  [[nodiscard]] std::vector<std::string> FilesOf(int step) const;

  /// The step whose mesh a step has: its own, else that of the last one before it with a mesh, else
  /// of the first one after it. Throws InvalidData where no step has one, or that mesh has other
  /// elements.
  [[nodiscard]] int StepOfMesh(int step) const;

private:
  struct Step
  {
    PartNames names;
    std::string file; ///< of one part
    Header header;    ///< of that file
  };

  void AddListed(const std::string& file);
  void AddFiles(const std::vector<std::string>& files);

  std::vector<Step> Steps;
  std::vector<double> TimeOf;
  std::vector<std::string> Noted;
};
} // namespace pixelexact::nek5000
