// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nek5000/Header.h"

#include "Core/Base/Error.h"
#include "Core/Base/ParseWhole.h"
#include "Core/Basis/Space.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <limits>

namespace pixelexact::nek5000
{
namespace
{
constexpr std::size_t kTextBytes = 132;
constexpr std::string_view kMagic = "#std";
constexpr float kByteOrder = 6.54321F;
constexpr const char* kDamaged = "the file is damaged; copy or write it again.";

/// Text that may be anything, for messages.
std::string Quote(std::string_view text)
{
  std::string quoted = "'";
  for (const char c : text.substr(0, 40))
  {
    quoted += std::isprint(static_cast<unsigned char>(c)) != 0 ? c : '?';
  }
  return quoted + "'";
}

/// Reads the header's words one after the other.
class Words
{
public:
  Words(const std::string& file, std::string_view text)
    : File(file)
    , Text(text)
  {
  }

  std::string_view Next()
  {
    const std::size_t begin = std::min(Text.find_first_not_of(kBlanks, At), Text.size());
    At = std::min(Text.find_first_of(kBlanks, begin), Text.size());
    return Text.substr(begin, At - begin);
  }

  std::int64_t Integer(const char* what, std::int64_t low, std::int64_t high)
  {
    const std::string_view word = Next();
    std::int64_t value = 0;
    if (!ParseWhole(word, value) || value < low || value > high)
    {
      throw InvalidData(
        File + ": the header gives " + Quote(word) + " as " + what + "; " + kDamaged);
    }
    return value;
  }

  double Real(const char* what)
  {
    const std::string_view word = Next();
    double value = 0.0;
    if (!ParseWhole(word, value) || !std::isfinite(value))
    {
      throw InvalidData(File + ": the header gives " + Quote(word) + " as " + what +
        ", which is no finite number; " + kDamaged);
    }
    return value;
  }

  [[nodiscard]] std::string_view Rest() const { return Text.substr(At); }

private:
  const std::string& File;
  std::string_view Text;
  std::size_t At = 0;
};

/// Throws for a file that does not begin as a field file of this format.
[[noreturn]] void RefuseMagic(const std::string& file, std::string_view head)
{
  Words words(file, head.substr(0, kTextBytes));
  const std::string_view first = words.Next();
  const bool isOld = [&]
  {
    // Before 2008: elements, nodes in three directions, time.
    std::string_view word = first;
    for (int i = 0; i < 4; ++i, word = words.Next())
    {
      std::int64_t number = 0;
      if (!ParseWhole(word, number))
      {
        return false;
      }
    }
    double time = 0.0;
    return ParseWhole(word, time);
  }();
  if (isOld)
  {
    throw Unsupported(file +
      ": this is a .fld file of Nek5000 before 2008, which is not read; read it with Nek5000 and "
      "write it again with param(66) = 6.");
  }
  if (first.starts_with('#'))
  {
    throw Unsupported(file + ": the header begins with " + Quote(first) +
      "; files that begin with '#std' are read.");
  }
  throw InvalidData(file +
    ": it does not begin with '#std' as a field file of Nek5000, nekRS or neko; it is damaged or "
    "of another format.");
}

/// Reads which fields the file holds, such as "XUPTS03", and what follows.
void ReadFields(const std::string& file, std::string_view text, Header& header)
{
  // Ten letters, of which the first stands behind one blank; a number follows, and T or F.
  constexpr std::size_t kFields = 10;
  const std::string_view fields = text.substr(0, std::min(text.size(), kFields + 1));
  const auto fail = [&](const std::string& what)
  {
    throw Unsupported(file + ": " + what + " in the fields " + Quote(WithoutBlanks(fields)) +
      " that the header lists; X, U, P, T and S with two digits are read, in this order.");
  };
  std::string_view order = "XUPTS";
  for (std::size_t i = 0; i < fields.size(); ++i)
  {
    if (fields[i] == '\0' || kBlanks.find(fields[i]) != std::string_view::npos)
    {
      continue;
    }
    const std::size_t at = order.find(fields[i]);
    if (at == std::string_view::npos)
    {
      fail(std::string("XUPTS").find(fields[i]) == std::string::npos
          ? Quote(fields.substr(i, 1)) + " is not known"
          : Quote(fields.substr(i, 1)) + " is in a place that is not known");
    }
    switch (order[at])
    {
      case 'X':
        header.hasMesh = true;
        break;
      case 'U':
        header.hasVelocity = true;
        break;
      case 'P':
        header.hasPressure = true;
        break;
      case 'T':
        header.hasTemperature = true;
        break;
      default:
        if (i + 2 >= fields.size() || !IsDigit(fields[i + 1]) || !IsDigit(fields[i + 2]))
        {
          fail("S stands without two digits");
        }
        header.scalars = 10 * (fields[i + 1] - '0') + (fields[i + 2] - '0');
        i += 2;
    }
    order.remove_prefix(at + 1);
  }
  Words words(file, text.substr(fields.size()));
  words.Next(); // the thermodynamic pressure
  header.isPressureElsewhere = header.hasPressure && words.Next() == "T";
}

bool IsSwapped(const std::string& file, std::string_view bytes)
{
  std::array<char, sizeof(float)> raw{};
  std::ranges::copy(bytes, raw.begin());
  for (const bool swapped : { false, true })
  {
    float value = 0.0F;
    std::memcpy(&value, raw.data(), sizeof(value));
    if (std::fabs(value - kByteOrder) < 1e-5F)
    {
      return swapped;
    }
    std::ranges::reverse(raw);
  }
  throw InvalidData(file +
    ": 6.54321 does not follow the header in either byte order; copy the file again, as binary.");
}
} // namespace

int Header::Components() const
{
  const int ofVectors = ((hasMesh ? 1 : 0) + (hasVelocity ? 1 : 0)) * Dimension();
  return ofVectors + (hasPressure ? 1 : 0) + (hasTemperature ? 1 : 0) + scalars;
}

std::vector<HeaderField> Header::Fields() const
{
  std::vector<HeaderField> fields;
  if (hasVelocity)
  {
    fields.push_back({ "velocity", Dimension() });
  }
  if (hasPressure)
  {
    fields.push_back({ "pressure", 1, !isPressureElsewhere });
  }
  if (hasTemperature)
  {
    fields.push_back({ "temperature" });
  }
  for (int s = 1; s <= scalars; ++s)
  {
    fields.push_back({ "s" + std::to_string(s) });
  }
  return fields;
}

Header ParseHeader(const std::string& file, std::string_view head)
{
  if (!head.starts_with(kMagic))
  {
    RefuseMagic(file, head);
  }
  if (head.size() < kHeaderBytes)
  {
    throw InvalidData(file + ": it ends within the header; " + kDamaged);
  }
  constexpr std::int64_t kMaxElements = std::numeric_limits<std::int32_t>::max();
  Header header;
  Words words(file, head.substr(0, kTextBytes));
  words.Next();
  header.wordSize = static_cast<int>(words.Integer("the bytes of a value", 1, 99));
  if (header.wordSize != 4 && header.wordSize != 8)
  {
    throw Unsupported(file + ": its values have " + std::to_string(header.wordSize) +
      " bytes; values of 4 and 8 bytes are read.");
  }
  for (int& nodes : header.nodes)
  {
    nodes = static_cast<int>(words.Integer("the nodes of an element in a direction", 1, 999));
    if (nodes > kMaxOrder + 1)
    {
      throw Unsupported(file + ": its elements have " + std::to_string(nodes) +
        " nodes in a direction; at most " + std::to_string(kMaxOrder + 1) +
        " are read. Interpolate to a lower order in the solver.");
    }
  }
  if (header.nodes[0] < 2 || header.nodes[1] < 2)
  {
    throw Unsupported(file +
      ": its elements have one node in a direction of the plane; elements "
      "of order 1 or more are read.");
  }
  header.elements = words.Integer("the number of elements in the file", 0, kMaxElements);
  header.elementsOfAll = words.Integer("the number of elements", 1, kMaxElements);
  header.time = words.Real("the time");
  words.Next(); // the number of the solver's step
  header.part = words.Integer("the number of the file", 0, kMaxElements);
  header.parts = words.Integer("the number of files", 1, kMaxElements);
  if (header.parts == 1)
  {
    header.part = 0; // neko counts its only file from 1
  }
  else if (header.part >= header.parts)
  {
    throw InvalidData(file + ": the header gives " + std::to_string(header.part) +
      " as the number of the file, counted from 0, of " + std::to_string(header.parts) + "; " +
      kDamaged);
  }
  ReadFields(file, words.Rest(), header);
  header.isSwapped = IsSwapped(file, head.substr(kTextBytes, sizeof(float)));
  return header;
}
} // namespace pixelexact::nek5000
