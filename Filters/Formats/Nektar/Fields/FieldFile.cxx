// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Fields/FieldFile.h"

#include "Core/Base/Error.h"
#include "Core/Base/ParseWhole.h"
#include "Core/Basis/Space.h"
#include "Formats/Nektar/Geometry/ReferenceShapes.h"
#include "Formats/Nektar/Homogeneous/HomogeneousBlock.h"
#include "Formats/Slab.h"

#include <sys/mman.h>

#include <algorithm>
#include <map>
#include <new>

namespace pixelexact::nektar
{
namespace
{
double* MapPages(std::size_t bytes)
{
  void* pages = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (pages == MAP_FAILED)
  {
    throw std::bad_alloc();
  }
  return static_cast<double*>(pages);
}

/// Limit of elements. Each has at least one value, but the length of a list of ids bounds nothing.
constexpr std::size_t kMaxElements = std::size_t{ 1 } << 28U;

/// The directions of xi for which the file gives orders, in its order.
std::vector<std::size_t> DirectionsOf(std::string_view shape)
{
  if (shape == "Triangle")
  {
    return { 0, 2 };
  }
  if (shape == "Segment")
  {
    return { 0 };
  }
  return shape == "Quadrilateral" ? std::vector<std::size_t>{ 0, 1 }
                                  : std::vector<std::size_t>{ 0, 1, 2 };
}

Shape ShapeNamed(
  const Document& document, const pugi::xml_node& node, std::string_view name, bool isHomogeneous)
{
  if (name == "Hexahedron" || name == "Quadrilateral" || (name == "Segment" && isHomogeneous))
  {
    return Shape::Hexahedron;
  }
  if (name == "Prism" || name == "Triangle")
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
    "elements of the shape '" + std::string(name.substr(0, 40)) +
      "' are not read; only solids, triangles and quadrilaterals are, and segments of homogeneous "
      "expansions.");
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
    const std::string_view name = Node.attribute("SHAPE").value();
    const std::string_view shape = name.substr(0, name.find('-'));
    const bool isHomogeneous = shape.size() < name.size() || Node.attribute("HOMOGENEOUSLENGTHS");
    Base.shape = ShapeNamed(File, Node, shape, isHomogeneous);
    Block.fields = SplitAtCommas(Node.attribute("FIELDS").value());
    auto families = SplitAtCommas(Node.attribute("BASIS").value());
    Directions = DirectionsOf(shape);
    if (isHomogeneous)
    {
      const HomogeneousBlock read =
        ReadHomogeneousBlock(File, Node, shape, name.substr(shape.size()), families);
      Block.homogeneous = read.along;
      Block.strip = read.strip;
    }
    if (Block.fields.empty() || families.size() != Directions.size())
    {
      File.Fail(Node,
        "the block should have FIELDS and a BASIS of " +
          std::string(Directions.size() == 2 ? "two" : "three") + " families.");
    }
    Base.count = { 1, 1, 1 };
    for (std::size_t d = 0; d < families.size(); ++d)
    {
      Base.families[Directions[d]] = families[d];
    }
    const auto ids = File.List(Node, Node.attribute("ID").value(), kMaxElements);
    const bool compressed = File.IsCompressedField(Node);
    ReadOrders(ids);
    const std::size_t expected = Block.perField * Block.fields.size();
    if (compressed)
    {
      // Reads one more than expected, to detect a wrong number.
      File.PassRecords<double>(Node, expected + 1,
        [this](std::span<const double> some, std::size_t /*packed*/)
        { Block.values.Append(some); });
    }
    else
    {
      Block.values.Append(File.Numbers(Node));
    }
    if (Block.values.Size() != expected)
    {
      File.Fail(Node,
        "the block holds " + std::to_string(Block.values.Size()) + " coefficients, but its " +
          std::to_string(ids.size()) + " elements and " + std::to_string(Block.fields.size()) +
          " fields have " + std::to_string(expected) + ".");
    }
    return std::move(Block);
  }

private:
  void ReadOrders(const std::vector<std::int64_t>& ids)
  {
    const std::string_view text = WithoutBlanks(Node.attribute("NUMMODESPERDIR").value());
    const auto colon = std::min(text.find(':'), text.size());
    const bool mixed = text.substr(0, colon) == "MIXORDER";
    if (!mixed && text.substr(0, colon) != "UNIORDER")
    {
      File.Fail(Node, "NUMMODESPERDIR should begin with UNIORDER: or MIXORDER:.");
    }
    const auto counts = SplitAtCommas(text.substr(std::min(colon + 1, text.size())));
    const std::size_t sets = mixed ? ids.size() : 1;
    const std::size_t directions = Block.homogeneous ? 3 : Directions.size();
    const std::size_t planes = Block.homogeneous ? Block.homogeneous->Functions() : 1;
    if (counts.size() != directions * sets)
    {
      File.Fail(Node,
        "NUMMODESPERDIR has " + std::to_string(counts.size()) + " numbers for " +
          std::to_string(sets) + (mixed ? " elements" : " order") + " of " +
          (directions == 2 ? "two" : "three") + " directions.");
    }
    for (std::size_t e = 0; e < ids.size(); ++e)
    {
      const int expansion =
        AddExpansion(std::span(counts).subspan(mixed ? directions * e : 0, Directions.size()));
      Block.elements.push_back({ ids[e], expansion, Block.perField, ModeCounts[expansion] });
      Block.perField += planes * ModeCounts[expansion];
    }
  }

  int AddExpansion(std::span<const std::string> counts)
  {
    Expansion3 expansion = Base;
    for (std::size_t k = 0; k < counts.size(); ++k)
    {
      const std::string& word = counts[k];
      const std::size_t d = Directions[k];
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
  std::vector<std::size_t> Directions;
  FieldBlock Block;
  std::map<Expansion3, int> Known;
  std::vector<std::size_t> ModeCounts;
};

/// The time in the metadata, in the current form or that of Nektar++ 3.
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

void FieldValues::Unmap::operator()(double* pages) const
{
  munmap(pages, kChunk * sizeof(double));
}

void FieldValues::Append(std::span<const double> values)
{
  while (!values.empty())
  {
    const std::size_t used = Count % kChunk;
    if (used == 0)
    {
      Chunks.push_back({ std::unique_ptr<double[], Unmap>(MapPages(kChunk * sizeof(double))),
        std::make_unique<std::atomic<std::size_t>>(0) });
    }
    const auto part = values.first(std::min(values.size(), kChunk - used));
    std::ranges::copy(part, &Chunks.back().values[used]);
    Count += part.size();
    values = values.subspan(part.size());
  }
}

void FieldValues::Expect(std::size_t begin, std::size_t count)
{
  for (std::size_t c = begin / kChunk; count > 0 && c <= (begin + count - 1) / kChunk; ++c)
  {
    ++*Chunks[c].expected;
  }
}

void FieldValues::Take(std::size_t begin, std::span<double> out)
{
  while (!out.empty())
  {
    Chunk& chunk = Chunks[begin / kChunk];
    const std::size_t at = begin % kChunk;
    const std::size_t count = std::min(out.size(), kChunk - at);
    std::copy_n(&chunk.values[at], count, out.begin());
    if (--*chunk.expected == 0)
    {
      chunk.values.reset();
    }
    out = out.subspan(count);
    begin += count;
  }
}

FieldFile ReadFieldFile(const NamedText& file)
{
  const Document document(file);
  FieldFile result;
  result.notes = document.Notes();
  result.time = ReadTime(document);
  // Reads all NEKTAR elements, as Nektar++ does.
  for (auto root = document.Root(); root; root = root.next_sibling("NEKTAR"))
  {
    for (const auto& node : root.children("ELEMENTS"))
    {
      result.blocks.push_back(BlockReader(document, node).Read());
    }
  }
  return result;
}

std::string NameOf(const Expansion3& expansion)
{
  return expansion.IsLine() ? "segment"
    : expansion.IsPlane()   ? PlaneName(expansion.shape)
                            : Name(expansion.shape);
}

std::string Describe(const Expansion3& expansion)
{
  std::string text = expansion.families[0];
  for (const std::size_t d : { 1, 2 })
  {
    text += expansion.families[d].empty() ? "" : " x " + expansion.families[d];
  }
  return text;
}
} // namespace pixelexact::nektar
