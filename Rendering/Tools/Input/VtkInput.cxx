// SPDX-License-Identifier: BSD-3-Clause
#include "Input/VtkInput.h"

#include "Base/Command.h"
#include "Base/Processes.h"
#include "Base/VtkMessages.h"

#include "Files/GridParts.h"
#include "Files/TimeSeries.h"
#include "HighOrderArrays.h"

#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <utility>

namespace pixelexact
{
namespace
{
using Files = std::vector<std::string>;

/// Throws Error for what VTK could not do; what it warns of becomes notes.
void CheckMessages(
  const VtkMessages& messages, const std::string& file, std::vector<std::string>& notes)
{
  for (const std::string& failure : { messages.FirstError(), messages.FirstGenericWarning() })
  {
    if (!failure.empty())
    {
      CannotRead(file, failure);
    }
  }
  for (const std::string& warning : messages.Warnings())
  {
    notes.emplace_back("'").append(file).append("': ").append(warning).append(".");
  }
}

InputGrid ReadStep(
  const InputRequest& request, const std::vector<TimeStep>& steps, std::vector<double> times)
{
  InputGrid input;
  input.times = std::move(times);
  input.step = ChooseStep(request, input.times);
  if (request.timesAlone)
  {
    return input;
  }
  const VtkMessages messages;
  ReadGrid read = ReadParts(steps[static_cast<std::size_t>(input.step)].parts, PartOfThisProcess(),
    request.surfaceElements);
  if (request.surfaceElements && HasHighOrderArrays(read.grid))
  {
    CannotRead(request.files[0],
      "it holds coefficients of its elements, which are of one kind; leave out --surface-elements");
  }
  input.grid = read.grid;
  input.notes = std::move(read.notes);
  CheckMessages(messages, request.files[0], input.notes);
  return input;
}

std::vector<double> Times(const std::vector<TimeStep>& steps)
{
  std::vector<double> times;
  std::ranges::transform(steps, std::back_inserter(times), &TimeStep::time);
  return times;
}

bool IsDigit(char c)
{
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// A name cut at a number: where that begins and ends.
struct Number
{
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The number in which two names differ while the text before and after it is the same.
Number Differing(const std::string& a, const std::string& b)
{
  std::size_t begin = 0;
  while (begin < std::min(a.size(), b.size()) && a[begin] == b[begin])
  {
    ++begin;
  }
  while (begin > 0 && IsDigit(a[begin - 1]))
  {
    --begin;
  }
  std::size_t end = begin;
  while (end < a.size() && IsDigit(a[end]))
  {
    ++end;
  }
  return { begin, end };
}

/// The number in a name at the place that `number` has in `model`; empty where the names differ
/// elsewhere.
std::string NumberIn(const std::string& name, const std::string& model, const Number& number)
{
  const std::string before = model.substr(0, number.begin);
  const std::string behind = model.substr(number.end);
  if (name.size() <= before.size() + behind.size() || !name.starts_with(before) ||
    !name.ends_with(behind))
  {
    return {};
  }
  const std::string digits =
    name.substr(before.size(), name.size() - before.size() - behind.size());
  return std::ranges::all_of(digits, IsDigit) ? digits : std::string();
}

/// The files by their numbers. UsageError where their names differ in more than one number.
Files SortSeries(const Files& files)
{
  const Number number = Differing(files[0], files[1]);
  using Numbered = std::pair<std::string, std::string>;
  std::vector<Numbered> numbered;
  for (const std::string& file : files)
  {
    std::string digits = NumberIn(file, files[0], number);
    if (digits.empty())
    {
      // Names without a number where they differ are none of a series, the first one neither.
      throw UsageError("'" + files[0] + "' holds mesh and fields, and '" +
        (file == files[0] ? files[1] : file) +
        "' is no other time step of it, which would differ in one number; name one file alone");
    }
    digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
    numbered.emplace_back(std::move(digits), file);
  }
  std::ranges::stable_sort(numbered,
    [](const Numbered& a, const Numbered& b)
    {
      return std::pair(a.first.size(), std::string_view(a.first)) <
        std::pair(b.first.size(), std::string_view(b.first));
    });
  Files sorted;
  std::ranges::transform(numbered, std::back_inserter(sorted), &Numbered::second);
  return sorted;
}

} // namespace

InputGrid ReadXmlFiles(const InputRequest& request)
{
  if (request.files.size() == 1)
  {
    return ReadStep(request, NumberFiles(request.files), {});
  }
  const auto steps = NumberFiles(SortSeries(request.files));
  return ReadStep(request, steps, Times(steps));
}

InputGrid ReadXmlCollection(const InputRequest& request)
{
  CheckAlone(request.files);
  const auto steps = ReadCollection(request.files[0]);
  return ReadStep(request, steps, Times(steps));
}

InputGrid ReadVtkHdfFiles(const InputRequest& request)
{
  const auto steps =
    ListHdfSteps(request.files.size() == 1 ? request.files : SortSeries(request.files));
  const bool hasTimes = request.files.size() > 1 || steps.front().isTimed;
  return ReadStep(request, steps, hasTimes ? Times(steps) : std::vector<double>());
}

InputGrid ReadLegacyFile(const InputRequest& request)
{
  CheckAlone(request.files);
  return ReadXmlFiles(request);
}
} // namespace pixelexact
