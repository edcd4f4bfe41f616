// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/FieldSum.h"

#include "HighOrderModel.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <system_error>
#include <utility>

namespace pixelexact
{
namespace
{
/// Reads SumOfFields.
class SumReader
{
public:
  SumReader(const HighOrderModel& model, std::string text)
    : Model(model)
    , Text(std::move(text))
  {
  }

  /// Empty where the text is something else.
  std::vector<Summand> Read()
  {
    std::vector<Summand> sum;
    double sign = Skip('-') ? -1.0 : 1.0;
    do
    {
      const std::optional<Summand> product = ReadProduct(sign);
      if (!product)
      {
        return {};
      }
      sum.push_back(*product);
      sign = Peek() == '-' ? -1.0 : 1.0;
    } while (Skip('+') || Skip('-'));
    return Peek() == kEnd ? sum : std::vector<Summand>();
  }

private:
  static constexpr char kEnd = '\0';

  char Peek()
  {
    At = std::min(Text.find_first_not_of(" \t", At), Text.size());
    return At < Text.size() ? Text[At] : kEnd;
  }

  bool Skip(char wanted)
  {
    const bool isThere = Peek() == wanted;
    At += isThere ? 1 : 0;
    return isThere;
  }

  std::optional<Summand> ReadProduct(double factor)
  {
    Summand product{ nullptr, factor };
    do
    {
      const std::optional<double> number = ReadNumber();
      const Field* field = number ? nullptr : ReadField();
      if (!number && (field == nullptr || product.field != nullptr))
      {
        return std::nullopt;
      }
      product.factor *= number.value_or(1.0);
      product.field = number ? product.field : field;
    } while (Skip('*'));
    return product.field != nullptr ? std::optional(product) : std::nullopt;
  }

  std::optional<double> ReadNumber()
  {
    const std::size_t begin = At;
    const bool isInBrackets = Skip('(');
    const double sign = isInBrackets && Skip('-') ? -1.0 : 1.0;
    double number = 0.0;
    const char* const first = Text.data() + (Peek() == kEnd ? Text.size() : At);
    const auto [end, failure] = std::from_chars(first, Text.data() + Text.size(), number);
    const bool isNumber =
      failure == std::errc() && (std::isdigit(static_cast<unsigned char>(*first)) || *first == '.');
    At = isNumber ? static_cast<std::size_t>(end - Text.data()) : begin;
    if (!isNumber || (isInBrackets && !Skip(')')))
    {
      At = begin;
      return std::nullopt;
    }
    return sign * number;
  }

  const Field* ReadField()
  {
    const char quote = Peek();
    std::string name;
    if (quote == '\'' || quote == '"')
    {
      const std::size_t end = Text.find(quote, At + 1);
      if (end == std::string::npos)
      {
        return nullptr;
      }
      name = Text.substr(At + 1, end - At - 1);
      At = end + 1;
    }
    for (; quote != '\'' && quote != '"' && At < Text.size(); ++At)
    {
      if (std::isalnum(static_cast<unsigned char>(Text[At])) == 0 && Text[At] != '_')
      {
        break;
      }
      name += Text[At];
    }
    const auto found = std::ranges::find(Model.Fields(), name, &Field::name);
    return found != Model.Fields().end() ? &*found : nullptr;
  }

  const HighOrderModel& Model;
  std::string Text;
  std::size_t At = 0;
};
} // namespace

std::vector<Summand> SumOfFields(const HighOrderModel& model, const std::string& text)
{
  return SumReader(model, text).Read();
}
} // namespace pixelexact
