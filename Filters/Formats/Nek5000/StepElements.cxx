// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nek5000/StepElements.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"

#include <algorithm>
#include <cstring>

namespace pixelexact::nek5000
{
namespace
{
template <class Number>
Number Load(const char* bytes, bool isSwapped)
{
  std::array<char, sizeof(Number)> raw{};
  std::copy_n(bytes, raw.size(), raw.begin());
  if (isSwapped)
  {
    std::ranges::reverse(raw);
  }
  Number value{};
  std::memcpy(&value, raw.data(), sizeof(value));
  return value;
}

template <class Number>
void LoadAll(const char* bytes, bool isSwapped, std::span<double> values)
{
  for (double& value : values)
  {
    value = static_cast<double>(Load<Number>(bytes, isSwapped));
    bytes += sizeof(Number);
  }
}

/// Refuses a file whose length is not that of its header's elements and fields.
void CheckLength(const std::string& file, std::size_t length, const Header& header)
{
  // No overflow: at most 2^31 elements of 33^3 nodes with 107 components of 8 bytes.
  const auto elements = static_cast<std::uint64_t>(header.elements);
  const auto components = static_cast<std::uint64_t>(header.Components());
  const std::uint64_t ofElement = sizeof(std::int32_t) +
    components * static_cast<std::uint64_t>(header.NodesOfElement() * header.wordSize);
  const std::uint64_t needed = kHeaderBytes + elements * ofElement;
  // 3-D files end with the least and the largest float of each component in each element.
  const std::uint64_t withRanges = needed + elements * components * 2 * sizeof(float);
  if (length == needed || length == withRanges)
  {
    return;
  }
  throw InvalidData(file + ": the file has " + Counted(length, "byte") + ", but its header " +
    "describes " + Counted(elements, "element") + " of " + std::to_string(needed) + " bytes, or " +
    std::to_string(withRanges) + " with their ranges; " +
    (length < needed ? "the file is cut short" : "the file is damaged") +
    ". Copy or write it again.");
}

/// Refuses a file that does not belong to the first one.
void CheckAlike(const std::string& first, const Header& one, const std::string& file,
  const Header& other, std::size_t part)
{
  if (other.parts != one.parts || static_cast<std::size_t>(other.part) != part)
  {
    throw InvalidData(file + ": it is part " + std::to_string(other.part) + " of " +
      std::to_string(other.parts) + ", but stands in the place of part " + std::to_string(part) +
      " of " + std::to_string(one.parts) + "; restore the files' names.");
  }
  if (other.nodes != one.nodes || other.elementsOfAll != one.elementsOfAll ||
    other.Components() != one.Components() || other.hasMesh != one.hasMesh ||
    other.hasPressure != one.hasPressure || other.hasTemperature != one.hasTemperature ||
    other.time != one.time)
  {
    throw InvalidData(file + ": its orders, fields, time or number of elements are not those of " +
      first + "; have the files of one run in a folder.");
  }
}
} // namespace

StepElements::StepElements(const std::vector<NamedText>& files)
{
  std::int64_t sum = 0;
  for (const NamedText& text : files)
  {
    const Header header = ParseHeader(text.name, text.text.substr(0, kHeaderBytes));
    CheckLength(text.name, text.text.size(), header);
    CheckAlike(
      files.front().name, Files.empty() ? header : GetHeader(), text.name, header, Files.size());
    sum += header.elements;
    Files.push_back({ text, header });
  }
  const Header& header = GetHeader();
  if (Files.size() != static_cast<std::size_t>(header.parts) || sum != header.elementsOfAll)
  {
    throw InvalidData(files.front().name + ": the step has " +
      Counted(header.elementsOfAll, "element") + " in " + Counted(header.parts, "file") +
      ", but there are " + std::to_string(sum) + " in " + std::to_string(Files.size()) +
      "; have all files of the step in place.");
  }
  Places.resize(static_cast<std::size_t>(sum));
  for (std::size_t file = 0; file < Files.size(); ++file)
  {
    AddElements(file);
  }
}

void StepElements::AddElements(std::size_t file)
{
  const auto& [text, header] = Files[file];
  for (std::int32_t e = 0; e < header.elements; ++e)
  {
    const char* bytes = text.text.data() + kHeaderBytes + sizeof(e) * static_cast<std::size_t>(e);
    const auto number = Load<std::int32_t>(bytes, header.isSwapped);
    if (number < 1 || number > header.elementsOfAll)
    {
      throw InvalidData(text.name + ": an element has the number " + std::to_string(number) +
        ", but the mesh has the elements 1 to " + std::to_string(header.elementsOfAll) +
        ", so another one is missing; write the file again.");
    }
    Place& place = Places[static_cast<std::size_t>(number) - 1];
    if (place.file >= 0)
    {
      throw InvalidData(text.name + ": element " + std::to_string(number) +
        " occurs twice, so another one is missing; write the file again.");
    }
    place = { static_cast<std::int32_t>(file), e };
  }
}

bool StepElements::IsSingle() const
{
  return std::ranges::any_of(Files, [](const File& file) { return file.header.wordSize == 4; });
}

std::string StepElements::Describe(std::size_t element) const
{
  return Files[static_cast<std::size_t>(Places[element].file)].text.name + ": element " +
    std::to_string(element + 1);
}

void StepElements::Gather(const Block& block, std::size_t element, std::span<double> values) const
{
  const Place& place = Places[element];
  const auto& [text, header] = Files[static_cast<std::size_t>(place.file)];
  const auto nodes = static_cast<std::size_t>(header.NodesOfElement());
  const auto elements = static_cast<std::size_t>(header.elements);
  const std::size_t first = nodes *
    (elements * static_cast<std::size_t>(block.before) +
      static_cast<std::size_t>(place.element) * static_cast<std::size_t>(block.components));
  const char* bytes = text.text.data() + kHeaderBytes + sizeof(std::int32_t) * elements +
    first * static_cast<std::size_t>(header.wordSize);
  header.wordSize == 4 ? LoadAll<float>(bytes, header.isSwapped, values)
                       : LoadAll<double>(bytes, header.isSwapped, values);
}

void StepElements::Forget() const
{
  for (const File& file : Files)
  {
    if (file.text.file != nullptr)
    {
      file.text.file->Forget(0, file.text.text.size());
    }
  }
}
} // namespace pixelexact::nek5000
