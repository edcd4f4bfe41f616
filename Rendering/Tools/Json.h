// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <concepts>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// A writer of JSON, in the order in which things are added. JSON knows no NaN and no infinity:
// they become null.
namespace pixelexact::json
{
std::string Text(std::string_view text);
std::string Number(double number);

class Object;

/// Values already spelled as JSON, as "[a, b]".
std::string Array(std::span<const std::string> values);
std::string Array(std::span<const double> values);
std::string Array(const std::vector<Object>& values);

class Object
{
public:
  Object& Raw(std::string_view name, const std::string& json);
  Object& Add(std::string_view name, double value) { return Raw(name, Number(value)); }
  Object& Add(std::string_view name, bool value) { return Raw(name, value ? "true" : "false"); }
  Object& Add(std::string_view name, std::integral auto value)
  {
    return Raw(name, std::to_string(value));
  }
  Object& Add(std::string_view name, std::string_view value) { return Raw(name, Text(value)); }
  // Else a literal would become a bool.
  Object& Add(std::string_view name, const char* value) { return Raw(name, Text(value)); }
  Object& Add(std::string_view name, std::span<const double> values)
  {
    return Raw(name, Array(values));
  }
  Object& Add(std::string_view name, const Object& value) { return Raw(name, value.String()); }
  Object& Add(std::string_view name, const std::vector<Object>& values)
  {
    return Raw(name, Array(values));
  }

  [[nodiscard]] std::string String() const;

private:
  std::string Members;
};
} // namespace pixelexact::json
