// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/Term.h"

#include "Core/Base/Error.h"

#include <tao/pegtl.hpp>

#include <algorithm>
#include <string_view>
#include <utility>

namespace pixelexact
{
namespace
{
namespace peg = tao::pegtl;

/// Limits of the parser's time and recursion.
constexpr std::size_t kMaxLength = 4096;
constexpr int kMaxDepth = 64;

/// Terms that have been read and are not yet part of another term.
struct Terms
{
  std::vector<Term> done;
  std::vector<std::pair<Term, std::size_t>> open; ///< calls and indices: with how many were done

  Term Pop()
  {
    Term term = std::move(done.back());
    done.pop_back();
    return term;
  }
  /// Makes the terms after the first `count` children of `term`.
  void Close(Term term, std::size_t count)
  {
    const auto first = done.begin() + static_cast<std::ptrdiff_t>(count);
    term.children.insert(
      term.children.end(), std::make_move_iterator(first), std::make_move_iterator(done.end()));
    done.erase(first, done.end());
    done.push_back(std::move(term));
  }
};

// The grammar. A rule includes the blanks after it.
struct Blank : peg::star<peg::space>
{
};
template <class Rule>
struct Lexeme : peg::seq<Rule, Blank>
{
};
struct DigitRun : peg::plus<peg::digit>
{
};
struct DecimalNumber
  : peg::seq<peg::sor<peg::seq<DigitRun, peg::opt<peg::one<'.'>, peg::star<peg::digit>>>,
               peg::seq<peg::one<'.'>, DigitRun>>,
      peg::opt<peg::one<'e', 'E'>, peg::opt<peg::one<'+', '-'>>, DigitRun>>
{
};
/// Letters outside ASCII are bytes of UTF-8.
struct WordBegin : peg::sor<peg::alpha, peg::one<'_'>, peg::not_range<'\x00', '\x7f'>>
{
};
struct PlainWord : peg::seq<WordBegin, peg::star<peg::sor<WordBegin, peg::digit>>>
{
};
struct PlainName : PlainWord
{
};
struct CalledName : PlainWord
{
};
struct DoubleQuoted : peg::seq<peg::one<'"'>, peg::plus<peg::not_one<'"'>>, peg::one<'"'>>
{
};
struct SingleQuoted : peg::seq<peg::one<'\''>, peg::plus<peg::not_one<'\''>>, peg::one<'\''>>
{
};
struct AnyQuoted : peg::sor<DoubleQuoted, SingleQuoted>
{
};

struct Disjunction;
struct CallBegin : peg::one<'('>
{
};
struct CallEnd : peg::one<')'>
{
};
struct IsCalled : peg::at<Lexeme<PlainWord>, peg::one<'('>>
{
};
struct CallTerm
  : peg::seq<Lexeme<CalledName>, Lexeme<CallBegin>, peg::must<Disjunction>,
      peg::star<peg::if_must<Lexeme<peg::one<','>>, Disjunction>>, peg::must<Lexeme<CallEnd>>>
{
};
struct Bracketed : peg::if_must<Lexeme<peg::one<'('>>, Disjunction, Lexeme<peg::one<')'>>>
{
};
struct Primary : peg::sor<Lexeme<DecimalNumber>,
                   peg::if_then_else<IsCalled, CallTerm,
                     peg::sor<Lexeme<PlainName>, Lexeme<AnyQuoted>, Bracketed>>>
{
};
struct ComponentName : peg::one<'x', 'y', 'z'>
{
};
struct ComponentPart
  : peg::if_must<peg::one<'.'>, Lexeme<ComponentName>, peg::not_at<peg::sor<WordBegin, peg::digit>>>
{
};
struct IndexBegin : peg::one<'['>
{
};
struct IndexNumber : DigitRun
{
};
struct IndexEnd : peg::one<']'>
{
};
struct IndexPart
  : peg::if_must<Lexeme<IndexBegin>, Lexeme<IndexNumber>,
      peg::opt<peg::if_must<Lexeme<peg::one<','>>, Lexeme<IndexNumber>>>, Lexeme<IndexEnd>>
{
};
struct Postfix : peg::seq<Primary, peg::star<peg::sor<ComponentPart, IndexPart>>>
{
};

struct PowerSign : peg::sor<peg::one<'^'>, peg::string<'*', '*'>>
{
};
struct TimesSign : peg::seq<peg::one<'*'>, peg::not_at<peg::one<'*'>>>
{
};
struct OverSign : peg::one<'/'>
{
};
struct PlusSign : peg::one<'+'>
{
};
struct MinusSign : peg::one<'-'>
{
};
struct CompareSign : peg::sor<peg::string<'<', '='>, peg::string<'>', '='>, peg::string<'=', '='>,
                       peg::string<'!', '='>, peg::one<'<', '>'>>
{
};
struct AndSign : peg::string<'&', '&'>
{
};
struct OrSign : peg::string<'|', '|'>
{
};
struct NegateSign : peg::one<'-'>
{
};
struct NotSign : peg::seq<peg::one<'!'>, peg::not_at<peg::one<'='>>>
{
};

template <class Sign, class Operand>
struct SignedPart : peg::if_must<Lexeme<Sign>, Operand>
{
};
struct Signed;
struct PowerTerm : peg::seq<Postfix, peg::opt<SignedPart<PowerSign, Signed>>>
{
};
struct NegateTerm : peg::if_must<Lexeme<NegateSign>, Signed>
{
};
struct NotTerm : peg::if_must<Lexeme<NotSign>, Signed>
{
};
struct Signed
  : peg::sor<NegateTerm, NotTerm, peg::if_must<Lexeme<peg::one<'+'>>, Signed>, PowerTerm>
{
};
template <class Operand, class... Signs>
struct RankOf : peg::seq<Operand, peg::star<peg::sor<SignedPart<Signs, Operand>...>>>
{
};
struct Product : RankOf<Signed, TimesSign, OverSign>
{
};
struct Sum : RankOf<Product, PlusSign, MinusSign>
{
};
struct Compared : peg::seq<Sum, peg::opt<SignedPart<CompareSign, Sum>>>
{
};
struct Conjunction : RankOf<Compared, AndSign>
{
};
struct Disjunction : RankOf<Conjunction, OrSign>
{
};
struct WholeText : peg::must<Blank, Disjunction, peg::eof>
{
};

template <class Rule>
struct TermAction : peg::nothing<Rule>
{
};
template <Term::Kind kKind>
struct PushTerm
{
  template <class Input>
  static void apply(const Input& in, Terms& terms)
  {
    terms.done.push_back({ kKind, in.string(), in.position().byte });
  }
};
template <>
struct TermAction<DecimalNumber> : PushTerm<Term::Kind::Number>
{
};
template <>
struct TermAction<IndexNumber> : PushTerm<Term::Kind::Number>
{
};
template <>
struct TermAction<PlainName> : PushTerm<Term::Kind::Name>
{
};
template <>
struct TermAction<AnyQuoted>
{
  template <class Input>
  static void apply(const Input& in, Terms& terms)
  {
    const std::string quoted = in.string();
    terms.done.push_back(
      { Term::Kind::QuotedName, quoted.substr(1, quoted.size() - 2), in.position().byte });
  }
};
template <>
struct TermAction<CalledName>
{
  template <class Input>
  static void apply(const Input& in, Terms& terms)
  {
    terms.open.push_back(
      { { Term::Kind::Call, in.string(), in.position().byte }, terms.done.size() });
  }
};
template <>
struct TermAction<IndexBegin>
{
  template <class Input>
  static void apply(const Input& in, Terms& terms)
  {
    terms.open.push_back(
      { { Term::Kind::Index, "[]", in.position().byte }, terms.done.size() - 1 });
  }
};
struct CloseTerm
{
  template <class Input>
  static void apply(const Input& /*in*/, Terms& terms)
  {
    auto [term, count] = std::move(terms.open.back());
    terms.open.pop_back();
    terms.Close(std::move(term), count);
  }
};
template <>
struct TermAction<CallEnd> : CloseTerm
{
};
template <>
struct TermAction<IndexEnd> : CloseTerm
{
};
template <>
struct TermAction<ComponentName>
{
  template <class Input>
  static void apply(const Input& in, Terms& terms)
  {
    terms.Close({ Term::Kind::Component, in.string(), in.position().byte }, terms.done.size() - 1);
  }
};
/// An operator waits, as a term, for its right operand.
template <class Sign>
requires(std::is_base_of_v<PowerSign, Sign> || std::is_same_v<Sign, TimesSign> ||
  std::is_same_v<Sign, OverSign> || std::is_same_v<Sign, PlusSign> ||
  std::is_same_v<Sign, MinusSign> || std::is_same_v<Sign, CompareSign> ||
  std::is_same_v<Sign, AndSign> ||
  std::is_same_v<Sign, OrSign>) struct TermAction<Sign> : PushTerm<Term::Kind::Binary>
{
};
template <class Sign, class Operand>
struct TermAction<SignedPart<Sign, Operand>>
{
  template <class Input>
  static void apply(const Input& /*in*/, Terms& terms)
  {
    Term right = terms.Pop();
    Term sign = terms.Pop();
    Term left = terms.Pop();
    sign.text = sign.text == "**" ? "^" : sign.text;
    sign.children.push_back(std::move(left));
    sign.children.push_back(std::move(right));
    terms.done.push_back(std::move(sign));
  }
};
template <>
struct TermAction<NegateSign> : PushTerm<Term::Kind::Unary>
{
};
template <>
struct TermAction<NotSign> : PushTerm<Term::Kind::Unary>
{
};
struct ApplySign
{
  template <class Input>
  static void apply(const Input& /*in*/, Terms& terms)
  {
    Term operand = terms.Pop();
    terms.done.back().children.push_back(std::move(operand));
  }
};
template <>
struct TermAction<NegateTerm> : ApplySign
{
};
template <>
struct TermAction<NotTerm> : ApplySign
{
};

/// Rejects deep nesting: brackets, powers and signs within each other are recursions of the parser.
void RequireShallow(const std::string& text)
{
  std::vector<int> brackets; ///< the levels at which they were opened
  int level = 0;
  char before = '(';
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const char c = text[i];
    const bool isSign = c == '+' || c == '-' || c == '!';
    if (c == '(')
    {
      brackets.push_back(level++);
    }
    else if (c == ')' && !brackets.empty())
    {
      level = brackets.back();
      brackets.pop_back();
    }
    else if (c == '^' || (c == '*' && before == '*') ||
      (isSign && std::string_view("(,[+-*/^<>=!&|").find(before) != std::string_view::npos))
    {
      ++level;
    }
    else if (isSign || std::string_view(",*/<>=&|").find(c) != std::string_view::npos)
    {
      level = brackets.empty() ? 0 : brackets.back() + 1;
    }
    if (level > kMaxDepth)
    {
      throw InvalidData(AtPlace("more than " + std::to_string(kMaxDepth) +
          " brackets, signs or powers within each other; write it with fewer",
        text, i));
    }
    before = c == ' ' ? before : c;
  }
}
} // namespace

std::string AtPlace(const std::string& message, const std::string& text, std::size_t at)
{
  // A long text is shown near the place; blanks of all kinds are one column wide.
  constexpr std::size_t kAround = 60;
  const std::size_t first = at > kAround ? at - kAround : 0;
  std::string line = text.substr(first, 2 * kAround);
  std::ranges::replace_if(
    line, [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  return message + "\n  " + line + "\n  " + std::string(std::min(at, text.size()) - first, ' ') +
    "^";
}

Term ParseExpression(const std::string& text)
{
  if (text.size() > kMaxLength)
  {
    throw InvalidData("the expression has " + std::to_string(text.size()) +
      " characters, more than " + std::to_string(kMaxLength) + "; write a shorter one");
  }
  RequireShallow(text);
  Terms terms;
  try
  {
    peg::memory_input<> input(text, "");
    peg::parse<WholeText, TermAction>(input, terms);
  }
  catch (const peg::parse_error& error)
  {
    const std::size_t at = error.positions().front().byte;
    std::size_t end = at + 1; // of the character, which may have several bytes
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
    {
      ++end;
    }
    throw InvalidData(
      AtPlace(at < text.size() ? "'" + text.substr(at, end - at) + "' is not expected here"
                               : "something is missing at the end",
        text, at));
  }
  return terms.Pop();
}
} // namespace pixelexact
