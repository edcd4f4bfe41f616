// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Files/Expression.h"

#include "Core/Base/Error.h"

#include <tao/pegtl.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <vector>

namespace pixelexact::nektar
{
namespace
{
struct NamedConstant
{
  std::string_view name;
  double value;
};
constexpr NamedConstant kNamedConstants[] = {
  { "MEANINGLESS", 0.0 },
  { "E", std::numbers::e },
  { "LOG2E", std::numbers::log2e },
  { "LOG10E", std::numbers::log10e },
  { "LN2", std::numbers::ln2 },
  { "LN10", std::numbers::ln10 },
  { "PI", std::numbers::pi },
  { "PI_2", std::numbers::pi / 2 },
  { "PI_4", std::numbers::pi / 4 },
  { "SQRT2", std::numbers::sqrt2 },
  { "SQRT1_2", std::numbers::sqrt2 / 2 },
  { "GAMMA", std::numbers::egamma },
  { "DEG", 180 / std::numbers::pi },
  { "PHI", std::numbers::phi },
};

struct Function1
{
  std::string_view name;
  double (*value)(double);
};
constexpr Function1 kFunctions1[] = {
  { "abs", [](double x) { return std::fabs(x); } },
  { "fabs", [](double x) { return std::fabs(x); } },
  { "asin", [](double x) { return std::asin(x); } },
  { "acos", [](double x) { return std::acos(x); } },
  { "atan", [](double x) { return std::atan(x); } },
  { "ceil", [](double x) { return std::ceil(x); } },
  { "floor", [](double x) { return std::floor(x); } },
  { "cos", [](double x) { return std::cos(x); } },
  { "cosh", [](double x) { return std::cosh(x); } },
  { "exp", [](double x) { return std::exp(x); } },
  { "log", [](double x) { return std::log(x); } },
  { "log10", [](double x) { return std::log10(x); } },
  { "sign", [](double x) { return double(x > 0) - double(x < 0); } },
  { "sin", [](double x) { return std::sin(x); } },
  { "sinh", [](double x) { return std::sinh(x); } },
  { "sqrt", [](double x) { return std::sqrt(x); } },
  { "tan", [](double x) { return std::tan(x); } },
  { "tanh", [](double x) { return std::tanh(x); } },
};

struct Function2
{
  std::string_view name;
  double (*value)(double, double);
};
constexpr Function2 kFunctions2[] = {
  { "atan2", [](double y, double x) { return std::atan2(y, x); } },
  { "ang", [](double x, double y) { return std::atan2(y, x); } },
  { "rad", [](double x, double y) { return std::hypot(x, y); } },
  { "fmod", [](double x, double y) { return std::fmod(x, y); } },
  { "max", [](double x, double y) { return std::fmax(x, y); } },
  { "fmax", [](double x, double y) { return std::fmax(x, y); } },
  { "min", [](double x, double y) { return std::fmin(x, y); } },
  { "fmin", [](double x, double y) { return std::fmin(x, y); } },
};

/// A constant of Nektar++'s expressions, or nothing.
std::optional<double> ConstantNamed(std::string_view name)
{
  const auto* found = std::ranges::find(kNamedConstants, name, &NamedConstant::name);
  return found != std::end(kNamedConstants) ? std::optional(found->value) : std::nullopt;
}

/// The value of a function of Nektar++'s expressions; nothing where none has this name and number
/// of arguments. awgn, which is random, is left out.
std::optional<double> CallFunction(std::string_view name, std::span<const double> arguments)
{
  const auto* one = std::ranges::find(kFunctions1, name, &Function1::name);
  if (arguments.size() == 1 && one != std::end(kFunctions1))
  {
    return one->value(arguments[0]);
  }
  const auto* two = std::ranges::find(kFunctions2, name, &Function2::name);
  if (arguments.size() == 2 && two != std::end(kFunctions2))
  {
    return two->value(arguments[0], arguments[1]);
  }
  return std::nullopt;
}

namespace peg = tao::pegtl;

/// Bounds of the parser's time and of its recursion.
constexpr std::size_t kLongest = 256;
constexpr int kMaxDepth = 32;

struct State
{
  const NamedValue& parameter;
  std::vector<double> values;
  std::vector<std::string> functions;   ///< that are being called
  std::vector<std::size_t> firstValues; ///< of their arguments

  double Pop()
  {
    const double value = values.back();
    values.pop_back();
    return value;
  }
};

// The grammar. A rule includes the blanks after it.
struct Blanks : peg::star<peg::space>
{
};
template <class Rule>
struct Token : peg::seq<Rule, Blanks>
{
};

struct Digits : peg::plus<peg::digit>
{
};
struct Sign : peg::one<'+', '-'>
{
};
struct Mantissa : peg::sor<peg::seq<Digits, peg::opt<peg::one<'.'>, peg::star<peg::digit>>>,
                    peg::seq<peg::one<'.'>, Digits>>
{
};
struct Number
  : peg::seq<peg::opt<Sign>, Mantissa, peg::opt<peg::one<'e', 'E'>, peg::opt<Sign>, Digits>>
{
};
struct Word : peg::seq<peg::sor<peg::alpha, peg::one<'_', '$'>>,
                peg::star<peg::sor<peg::alnum, peg::one<'_', '$'>>>>
{
};
struct Name : Word
{
};
struct FunctionName : Word
{
};

struct Comparison;
struct IsCall : peg::at<Token<Word>, peg::one<'('>>
{
};
struct Call : peg::seq<Token<FunctionName>, Token<peg::one<'('>>,
                peg::list<Comparison, Token<peg::one<','>>>, Token<peg::one<')'>>>
{
};
struct Parentheses : peg::seq<Token<peg::one<'('>>, Comparison, Token<peg::one<')'>>>
{
};
struct Base : peg::sor<Token<Number>, peg::if_then_else<IsCall, Call, Token<Name>>, Parentheses>
{
};

struct Plus : peg::one<'+'>
{
  static double Of(double a, double b) { return a + b; }
};
struct Minus : peg::one<'-'>
{
  static double Of(double a, double b) { return a - b; }
};
struct Times : peg::one<'*'>
{
  static double Of(double a, double b) { return a * b; }
};
struct Over : peg::one<'/'>
{
  static double Of(double a, double b) { return a / b; }
};
struct Modulo : peg::one<'%'>
{
  static double Of(double a, double b) { return std::fmod(a, b); }
};
struct Power : peg::one<'^'>
{
  static double Of(double a, double b) { return std::pow(a, b); }
};
struct EqualSign : peg::string<'=', '='>
{
  static double Of(double a, double b) { return a == b ? 1.0 : 0.0; }
};
struct AtMost : peg::string<'<', '='>
{
  static double Of(double a, double b) { return a <= b ? 1.0 : 0.0; }
};
struct AtLeast : peg::string<'>', '='>
{
  static double Of(double a, double b) { return a >= b ? 1.0 : 0.0; }
};
struct Less : peg::one<'<'>
{
  static double Of(double a, double b) { return a < b ? 1.0 : 0.0; }
};
struct More : peg::one<'>'>
{
  static double Of(double a, double b) { return a > b ? 1.0 : 0.0; }
};

template <class Operator, class Operand>
struct Apply : peg::seq<Token<Operator>, Operand>
{
};
/// Operands and operators of one rank, from left to right.
template <class Operand, class... Operators>
struct Rank : peg::seq<Operand, peg::star<peg::sor<Apply<Operators, Operand>...>>>
{
};

struct Exponential : peg::seq<Base, peg::opt<Apply<Power, Exponential>>>
{
};
struct Product : Rank<Exponential, Times, Over, Modulo>
{
};
struct Negative : peg::seq<Token<peg::one<'-'>>, Product>
{
};
struct Term : peg::sor<Negative, Product>
{
};
struct Sum : Rank<Term, Plus, Minus>
{
};
struct Inequality : Rank<Sum, AtMost, AtLeast, Less, More>
{
};
struct Comparison : Rank<Inequality, EqualSign>
{
};
struct Grammar : peg::seq<Blanks, Comparison, peg::must<peg::eof>>
{
};

template <class Rule>
struct Action : peg::nothing<Rule>
{
};

template <class Operator, class Operand>
struct Action<Apply<Operator, Operand>>
{
  static void apply0(State& state)
  {
    const double b = state.Pop();
    state.values.back() = Operator::Of(state.values.back(), b);
  }
};

template <>
struct Action<Negative>
{
  static void apply0(State& state) { state.values.back() = -state.values.back(); }
};

template <>
struct Action<Number>
{
  template <class Input>
  static void apply(const Input& in, State& state)
  {
    std::string_view text = in.string_view();
    text.remove_prefix(text.starts_with('+') ? 1 : 0);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc())
    {
      throw InvalidData("'" + in.string() + "' is beyond the range of numbers");
    }
    state.values.push_back(value);
  }
};

template <>
struct Action<Name>
{
  template <class Input>
  static void apply(const Input& in, State& state)
  {
    const auto constant = ConstantNamed(in.string_view());
    const auto value = constant ? constant : state.parameter(in.string_view());
    if (!value)
    {
      throw InvalidData(
        "'" + in.string() + "' is neither a constant nor a parameter of the session");
    }
    state.values.push_back(*value);
  }
};

template <>
struct Action<FunctionName>
{
  template <class Input>
  static void apply(const Input& in, State& state)
  {
    state.functions.push_back(in.string());
    state.firstValues.push_back(state.values.size());
  }
};

template <>
struct Action<Call>
{
  static void apply0(State& state)
  {
    const std::string& name = state.functions.back();
    const std::size_t first = state.firstValues.back();
    const auto arguments = std::span<const double>(state.values).subspan(first);
    const auto value = CallFunction(name, arguments);
    if (!value)
    {
      throw InvalidData("there is no function '" + name + "' of " +
        std::to_string(arguments.size()) + (arguments.size() == 1 ? " argument" : " arguments"));
    }
    state.values.resize(first);
    state.values.push_back(*value);
    state.functions.pop_back();
    state.firstValues.pop_back();
  }
};

void CheckSize(std::string_view text)
{
  int depth = 0;
  int deepest = 0;
  for (const char c : text)
  {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    deepest = std::max(deepest, depth);
  }
  if (text.size() > kLongest || deepest > kMaxDepth)
  {
    throw InvalidData("it is longer than " + std::to_string(kLongest) +
      " characters, or has more than " + std::to_string(kMaxDepth) +
      " parentheses within each other");
  }
}
} // namespace

double Evaluate(std::string_view text, const NamedValue& parameter)
{
  CheckSize(text);
  State state{ parameter, {}, {}, {} };
  peg::memory_input<> input(text.data(), text.size(), "");
  try
  {
    if (!peg::parse<Grammar, Action>(input, state))
    {
      throw InvalidData("it cannot be read");
    }
  }
  catch (const peg::parse_error& error)
  {
    const auto at = error.positions().front().byte;
    throw InvalidData("it cannot be read from '" + std::string(text.substr(at, 20)) + "' on");
  }
  if (!std::isfinite(state.values.back()))
  {
    throw InvalidData("its value is not finite");
  }
  return state.values.back();
}
} // namespace pixelexact::nektar
