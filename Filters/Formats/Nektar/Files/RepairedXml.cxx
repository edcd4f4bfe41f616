// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Files/RepairedXml.h"

#include "Core/Base/ParseWhole.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace pixelexact::nektar
{
namespace
{
constexpr auto kNone = std::string_view::npos;
constexpr std::size_t kMostShown = 60;

/// Marks of XML that are copied as they stand, and what ends them.
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
  /// An element whose end tag has not come yet.
  struct Open
  {
    std::string_view name;
    std::size_t empty = kNone;    ///< where <name/> begins within it in the result
    std::size_t emptyEnd = 0;     ///< behind its '>'
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
      std::string(what.substr(0, std::min(kMostShown, what.find_first_of("\r\n")))) + "' " +
      problem);
  }

  /// What begins with '<'. False: it is never closed, or does not match.
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

  /// Ends elements by the <name/> in them until the innermost has this name, or none is left.
  bool CloseUpTo(std::string_view name)
  {
    while (!Path.empty() && Path.back().name != name)
    {
      const Open& open = Path.back();
      if (open.empty == kNone)
      {
        return false;
      }
      // "<name/>" and "</name>" are of one length.
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

  /// A blank, or a name with a value.
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
} // namespace

std::optional<RepairedXml> RepairXml(std::string_view text)
{
  return Repairer(text).Repair();
}
} // namespace pixelexact::nektar
