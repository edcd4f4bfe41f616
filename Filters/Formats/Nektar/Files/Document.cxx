// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Files/Document.h"

#include "Core/Base/Error.h"
#include "Core/Base/ParseWhole.h"
#include "Formats/FileText.h"
#include "Formats/Nektar/Files/XmlBlocks.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace pixelexact::nektar
{
namespace
{
constexpr std::size_t kExpansion = 1032;

/// Takes a number from the beginning of the text; false where there is none.
template <class T>
bool Take(std::string_view& text, T& value)
{
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  if (text.starts_with('+') && !text.starts_with("+-"))
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

/// Takes a number that ends at a blank or with the text.
template <class T>
bool TakeWord(std::string_view& text, T& value)
{
  std::string_view rest = text;
  if (!Take(rest, value) || !(rest.empty() || kBlanks.find(rest.front()) != kBlanks.npos))
  {
    return false;
  }
  text = rest;
  return true;
}

bool SameLetters(std::string_view a, std::string_view b)
{
  const auto lower = [](unsigned char c) { return std::tolower(c); };
  return std::ranges::equal(a, b, {}, lower, lower);
}
} // namespace

Document::Document(const NamedText& file)
  : FileName(file.name)
  , File(file.file)
  , MostExpanded(kExpansion * (file.text.size() + 1))
{
  Blocks = LoadXml(file, Xml, RepairNotes);
  if (!Root())
  {
    throw InvalidData(FileName + ": there is no element NEKTAR; this is no Nektar++ file.");
  }
}

Document::~Document()
{
  Xml.reset();
  if (File != nullptr)
  {
    try
    {
      File->Forget(0, File->Get().size());
    }
    catch (const InvalidData&)
    {
      // The file was truncated after it was read, which does no harm.
    }
  }
}

pugi::xml_node Document::Only(const pugi::xml_node& parent, const char* tag) const
{
  const pugi::xml_node child = parent.child(tag);
  if (const pugi::xml_node second = child.next_sibling(tag))
  {
    Fail(second, "there is a second element of this kind; write both as one, or remove it.");
  }
  return child;
}

std::string Document::Text(const pugi::xml_node& node)
{
  std::string text;
  for (const auto& child : node.children())
  {
    if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata)
    {
      text += text.empty() ? "" : " ";
      text += child.value();
    }
  }
  return text;
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
  const std::string_view bits = node.attribute("BITSIZE").as_string("64");
  if (form.empty())
  {
    return false;
  }
  if (!SameLetters(form, "B64Z-LittleEndian") || WithoutBlanks(bits) != "64")
  {
    FailUnsupported(node,
      "data in the form '" + std::string(form.substr(0, 40)) + "' of " +
        std::string(bits.substr(0, 20)) +
        " bits are not read; only B64Z-LittleEndian of 64 bits is.");
  }
  return true;
}

bool Document::IsCompressedField(const pugi::xml_node& node) const
{
  // Nektar++ has no other fields, and up to 4.0 it wrote no attribute. Base64 of a zlib stream
  // begins with a letter, a number does not.
  const std::string_view text = WithoutBlanks(node.child_value());
  return IsCompressed(node) ||
    (!text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) != 0);
}

std::string_view Document::TextView(const pugi::xml_node& node, std::string& joined) const
{
  const pugi::xml_node only = node.first_child();
  if (only && !only.next_sibling() &&
    (only.type() == pugi::node_pcdata || only.type() == pugi::node_cdata))
  {
    const auto block = BlockAt(only.value());
    return block && *block < Blocks.size() ? Blocks[*block] : std::string_view(only.value());
  }
  joined = Text(node);
  return joined;
}

std::vector<std::int64_t> Document::Integers(const pugi::xml_node& node, std::size_t count) const
{
  const std::string whole = Text(node);
  std::string_view text = whole;
  std::vector<std::int64_t> numbers;
  std::int64_t value = 0;
  while (numbers.size() <= count && TakeWord(text, value))
  {
    numbers.push_back(value);
  }
  if (numbers.size() != count || !WithoutBlanks(text).empty())
  {
    Fail(node, "there should be " + std::to_string(count) + " whole numbers and nothing else.");
  }
  return numbers;
}

std::vector<double> Document::Numbers(const pugi::xml_node& node) const
{
  const std::string whole = Text(node);
  std::string_view text = whole;
  std::vector<double> numbers;
  double value = 0.0;
  while (TakeWord(text, value))
  {
    numbers.push_back(value);
  }
  if (!WithoutBlanks(text).empty())
  {
    Fail(node, "'" + std::string(WithoutBlanks(text).substr(0, 20)) + "' is no number.");
  }
  return numbers;
}

std::int64_t Document::Id(const pugi::xml_node& node, const char* attribute) const
{
  const std::string_view text = WithoutBlanks(node.attribute(attribute).value());
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
  text = WithoutBlanks(text);
  while (!text.empty())
  {
    std::int64_t first = 0;
    bool sound = Take(text, first) && first >= 0;
    std::int64_t last = first;
    text = WithoutBlanks(text);
    if (sound && text.starts_with('-'))
    {
      text.remove_prefix(1);
      sound = Take(text, last) && last >= first;
      text = WithoutBlanks(text);
    }
    const bool more = text.starts_with(',');
    if (!sound || !(text.empty() || (more && text.size() > 1)))
    {
      Fail(node,
        "the list of numbers cannot be read at '" + std::string(text.substr(0, 20)) +
          "'; it should be like 0-65,70.");
    }
    text.remove_prefix(more ? 1 : 0);
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
