// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Files/XmlFile.h"

#include "Core/Base/Error.h"
#include "Formats/FileText.h"
#include "Formats/Hdf5/Hdf5File.h"
#include "Formats/Nektar/Files/Hdf5Xml.h"
#include "Formats/Nektar/Files/LongBlocks.h"
#include "Formats/Nektar/Files/RepairedXml.h"

#include <algorithm>
#include <span>

namespace pixelexact::nektar
{
namespace
{
std::ptrdiff_t UnitSize(pugi::xml_encoding encoding)
{
  switch (encoding)
  {
    case pugi::encoding_utf16_le:
    case pugi::encoding_utf16_be:
      return 2;
    case pugi::encoding_utf32_le:
    case pugi::encoding_utf32_be:
      return 4;
    default:
      return 1;
  }
}

/// Tells of what is wrong by its line. Offsets are those of pugixml: characters after conversion.
class Checker : public pugi::xml_tree_walker
{
public:
  Checker(const NamedText& file, pugi::xml_encoding encoding)
    : File(file)
    , Unit(UnitSize(encoding))
  {
  }

  [[noreturn]] void Fail(std::ptrdiff_t offset, const std::string& problem) const
  {
    const auto size = static_cast<std::ptrdiff_t>(File.text.size());
    const auto at = std::clamp(offset, std::ptrdiff_t{ 0 }, size / Unit) * Unit;
    const auto line = 1 + std::count(File.text.begin(), File.text.begin() + at, '\n');
    throw InvalidData(File.name + ", line " + std::to_string(line) + ": " + problem);
  }

  void CheckZeros() const
  {
    const auto zero = File.text.find('\0');
    if (Unit == 1 && zero != std::string_view::npos)
    {
      Fail(static_cast<std::ptrdiff_t>(zero),
        "there is a zero byte, which ends XML; the file is damaged.");
    }
  }

  bool for_each(pugi::xml_node& node) override
  {
    const auto type = node.type();
    if (type == pugi::node_doctype && std::string_view(node.value()).find('[') != kNone)
    {
      Fail(node.offset_debug(),
        "a document type (DOCTYPE) with declarations of its own is not read; remove it.");
    }
    if (depth() == 0 && (type == pugi::node_pcdata || type == pugi::node_cdata))
    {
      Fail(node.offset_debug(),
        "there is text outside of the elements, '" + std::string(node.value()).substr(0, 20) +
          "'; the file is damaged.");
    }
    for (auto a = node.first_attribute(); a; a = a.next_attribute())
    {
      for (auto b = a.next_attribute(); b; b = b.next_attribute())
      {
        if (std::string_view(a.name()) == b.name())
        {
          Fail(node.offset_debug(),
            std::string("<") + node.name() + "> has the attribute " + a.name() +
              " twice; remove one of the two.");
        }
      }
    }
    return true;
  }

private:
  static constexpr auto kNone = std::string_view::npos;

  const NamedText& File;
  std::ptrdiff_t Unit;
};
} // namespace

std::vector<std::string_view> LoadXml(
  const NamedText& file, pugi::xml_document& xml, std::vector<std::string>& notes)
{
  const bool hdf5 = IsHdf5(file.text);
  const std::string converted = hdf5 ? Hdf5AsXml(file) : std::string();
  std::optional<ShortXml> shortened =
    file.file != nullptr && !hdf5 ? WithoutLongBlocks(*file.file) : std::nullopt;
  const NamedText read{ file.name,
    hdf5          ? std::string_view(converted)
      : shortened ? std::string_view(shortened->text)
                  : file.text };
  const std::span<char> own =
    file.file != nullptr && !hdf5 && !shortened ? file.file->Own() : std::span<char>();
  const bool hasZero = read.text.find('\0') != std::string_view::npos;
  constexpr unsigned kOptions = pugi::parse_default | pugi::parse_doctype | pugi::parse_fragment;
  auto result = own.empty() || hasZero
    ? xml.load_buffer(read.text.data(), read.text.size(), kOptions)
    : xml.load_buffer_inplace(own.data(), own.size(), kOptions);
  if (!result && !own.empty())
  {
    file.file->Forget(0, own.size()); // what the parser wrote into it
  }
  std::optional<RepairedXml> repaired =
    !result && !hasZero && UnitSize(result.encoding) == 1 ? RepairXml(read.text) : std::nullopt;
  if (repaired)
  {
    const auto second = xml.load_buffer(repaired->text.data(), repaired->text.size(), kOptions);
    result = second ? second : result;
    for (const std::string& repair : repaired->repairs)
    {
      notes.push_back(file.name + ", " + repair);
    }
  }
  const NamedText parsed{ file.name, result && repaired ? repaired->text : read.text };
  Checker checker(parsed, result.encoding);
  if (!result)
  {
    checker.Fail(result.offset,
      std::string("this is no XML (") + result.description() +
        "); the file is damaged or cut short.");
  }
  if (hasZero)
  {
    checker.CheckZeros();
  }
  xml.traverse(checker);
  return shortened ? std::move(shortened->blocks) : std::vector<std::string_view>();
}
} // namespace pixelexact::nektar
