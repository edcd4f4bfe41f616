// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/Translator.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
namespace
{
/// Predefined names and their aliases.
struct BuiltIn
{
  const char* name;
  const char* alias;
};
constexpr std::array kBuiltIns{ BuiltIn{ "x", "coords.x" }, BuiltIn{ "y", "coords.y" },
  BuiltIn{ "z", "coords.z" }, BuiltIn{ "coords", "" }, BuiltIn{ "t", "time" },
  BuiltIn{ "time", "t" }, BuiltIn{ "xi", "" }, BuiltIn{ "n", "normal" }, BuiltIn{ "normal", "n" },
  BuiltIn{ "pi", "" }, BuiltIn{ "detJ", "" }, BuiltIn{ "scaledJacobian", "" },
  BuiltIn{ "order", "" }, BuiltIn{ "element", "" } };

const BuiltIn* FindBuiltIn(const std::string& name)
{
  const auto* found = std::ranges::find_if(
    kBuiltIns, [&name](const BuiltIn& builtIn) { return name == builtIn.name; });
  return found == kBuiltIns.end() ? nullptr : found;
}

// Names of ParaView's Calculator, which the fields of a mesh may have instead.
constexpr std::array<std::array<const char*, 2>, 6> kParaViewNames{ {
  { "iHat", "vec(1,0,0)" },
  { "jHat", "vec(0,1,0)" },
  { "kHat", "vec(0,0,1)" },
  { "coordsX", "coords.x" },
  { "coordsY", "coords.y" },
  { "coordsZ", "coords.z" },
} };

/// The number of one of `components` from the end of a name in ParaView's menus: X, Y or Z of
/// vectors, two of these of 6 components, else a number. -1: there is none.
int ComponentIn(const std::string& ending, int components)
{
  static const std::vector<std::string> kAxes{ "X", "Y", "Z" };
  static const std::vector<std::string> kPairs{ "XX", "YY", "ZZ", "XY", "YZ", "XZ" };
  const std::vector<std::string>& names = components == 6 ? kPairs : kAxes;
  if (const auto found = std::ranges::find(names, ending); found != names.end())
  {
    return static_cast<int>(found - names.begin());
  }
  const bool isNumber = !ending.empty() && ending.size() < 4 &&
    std::ranges::all_of(ending, [](char c) { return c >= '0' && c <= '9'; });
  return isNumber ? std::stoi(ending) : -1;
}

/// The term of a name in ParaView's Calculator: one of kParaViewNames, or a component as v_X.
/// `componentsOf` gives the number of a name's components, 0 for no name.
template <class ComponentsOf>
std::optional<Term> TermOfParaView(const Term& term, const ComponentsOf& componentsOf)
{
  const auto* found = std::ranges::find_if(
    kParaViewNames, [&term](const auto& known) { return term.text == known[0]; });
  if (found != kParaViewNames.end() && term.kind == Term::Kind::Name)
  {
    return ParseExpression((*found)[1]);
  }
  const std::size_t end = term.text.rfind('_');
  if (end == std::string::npos)
  {
    return std::nullopt;
  }
  const std::string base = term.text.substr(0, end);
  const int components = componentsOf(base);
  const int component = components > 1 ? ComponentIn(term.text.substr(end + 1), components) : -1;
  if (component < 0)
  {
    return std::nullopt;
  }
  return Term{ Term::Kind::Index, "", term.at,
    { { Term::Kind::QuotedName, base, term.at },
      { Term::Kind::Number, std::to_string(component), term.at } } };
}

template <class Number>
bool ReadNumber(const std::string& text, Number& value)
{
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}
} // namespace

Translator::Translator(Graph& graph, const ExpressionScope& scope)
  : Scalars(graph)
  , Algebra(graph)
  , Scope(scope)
{
}

/// Adds the term's place to what `function` throws.
template <class Function>
auto Translator::AtTerm(const Term& term, const Function& function)
{
  try
  {
    return function();
  }
  catch (const Unsupported& error)
  {
    throw Unsupported(AtPlace(error.what(), Texts.back(), term.at));
  }
  catch (const Error& error)
  {
    throw InvalidData(AtPlace(error.what(), Texts.back(), term.at));
  }
}

Tensor Translator::Translate(const std::string& text)
{
  Texts.push_back(text);
  Tensor tensor = Make(ParseExpression(text));
  Texts.pop_back();
  return tensor;
}

Tensor Translator::Make(const Term& term)
{
  switch (term.kind)
  {
    case Term::Kind::Number:
      return AtTerm(term,
        [&]
        {
          double value = 0.0;
          if (!ReadNumber(term.text, value) || !std::isfinite(value))
          {
            throw InvalidData("'" + term.text + "' is too large or too small for a number");
          }
          return ScalarOf(Scalars.Constant(value));
        });
    case Term::Kind::Name:
    case Term::Kind::QuotedName:
      return MakeName(term);
    case Term::Kind::Call:
      return MakeCall(term);
    case Term::Kind::Component:
    case Term::Kind::Index:
      return MakeIndex(term);
    case Term::Kind::Unary:
    {
      const Tensor operand = Make(term.children[0]);
      return AtTerm(term, [&] { return Algebra.Operate(term.text, operand); });
    }
    default:
    {
      const Tensor left = Make(term.children[0]);
      const Tensor right = Make(term.children[1]);
      return AtTerm(term, [&] { return Algebra.Operate(term.text, left, right); });
    }
  }
}

Tensor Translator::MakeName(const Term& term)
{
  const std::string& name = term.text;
  const std::size_t field = FindField(name);
  const bool isField = field < Scope.fields.size();
  const bool isDefined = Scope.definitions.contains(name);
  const BuiltIn* builtIn = term.kind == Term::Kind::Name ? FindBuiltIn(name) : nullptr;
  if (isDefined && builtIn == nullptr)
  {
    return AtTerm(term, [&] { return MakeDefinition(name); });
  }
  if (builtIn == nullptr && !isField && !Scope.parameters.contains(name))
  {
    const auto componentsOf = [this](const std::string& base)
    {
      const std::size_t at = FindField(base);
      return at < Scope.fields.size() ? Scope.fields[at].values.components
                                      : 3 * static_cast<int>(Scope.definitions.contains(base));
    };
    if (const auto other = TermOfParaView(term, componentsOf))
    {
      return Make(*other);
    }
  }
  return AtTerm(term,
    [&]
    {
      if (builtIn != nullptr && (isField || isDefined))
      {
        const std::string alias = builtIn->alias;
        throw InvalidData("'" + name + "' is a field, and a name of expressions: write \"" + name +
          "\" with its quotes for the field" +
          (alias.empty() ? "" : ", " + alias + " for the other"));
      }
      if (builtIn != nullptr)
      {
        return MakeBuiltIn(name);
      }
      if (isField)
      {
        return MakeField(field);
      }
      if (const auto parameter = Scope.parameters.find(name); parameter != Scope.parameters.end())
      {
        return ScalarOf(Scalars.Constant(parameter->second));
      }
      throw InvalidData("nothing is named '" + name + "'; there are " + KnownNames());
    });
}

Tensor Translator::MakeDefinition(const std::string& name)
{
  if (std::ranges::find(Defined, name) != Defined.end())
  {
    throw InvalidData("'" + name + "' is defined by itself");
  }
  if (const auto made = Made.find(name); made != Made.end())
  {
    return made->second;
  }
  Defined.push_back(name);
  Tensor tensor = Translate(Scope.definitions.at(name));
  Defined.pop_back();
  Made[name] = tensor;
  return tensor;
}

Tensor Translator::MakeBuiltIn(const std::string& name)
{
  const auto leaf = [this](Operation operation, int a)
  { return Scalars.Leaf({ .operation = operation, .a = a }); };
  const auto vector = [&](Operation operation) {
    return VectorOf({ leaf(operation, 0), leaf(operation, 1), leaf(operation, 2) });
  };
  if (name == "x" || name == "y" || name == "z")
  {
    return ScalarOf(leaf(Operation::Coordinate, name[0] - 'x'));
  }
  if (name == "coords")
  {
    return vector(Operation::Coordinate);
  }
  if (name == "xi")
  {
    return vector(Operation::Reference);
  }
  if (name == "pi")
  {
    return ScalarOf(leaf(Operation::Pi, 0));
  }
  if (name == "t" || name == "time")
  {
    if (!Scope.time)
    {
      throw InvalidData("the data have no time; write a number");
    }
    return ScalarOf(Scalars.Constant(*Scope.time));
  }
  if (name == "detJ")
  {
    return ScalarOf(leaf(Operation::Determinant, 0));
  }
  if (name == "scaledJacobian")
  {
    return ScalarOf(leaf(Operation::ScaledJacobian, 0));
  }
  if (name == "order")
  {
    if (Scope.fields.empty())
    {
      throw InvalidData(
        "'order' needs a field, and there is none; use it with data that have fields");
    }
    return ScalarOf(leaf(Operation::Order, 0));
  }
  if (name == "element")
  {
    return ScalarOf(leaf(Operation::ElementNumber, 0));
  }
  return vector(Operation::Normal); // n, normal
}

Tensor Translator::MakeField(std::size_t field)
{
  Tensor tensor;
  const int components = Scope.fields[field].values.components;
  tensor.rank = components > 1 ? 1 : 0;
  tensor.rows = components;
  for (int c = 0; c < components; ++c)
  {
    tensor.nodes.push_back(Scalars.Leaf(
      { .operation = Operation::Value, .field = static_cast<int>(field), .component = c }));
  }
  return tensor;
}

Tensor Translator::MakeCall(const Term& term)
{
  if (term.text == "order" && (term.children.size() == 1 || term.children.size() == 2))
  {
    const std::size_t field = FindField(term.children[0].text);
    return AtTerm(term,
      [&]
      {
        if (field >= Scope.fields.size())
        {
          throw InvalidData("order takes the name of a field; there are " + KnownNames());
        }
        int direction = -1;
        if (term.children.size() == 2 &&
          (!ReadNumber(term.children[1].text, direction) || direction < 0 || direction > 2))
        {
          throw InvalidData("'" + term.children[1].text +
            "' is no direction of order; write 0, 1 or 2 for xi[0], xi[1] or xi[2]");
        }
        return ScalarOf(Scalars.Leaf(
          { .operation = Operation::Order, .field = static_cast<int>(field), .a = direction + 1 }));
      });
  }
  std::vector<Tensor> arguments;
  for (const Term& child : term.children)
  {
    arguments.push_back(Make(child));
  }
  return AtTerm(term,
    [&]
    {
      if (term.text == "norm")
      {
        throw InvalidData("norm is ambiguous; write mag(v) for the length of v, v/mag(v) for its "
                          "direction");
      }
      return Algebra.Call(term.text == "ln" ? "log" : term.text, arguments);
    });
}

Tensor Translator::MakeIndex(const Term& term)
{
  const Tensor of = Make(term.children[0]);
  return AtTerm(term,
    [&]
    {
      std::vector<int> index;
      if (term.kind == Term::Kind::Component)
      {
        if (of.rank != 1)
        {
          throw InvalidData(NameOf(of) + " has no ." + term.text);
        }
        index.push_back(term.text[0] - 'x');
      }
      for (std::size_t k = 1; k < term.children.size(); ++k)
      {
        int number = 0;
        if (!ReadNumber(term.children[k].text, number))
        {
          throw InvalidData("'" + term.children[k].text + "' is no number of a component");
        }
        index.push_back(number);
      }
      return Algebra.Index(of, index);
    });
}

std::size_t Translator::FindField(const std::string& name) const
{
  return static_cast<std::size_t>(
    std::ranges::find(Scope.fields, name, &Field::name) - Scope.fields.begin());
}

std::string Translator::KnownNames() const
{
  std::string names = "the fields";
  for (const Field& field : Scope.fields)
  {
    names += " " + field.name;
  }
  for (const auto& [name, text] : Scope.definitions)
  {
    names += " " + name;
  }
  names = Scope.fields.empty() && Scope.definitions.empty() ? "no fields" : names;
  names += Scope.parameters.empty() ? "" : ", the parameters";
  for (const auto& [name, value] : Scope.parameters)
  {
    names += " " + name;
  }
  names += ", and";
  for (const BuiltIn& builtIn : kBuiltIns)
  {
    names += std::string(" ") + builtIn.name;
  }
  return names;
}
} // namespace pixelexact
