// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Document.h"

#include "Core/Base/Error.h"
#include "Formats/Nektar/Compressed.h"

#include <algorithm>
#include <charconv>

namespace pixelexact::nektar
{
namespace
{
constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::size_t kExpansion = 1032;
constexpr std::string_view kHdf5 = "\x89HDF\r\n";

/// Takes a number off the beginning of the text; false where there is none.
template <class T>
bool Take(std::string_view& text, T& value)
{
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  if (text.starts_with('+'))
  {
    text.remove_prefix(1);
  }
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc())
  {
    return false;
  }
  text.remove_prefix(end - text.data());
  return true;
}
} // namespace

std::string_view Trim(std::string_view text)
{
  const auto begin = text.find_first_not_of(kBlanks);
  return begin == std::string_view::npos
    ? std::string_view()
    : text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

Document::Document(const NamedText& file)
  : FileName(file.name)
  , MostExpanded(kExpansion * (file.text.size() + 1))
{
  if (file.text.starts_with(kHdf5))
  {
    throw Unsupported(FileName +
      ": this is an HDF5 file, which is not read; convert it to XML "
      "(FieldConvert or NekMesh with the option for XML output).");
  }
  const auto result =
    Xml.load_buffer(file.text.data(), file.text.size(), pugi::parse_default | pugi::parse_doctype);
  if (!result)
  {
    const std::size_t at = std::min(static_cast<std::size_t>(result.offset), file.text.size());
    const auto line = 1 + std::count(file.text.begin(), file.text.begin() + at, '\n');
    throw InvalidData(FileName + ", line " + std::to_string(line) + ": this is no XML (" +
      result.description() + "); the file is damaged or cut short.");
  }
  for (const auto& child : Xml.children())
  {
    if (child.type() == pugi::node_doctype)
    {
      throw InvalidData(FileName +
        ": a document type (DOCTYPE) has no place in a Nektar++ file; "
        "remove it.");
    }
  }
  if (!Root())
  {
    throw InvalidData(FileName + ": there is no element NEKTAR; this is no Nektar++ file.");
  }
}

std::string Document::Place(const pugi::xml_node& node) const
{
  const char* id = node.attribute("ID").value();
  return FileName + ", <" + node.name() +
    (*id != '\0' ? " ID=\"" + std::string(id).substr(0, 40) + "\">" : ">");
}

void Document::Fail(const pugi::xml_node& node, const std::string& problem) const
{
  throw InvalidData(Place(node) + ": " + problem);
}

void Document::FailUnsupported(const pugi::xml_node& node, const std::string& problem) const
{
  throw Unsupported(Place(node) + ": " + problem);
}

bool Document::IsCompressed(const pugi::xml_node& node) const
{
  const std::string_view form = node.attribute("COMPRESSED").value();
  if (form.empty())
  {
    return false;
  }
  if (form != "B64Z-LittleEndian" || std::string_view(node.attribute("BITSIZE").value()) != "64")
  {
    FailUnsupported(node,
      "data in the form '" + std::string(form.substr(0, 40)) +
        "' are not read; only B64Z-LittleEndian of 64 bits is.");
  }
  return true;
}

std::vector<std::byte> Document::Bytes(const pugi::xml_node& node, std::size_t most) const
{
  return Decompress(node.child_value(), std::min(most, MostExpanded), Place(node));
}

std::vector<std::int64_t> Document::Integers(const pugi::xml_node& node, std::size_t count) const
{
  std::string_view text = node.child_value();
  std::vector<std::int64_t> numbers;
  std::int64_t value = 0;
  while (numbers.size() <= count && Take(text, value))
  {
    numbers.push_back(value);
  }
  if (numbers.size() != count || !Trim(text).empty())
  {
    Fail(node, "there should be " + std::to_string(count) + " whole numbers and nothing else.");
  }
  return numbers;
}

std::vector<double> Document::Numbers(const pugi::xml_node& node) const
{
  std::string_view text = node.child_value();
  std::vector<double> numbers;
  double value = 0.0;
  while (Take(text, value))
  {
    numbers.push_back(value);
  }
  if (!Trim(text).empty())
  {
    Fail(node, "'" + std::string(Trim(text).substr(0, 20)) + "' is no number.");
  }
  return numbers;
}

std::int64_t Document::Id(const pugi::xml_node& node, const char* attribute) const
{
  const std::string_view text = Trim(node.attribute(attribute).value());
  std::int64_t value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 0)
  {
    Fail(node,
      std::string("the attribute ") + attribute + "=\"" + std::string(text.substr(0, 20)) +
        "\" should be a number that is not negative.");
  }
  return value;
}

std::vector<std::int64_t> Document::List(
  const pugi::xml_node& node, std::string_view text, std::size_t most) const
{
  std::vector<std::int64_t> numbers;
  text = Trim(text);
  while (!text.empty())
  {
    std::int64_t first = 0;
    bool sound = Take(text, first) && first >= 0;
    std::int64_t last = first;
    text = Trim(text);
    if (sound && text.starts_with('-'))
    {
      text.remove_prefix(1);
      sound = Take(text, last) && last >= first;
      text = Trim(text);
    }
    if (!sound || !(text.empty() || text.starts_with(',')))
    {
      Fail(node,
        "the list of numbers cannot be read at '" + std::string(text.substr(0, 20)) +
          "'; it should be like 0-65,70.");
    }
    text.remove_prefix(text.empty() ? 0 : 1);
    if (static_cast<std::uint64_t>(last - first) >= most - std::min(most, numbers.size()))
    {
      Fail(node, "the list names more than the " + std::to_string(most) + " that there are.");
    }
    for (std::int64_t n = first; n <= last; ++n)
    {
      numbers.push_back(n);
    }
  }
  return numbers;
}
} // namespace pixelexact::nektar
