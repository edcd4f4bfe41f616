// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Files/Document.h"

#include "Core/Base/Error.h"
#include "Core/Base/ParseWhole.h"
#include "Formats/Hdf5/Hdf5File.h"
#include "Formats/Nektar/Files/Hdf5Xml.h"
#include "Formats/Nektar/Files/XmlBlocks.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <span>
#include <string_view>

namespace pixelexact::nektar
{
namespace
{
/// A text that breaks the rules of XML, corrected to the XML that Nektar++'s own parser (TinyXML)
/// reads.
struct RepairedXml
{
  std::string text;                 ///< XML with the same number of lines
  std::vector<std::string> repairs; ///< one sentence each, with the line; never empty
};

constexpr auto kNone = std::string_view::npos;
constexpr std::size_t kMaxShown = 60;

/// Markup that is copied unchanged, and its end.
struct Mark
{
  std::string_view begin;
  std::string_view end;
};
constexpr std::array kMarks{ Mark{ "<!--", "-->" }, Mark{ "<![CDATA[", "]]>" },
  Mark{ "<!DOCTYPE", ">" }, Mark{ "<?", "?>" } };

bool IsLetter(char c)
{
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_' ||
    static_cast<unsigned char>(c) >= 0x80;
}

bool IsBlank(char c)
{
  return kBlanks.find(c) != kNone;
}

class Repairer
{
public:
  explicit Repairer(std::string_view text)
    : Text(text)
  {
  }

  std::optional<RepairedXml> Repair()
  {
    bool isSound = true;
    while (isSound && At < Text.size())
    {
      const std::size_t tag = std::min(Text.find('<', At), Text.size());
      Copy(tag);
      isSound = At == Text.size() || Tag();
    }
    if (!isSound || !CloseUpTo({}) || Result.repairs.empty())
    {
      return std::nullopt;
    }
    return std::move(Result);
  }

private:
  /// An element whose end tag has not been read yet.
  struct Open
  {
    std::string_view name;
    std::size_t empty = kNone;    ///< where <name/> begins within it in the result
    std::size_t emptyEnd = 0;     ///< after its '>'
    std::string_view emptyText{}; ///< the same in the text
  };

  void Copy(std::size_t end)
  {
    Result.text.append(Text, At, end - At);
    At = end;
  }

  void Note(std::string_view what, const std::string& problem)
  {
    const auto line = 1 + std::count(Text.begin(), what.begin(), '\n');
    Result.repairs.push_back("line " + std::to_string(line) + ": '" +
      std::string(what.substr(0, std::min(kMaxShown, what.find_first_of("\r\n")))) + "' " +
      problem);
  }

  /// Copies or repairs markup, which begins with '<'. Returns false where it is never closed or
  /// does not match.
  bool Tag()
  {
    const std::string_view rest = Text.substr(At);
    for (const Mark& mark : kMarks)
    {
      if (rest.starts_with(mark.begin))
      {
        const std::size_t end = rest.find(mark.end, mark.begin.size());
        Copy(end == kNone ? Text.size() : At + end + mark.end.size());
        return end != kNone;
      }
    }
    if (rest.starts_with("</"))
    {
      return EndTag();
    }
    return rest.size() > 1 && IsLetter(rest[1]) ? Element() : UnknownTag();
  }

  bool UnknownTag()
  {
    const std::size_t end = Text.find('>', At);
    if (end == kNone)
    {
      return false;
    }
    const std::string_view tag = Text.substr(At, end + 1 - At);
    Note(tag, "is no element and is passed over, as by Nektar++.");
    Result.text.append(static_cast<std::size_t>(std::ranges::count(tag, '\n')), '\n');
    At = end + 1;
    return true;
  }

  std::string_view NameAt(std::size_t at) const
  {
    const std::size_t end = std::min(Text.find_first_of(" \t\r\n/>=<", at), Text.size());
    return Text.substr(at, end - at);
  }

  bool EndTag()
  {
    const std::string_view name = NameAt(At + 2);
    const std::size_t end = Text.find('>', At);
    if (end == kNone || !CloseUpTo(name) || Path.empty())
    {
      return false;
    }
    Path.pop_back();
    const std::string_view tag = Text.substr(At, end + 1 - At);
    Copy(At + 2 + name.size());
    const std::string_view more = Text.substr(At, end - At);
    if (more.find_first_not_of(kBlanks) != kNone)
    {
      Note(tag, "has more than its name, which is passed over.");
      Result.text.append(static_cast<std::size_t>(std::ranges::count(more, '\n')), '\n');
      At = end;
    }
    Copy(end + 1);
    return true;
  }

  /// Ends elements at the <name/> in them until the innermost has this name, or none is left.
  bool CloseUpTo(std::string_view name)
  {
    while (!Path.empty() && Path.back().name != name)
    {
      const Open& open = Path.back();
      if (open.empty == kNone)
      {
        return false;
      }
      // "<name/>" and "</name>" have the same length.
      std::string& text = Result.text;
      const std::size_t slash = text.rfind('/', open.emptyEnd - 1);
      text.erase(slash, 1);
      text.insert(open.empty + 1, 1, '/');
      Note(open.emptyText, "is read as the end of the element, which has no other.");
      Path.pop_back();
    }
    return true;
  }

  bool Element()
  {
    const std::size_t begin = At;
    const std::size_t written = Result.text.size();
    const std::string_view name = NameAt(At + 1);
    Copy(At + 1 + name.size());
    bool hasAttributes = false;
    while (At < Text.size() && Text[At] != '>' && !Text.substr(At).starts_with("/>"))
    {
      hasAttributes = hasAttributes || !IsBlank(Text[At]);
      if (!Attribute())
      {
        return false;
      }
    }
    if (At == Text.size())
    {
      return false;
    }
    const bool isEmpty = Text[At] == '/';
    Copy(At + (isEmpty ? 2 : 1));
    if (!isEmpty)
    {
      Path.push_back({ name });
    }
    else if (!hasAttributes && !Path.empty() && Path.back().name == name)
    {
      Path.back() = { name, written, Result.text.size(), Text.substr(begin, At - begin) };
    }
    return true;
  }

  /// Copies a blank, or a name with a value.
  bool Attribute()
  {
    if (IsBlank(Text[At]))
    {
      Copy(std::min(Text.find_first_not_of(kBlanks, At), Text.size()));
      return true;
    }
    const std::size_t begin = At;
    const std::size_t equals = Text.find_first_not_of(kBlanks, At + NameAt(At).size());
    if (equals == kNone || Text[equals] != '=')
    {
      return false;
    }
    const std::size_t value = Text.find_first_not_of(kBlanks, equals + 1);
    if (value == kNone || Text[value] == '<' || Text[value] == '>' || Text[value] == '/')
    {
      return false;
    }
    Copy(value);
    const char quote = Text[value];
    if (quote == '"' || quote == '\'')
    {
      const std::size_t end = Text.find(quote, value + 1);
      Copy(end == kNone ? Text.size() : end + 1);
      return end != kNone;
    }
    const std::size_t end = std::min(Text.find_first_of(" \t\r\n/>", value), Text.size());
    Result.text += '"';
    Copy(end);
    Result.text += '"';
    Note(Text.substr(begin, end - begin), "has no quotation marks, and is read as if it had them.");
    return Text.substr(value, end - value).find_first_of("\"'<") == kNone;
  }

  std::string_view Text;
  std::size_t At = 0;
  std::vector<Open> Path;
  RepairedXml Result;
};

/// Repairs errors that TinyXML tolerates, and wrong end tags in Nektar++'s own sessions:
/// - "<" before anything but a letter, '_', '/', '?', "!--", "![CDATA[" and "!DOCTYPE" begins a tag
///   without meaning, which ends at the first '>' (<!N VAR="u"/>, <--!I PROPERTY="x"/-->);
/// - an attribute's value without quotation marks ends at a blank, '/' or '>' (<P A=1/>);
/// - an end tag ends its element whatever follows its name (</F NAME="f">);
/// - <A/> within A, where the end tag of A is missing, is that end tag (<A>text<A/>).
/// Returns none where the text has no such error, or where its tags still do not match. The text's
/// encoding has one byte for each of XML's marks, such as UTF-8.
std::optional<RepairedXml> RepairXml(std::string_view text)
{
  return Repairer(text).Repair();
}

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

/// Reports errors by their line. Offsets are those of pugixml: characters after conversion.
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
