// SPDX-License-Identifier: BSD-3-Clause
#include "Json.h"

#include <charconv>
#include <cmath>

namespace pixelexact::json
{
namespace
{
/// The length of the UTF-8 sequence at the head of `text`; 0 where there is none.
std::size_t SequenceLength(std::string_view text)
{
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t length = lead < 0x80 ? 1
    : lead >= 0xC2 && lead < 0xE0        ? 2
    : lead >= 0xE0 && lead < 0xF0        ? 3
    : lead >= 0xF0 && lead < 0xF5        ? 4
                                         : 0;
  if (length == 0 || length > text.size())
  {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i)
  {
    if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U)
    {
      return 0;
    }
  }
  return length;
}

void Append(std::string& list, const std::string& item)
{
  list += (list.empty() ? "" : ", ") + item;
}
} // namespace

std::string Text(std::string_view text)
{
  constexpr std::string_view digits = "0123456789abcdef";
  std::string quoted = "\"";
  while (!text.empty())
  {
    const auto c = static_cast<unsigned char>(text[0]);
    const std::size_t length = SequenceLength(text);
    if (length == 0)
    {
      // A name of an array or a file may hold any byte, JSON only characters.
      quoted += "\\ufffd";
    }
    else if (c == '"' || c == '\\')
    {
      quoted += { '\\', static_cast<char>(c) };
    }
    else if (c < 0x20)
    {
      quoted += { '\\', 'u', '0', '0', digits[c >> 4U], digits[c & 0xFU] };
    }
    else
    {
      quoted += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return quoted + '"';
}

std::string Number(double number)
{
  if (!std::isfinite(number))
  {
    return "null";
  }
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
  return { buffer.data(), end };
}

std::string Array(std::span<const std::string> values)
{
  std::string list;
  for (const std::string& value : values)
  {
    Append(list, value);
  }
  return "[" + list + "]";
}

std::string Array(std::span<const double> values)
{
  std::string list;
  for (const double value : values)
  {
    Append(list, Number(value));
  }
  return "[" + list + "]";
}

std::string Array(const std::vector<Object>& values)
{
  std::string list;
  for (const Object& value : values)
  {
    Append(list, value.String());
  }
  return "[" + list + "]";
}

Object& Object::Raw(std::string_view name, const std::string& json)
{
  Append(Members, Text(name) + ": " + json);
  return *this;
}

std::string Object::String() const
{
  return "{" + Members + "}";
}
} // namespace pixelexact::json
