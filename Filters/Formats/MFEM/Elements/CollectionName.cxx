// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Elements/CollectionName.h"

#include "Core/Base/Error.h"
#include "Core/Base/Quote.h"
#include "Core/Basis/Space.h"

#include <array>
#include <optional>
#include <string_view>

namespace pixelexact::mfem
{
namespace
{
// MFEM's collections with names of their own: those of fixed order, and those that are not read.

/// Longer names are shown shortened in messages.
constexpr std::size_t kLongestShown = 60;
constexpr const char* kOnFaces = "trace spaces live on faces; save the field itself";
constexpr const char* kProject =
  "project the field to H1 or L2 (ProjectGridFunction) and save that";

/// A name for messages: in quotes, shortened, without control characters.
std::string QuoteName(const std::string& text)
{
  return Quote(text, kLongestShown);
}

/// Throws Unsupported: the collection in quotes, and why.
[[noreturn]] void RefuseCollection(const std::string& text, const std::string& reason)
{
  throw Unsupported(
    "the finite element collection " + QuoteName(text) + " is not supported: " + reason + ".");
}

/// Throws Unsupported: of elements of another dimension than the mesh's.
[[noreturn]] void RefuseDimension(const std::string& text, int dimension, int wanted)
{
  RefuseCollection(text,
    "it is one of " + std::to_string(dimension) + "-D elements, but those of the mesh are " +
      std::to_string(wanted) + "-D; the grid function belongs to another mesh");
}

/// A collection of fixed order, of elements of that dimension. Throws Unsupported for those of
/// others.
std::optional<CollectionName> FixedCollection(const std::string& text, int dimension)
{
  struct Entry
  {
    std::string_view name;
    Continuity continuity;
    int order;
    bool shared;
    int dimension; ///< 0: of any
  };
  static constexpr std::array kEntries{
    Entry{ "Linear", Continuity::H1, 1, true, 0 },
    Entry{ "Quadratic", Continuity::H1, 2, true, 0 },
    Entry{ "Cubic", Continuity::H1, 3, true, 0 },
    Entry{ "Const2D", Continuity::L2, 0, false, 2 },
    Entry{ "LinearDiscont2D", Continuity::L2, 1, false, 2 },
    Entry{ "QuadraticDiscont2D", Continuity::L2, 2, false, 2 },
    Entry{ "CubicDiscont2D", Continuity::L2, 3, false, 2 },
    Entry{ "RT0_2D", Continuity::HDiv, 0, true, 2 },
    Entry{ "Const3D", Continuity::L2, 0, false, 3 },
    Entry{ "LinearDiscont3D", Continuity::L2, 1, false, 3 },
    Entry{ "QuadraticDiscont3D", Continuity::L2, 2, false, 3 },
    Entry{ "ND1_3D", Continuity::HCurl, 1, true, 3 },
    Entry{ "RT0_3D", Continuity::HDiv, 0, true, 3 },
    Entry{ "RT1_3D", Continuity::HDiv, 1, true, 3 },
  };
  for (const Entry& entry : kEntries)
  {
    if (text == entry.name)
    {
      if (entry.dimension != 0 && entry.dimension != dimension)
      {
        RefuseDimension(text, entry.dimension, dimension);
      }
      CollectionName name;
      name.text = text;
      name.continuity = entry.continuity;
      name.order = entry.order;
      name.dimension = dimension;
      name.closed = LineBasis::ClosedUniform;
      name.open = LineBasis::OpenUniform;
      name.shared = entry.shared;
      name.legacy = true;
      return name;
    }
  }
  return std::nullopt;
}

/// Throws for names of collections that are not read.
void RefuseOtherCollections(const std::string& text)
{
  struct Entry
  {
    std::string_view begin;
    const char* reason;
  };
  static constexpr std::array kEntries{
    Entry{ "NURBS",
      "it is a NURBS space; project the field to an H1 or L2 space in MFEM "
      "(ProjectGridFunction) and save that" },
    Entry{ "H1_Trace", kOnFaces },
    Entry{ "H1Pos_Trace", kOnFaces },
    Entry{ "RT_Trace", kOnFaces },
    Entry{ "RT_ValTrace", kOnFaces },
    Entry{ "ND_Trace", kOnFaces },
    Entry{ "DG_I", "interface spaces live on faces; save the field itself" },
    Entry{ "H1Ser_", "serendipity spaces are not read; project the field to H1 and save that" },
    Entry{ "RT_R", kProject },
    Entry{ "ND_R", kProject },
    Entry{ "Local_", "local spaces are not read; project the field to H1 or L2 and save that" },
    Entry{ "LinearNonConf3D", "project the field to L2 and save that" },
    Entry{ "CrouzeixRaviart", kProject },
    Entry{ "QuadraticPos", kProject },
    Entry{ "P1OnQuad", kProject },
    Entry{ "GaussLinearDiscont2D", kProject },
    Entry{ "GaussQuadraticDiscont2D", kProject },
    Entry{ "RT1_2D", kProject },
    Entry{ "RT2_2D", kProject },
  };
  for (const Entry& entry : kEntries)
  {
    if (text.starts_with(entry.begin))
    {
      RefuseCollection(text, entry.reason);
    }
  }
}

constexpr std::string_view kBasisLetters = "gGPuUoSci";
/// Numbers in names have at most this number of digits.
constexpr int kMaxDigits = 4;

[[noreturn]] void RejectName(const std::string& text)
{
  throw InvalidData(QuoteName(text) +
    " is no name of one of MFEM's finite element collections, such as H1_3D_P2, L2_T1_3D_P3, "
    "ND_3D_P1 or RT_3D_P0.");
}

/// Takes a name apart from left to right.
class Parser
{
public:
  explicit Parser(const std::string& text)
    : Text(text)
    , Rest(text)
  {
  }

  bool Skip(std::string_view word)
  {
    if (!Rest.starts_with(word))
    {
      return false;
    }
    Rest.remove_prefix(word.size());
    return true;
  }

  void Expect(std::string_view word)
  {
    if (!Skip(word))
    {
      RejectName(Text);
    }
  }

  int Number()
  {
    int number = 0;
    int digits = 0;
    while (!Rest.empty() && Rest.front() >= '0' && Rest.front() <= '9' && digits < kMaxDigits)
    {
      number = 10 * number + (Rest.front() - '0');
      Rest.remove_prefix(1);
      ++digits;
    }
    if (digits == 0)
    {
      RejectName(Text);
    }
    return number;
  }

  LineBasis Letter()
  {
    const auto at = Rest.empty() ? std::string_view::npos : kBasisLetters.find(Rest.front());
    if (at == std::string_view::npos)
    {
      if (!Skip("s")) // an old letter of the Gauss-Lobatto basis
      {
        RejectName(Text);
      }
      return LineBasis::GaussLobatto;
    }
    Rest.remove_prefix(1);
    return static_cast<LineBasis>(at);
  }

  /// Parses "_3D_P4", and "_Pyr0" after it.
  void DimensionAndOrder(CollectionName& name, int least)
  {
    Expect("_");
    const int dimension = Number();
    Expect("D_P");
    name.order = Number();
    if (Skip("_Pyr"))
    {
      Pyramid(name);
    }
    if (!Rest.empty())
    {
      RejectName(Text);
    }
    if (dimension != name.dimension)
    {
      RefuseDimension(Text, dimension, name.dimension);
    }
    if (name.order < least)
    {
      throw InvalidData("the finite element collection " + QuoteName(Text) + " has order " +
        std::to_string(name.order) + ", but MFEM's begin at " + std::to_string(least) + ".");
    }
    // H(div) functions reach one order beyond the number in their name.
    if (name.order + (name.continuity == Continuity::HDiv ? 1 : 0) > kMaxOrder)
    {
      RefuseCollection(Text, "orders above " + std::to_string(kMaxOrder) + " are refused");
    }
  }

private:
  void Pyramid(CollectionName& name)
  {
    const int space = Number();
    if (space > 1)
    {
      RefuseCollection(Text, "MFEM has pyramid spaces 0 and 1 only");
    }
    name.pyramid = static_cast<PyramidSpace>(space);
  }

  const std::string& Text;
  std::string_view Rest;
};

bool IsNodal(LineBasis basis)
{
  return basis != LineBasis::Positive && basis != LineBasis::Serendipity &&
    basis != LineBasis::IntegratedGaussLobatto;
}

bool HasEnds(LineBasis basis)
{
  return basis == LineBasis::GaussLobatto || basis == LineBasis::ClosedUniform ||
    basis == LineBasis::ClosedGaussLegendre;
}

void ParseH1(Parser& parser, CollectionName& name)
{
  if (parser.Skip("Pos"))
  {
    name.closed = LineBasis::Positive;
  }
  else if (parser.Skip("@"))
  {
    name.closed = parser.Letter();
  }
  parser.DimensionAndOrder(name, 1);
  if (name.closed != LineBasis::Positive && !HasEnds(name.closed))
  {
    RefuseCollection(name.text, "MFEM has no continuous space with " + Describe(name.closed));
  }
}

void ParseL2(Parser& parser, CollectionName& name)
{
  name.shared = false;
  name.entityOrdered = false;
  name.closed = LineBasis::GaussLegendre;
  name.integral = parser.Skip("Int");
  if (parser.Skip("_T"))
  {
    const int basis = parser.Number();
    if (basis >= static_cast<int>(kBasisLetters.size()))
    {
      RejectName(name.text);
    }
    name.closed = static_cast<LineBasis>(basis);
  }
  parser.DimensionAndOrder(name, 0);
  if (name.closed != LineBasis::Positive && !IsNodal(name.closed))
  {
    RefuseCollection(
      name.text, "discontinuous spaces with " + Describe(name.closed) + " are not read");
  }
}

void ParseVector(Parser& parser, CollectionName& name, int least)
{
  if (parser.Skip("@"))
  {
    name.closed = parser.Letter();
    name.open = parser.Letter();
  }
  parser.DimensionAndOrder(name, least);
  if (!HasEnds(name.closed) ||
    !(IsNodal(name.open) || name.open == LineBasis::IntegratedGaussLobatto))
  {
    RefuseCollection(name.text,
      "MFEM has no such space with " + Describe(name.closed) + " and " + Describe(name.open));
  }
}
} // namespace

CollectionName ParseCollectionName(const std::string& text, int dimension)
{
  if (auto fixed = FixedCollection(text, dimension))
  {
    return *fixed;
  }
  RefuseOtherCollections(text);
  CollectionName name;
  name.text = text;
  name.dimension = dimension;
  Parser parser(text);
  if (parser.Skip("H1"))
  {
    name.continuity = Continuity::H1;
    ParseH1(parser, name);
  }
  else if (parser.Skip("L2"))
  {
    name.continuity = Continuity::L2;
    ParseL2(parser, name);
  }
  else if (parser.Skip("ND"))
  {
    name.continuity = Continuity::HCurl;
    ParseVector(parser, name, 1);
  }
  else if (parser.Skip("RT"))
  {
    name.continuity = Continuity::HDiv;
    ParseVector(parser, name, 0);
  }
  else
  {
    RejectName(text);
  }
  return name;
}

std::string Describe(LineBasis basis)
{
  static constexpr std::array kNames{ "Gauss-Legendre nodes", "Gauss-Lobatto nodes",
    "Bernstein functions", "open uniform nodes", "uniform nodes", "half-open uniform nodes",
    "serendipity functions", "closed Gauss-Legendre nodes", "integrated Gauss-Lobatto functions" };
  return kNames.at(static_cast<std::size_t>(basis));
}
} // namespace pixelexact::mfem
