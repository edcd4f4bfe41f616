// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/FieldFile.h"

#include "Core/Base/Error.h"
#include "Core/Basis/Space.h"
#include "Formats/Nektar/Conditions.h"
#include "Formats/Nektar/ModifiedModes.h"

#include <algorithm>
#include <map>

namespace pixelexact::nektar
{
namespace
{
/// An element has one value at least; ids alone are not in proportion to anything.
constexpr std::size_t kMostElements = std::size_t{ 1 } << 28U;

std::vector<std::string> Split(std::string_view text)
{
  std::vector<std::string> words;
  while (!text.empty())
  {
    const auto comma = std::min(text.find(','), text.size());
    words.emplace_back(Trim(text.substr(0, comma)));
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return words;
}

Shape ShapeNamed(const Document& document, const pugi::xml_node& node)
{
  const std::string_view name = node.attribute("SHAPE").value();
  if (name == "Hexahedron")
  {
    return Shape::Hexahedron;
  }
  if (name == "Prism")
  {
    return Shape::Prism;
  }
  if (name == "Tetrahedron")
  {
    return Shape::Tetrahedron;
  }
  if (name == "Pyramid")
  {
    return Shape::Pyramid;
  }
  document.FailUnsupported(node,
    name.find("-Homogen") != name.npos ? HomogeneousRemedy()
                                       : "elements of the shape '" +
        std::string(name.substr(0, 40)) + "' are not read; only solids are.");
}

class BlockReader
{
public:
  BlockReader(const Document& document, const pugi::xml_node& node)
    : File(document)
    , Node(node)
  {
  }

  FieldBlock Read()
  {
    if (Node.attribute("HOMOGENEOUSLENGTHS") || Node.attribute("NUMHOMODIRECTIONS"))
    {
      File.FailUnsupported(Node, HomogeneousRemedy());
    }
    Base.shape = ShapeNamed(File, Node);
    Block.fields = Split(Node.attribute("FIELDS").value());
    const auto families = Split(Node.attribute("BASIS").value());
    if (Block.fields.empty() || families.size() != 3)
    {
      File.Fail(Node, "the block should have FIELDS and a BASIS of three families.");
    }
    std::ranges::copy(families, Base.families.begin());
    const auto ids = File.List(Node, Node.attribute("ID").value(), kMostElements);
    const bool compressed = File.IsCompressedField(Node);
    ReadOrders(ids);
    const std::size_t expected = Block.perField * Block.fields.size();
    if (compressed)
    {
      // One more than right would be noticed.
      Block.values = File.Records<double>(Node, expected + 1);
    }
    else
    {
      Block.values = File.Numbers(Node);
    }
    if (Block.values.size() != expected)
    {
      File.Fail(Node,
        "the block holds " + std::to_string(Block.values.size()) + " coefficients, but its " +
          std::to_string(ids.size()) + " elements and " + std::to_string(Block.fields.size()) +
          " fields have " + std::to_string(expected) + ".");
    }
    return std::move(Block);
  }

private:
  void ReadOrders(const std::vector<std::int64_t>& ids)
  {
    const std::string_view text = Trim(Node.attribute("NUMMODESPERDIR").value());
    const auto colon = std::min(text.find(':'), text.size());
    const bool mixed = text.substr(0, colon) == "MIXORDER";
    if (!mixed && text.substr(0, colon) != "UNIORDER")
    {
      File.Fail(Node, "NUMMODESPERDIR should begin with UNIORDER: or MIXORDER:.");
    }
    const auto counts = Split(text.substr(std::min(colon + 1, text.size())));
    const std::size_t sets = mixed ? ids.size() : 1;
    if (counts.size() != 3 * sets)
    {
      File.Fail(Node,
        "NUMMODESPERDIR has " + std::to_string(counts.size()) + " numbers for " +
          std::to_string(sets) + (mixed ? " elements" : " order") + " of three directions.");
    }
    for (std::size_t e = 0; e < ids.size(); ++e)
    {
      const int expansion = AddExpansion(std::span(counts).subspan(mixed ? 3 * e : 0, 3));
      Block.elements.push_back({ ids[e], expansion, Block.perField, ModeCounts[expansion] });
      Block.perField += ModeCounts[expansion];
    }
  }

  int AddExpansion(std::span<const std::string> counts)
  {
    Expansion3 expansion = Base;
    for (int d = 0; d < 3; ++d)
    {
      const std::string& word = counts[d];
      const bool digits = !word.empty() && word.size() < 4 &&
        std::ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; });
      expansion.count[d] = digits ? std::stoi(word) : 0;
      if (expansion.count[d] < 1 || expansion.count[d] > kMaxOrder + 1)
      {
        File.Fail(Node,
          "'" + word.substr(0, 20) +
            "' modes along a direction are not between 1 "
            "and " +
            std::to_string(kMaxOrder + 1) + ".");
      }
    }
    const auto [at, isNew] = Known.try_emplace(expansion, static_cast<int>(Known.size()));
    if (isNew)
    {
      Block.expansions.push_back(expansion);
      ModeCounts.push_back(ModesOf(expansion.shape, expansion.count).size());
    }
    return at->second;
  }

  const Document& File;
  pugi::xml_node Node;
  Expansion3 Base;
  FieldBlock Block;
  std::map<Expansion3, int> Known;
  std::vector<std::size_t> ModeCounts;
};

/// The time in the metadata, in the form of today or that of Nektar++ 3.
std::optional<double> ReadTime(const Document& document)
{
  pugi::xml_node time = document.Root().child("Metadata").child("Time");
  const auto old = document.Root().child("FIELDMETADATA");
  time = time ? time : old.find_child_by_attribute("P", "PARAM", "Time");
  if (!time)
  {
    return std::nullopt;
  }
  const auto numbers = document.Numbers(time);
  if (numbers.size() != 1)
  {
    document.Fail(time, "the time should be one number.");
  }
  return numbers[0];
}
} // namespace

FieldFile ReadFieldFile(const NamedText& file)
{
  const Document document(file);
  FieldFile result;
  result.time = ReadTime(document);
  // As Nektar++ does, from each element NEKTAR.
  for (auto root = document.Root(); root; root = root.next_sibling("NEKTAR"))
  {
    for (const auto& node : root.children("ELEMENTS"))
    {
      result.blocks.push_back(BlockReader(document, node).Read());
    }
  }
  return result;
}

std::string Describe(const Expansion3& expansion)
{
  return expansion.families[0] + " x " + expansion.families[1] + " x " + expansion.families[2];
}
} // namespace pixelexact::nektar
