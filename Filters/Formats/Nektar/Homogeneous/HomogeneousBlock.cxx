// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Homogeneous/HomogeneousBlock.h"

#include "Core/Base/ParseWhole.h"
#include "Formats/Nektar/Files/Conditions.h"

#include <numeric>

namespace pixelexact::nektar
{
namespace
{
/// Limit of functions along a direction; the number of layers is proportional to them.
constexpr std::int64_t kMaxFunctions = 1024;
/// Limit of products of two directions' functions.
constexpr std::size_t kMaxLines = std::size_t{ 1 } << 16U;

class HomogeneousReader
{
public:
  HomogeneousReader(const Document& document, const pugi::xml_node& node)
    : File(document)
    , Node(node)
  {
  }

  HomogeneousBlock Read(
    std::string_view shape, std::string_view kind, std::vector<std::string>& families)
  {
    constexpr std::string_view kStrips = "-Strips";
    Homogeneous& along = Result.along;
    along.strips = kind.ends_with(kStrips);
    kind.remove_suffix(along.strips ? kStrips.size() : 0);
    const bool onLine = shape == "Segment";
    const std::string last = families.empty() ? std::string() : families.back();
    const bool sound = onLine ? kind == "-HomogenousExp2D" && families.size() == 3 &&
        last == "Fourier" && families[1] == "Fourier" && !along.strips
                              : kind == "-HomogenousExp1D" && families.size() == 3 &&
        (last == "Fourier" ||
          (!along.strips &&
            (last == "FourierSingleMode" || last == "FourierHalfModeRe" ||
              last == "FourierHalfModeIm")));
    if (!sound)
    {
      File.FailUnsupported(Node,
        "of homogeneous expansions those of triangles and quadrilaterals are read, with Fourier, "
        "FourierSingleMode, FourierHalfModeRe or FourierHalfModeIm along z, strips with Fourier, "
        "and those of segments with Fourier along y and z; not '" +
          std::string(Node.attribute("SHAPE").value()).substr(0, 40) + "' with '" +
          last.substr(0, 40) + "'; " + HomogeneousRemedy());
    }
    along.half = last == "FourierHalfModeRe" ? HalfMode::Real
      : last == "FourierHalfModeIm"          ? HalfMode::Imaginary
                                             : HalfMode::None;
    families.resize(onLine ? 1 : 2);
    if (onLine)
    {
      along.y.emplace();
    }
    ReadLengths();
    if (onLine)
    {
      ReadLines();
    }
    else
    {
      along.z.functions = Distinct("HOMOGENEOUSZIDS", 1);
    }
    if (along.half != HalfMode::None && along.z.functions != std::vector{ 0 })
    {
      File.Fail(Node, "a half mode should have one function along z, number 0.");
    }
    if (along.strips)
    {
      ReadStrip();
    }
    return std::move(Result);
  }

private:
  void ReadLengths()
  {
    constexpr double kMaxLength = 1e150; // a size must have a square
    const auto words = SplitAtCommas(Node.attribute("HOMOGENEOUSLENGTHS").value());
    std::vector<double*> lengths;
    if (Result.along.y)
    {
      lengths.push_back(&Result.along.y->length);
    }
    lengths.push_back(&Result.along.z.length);
    bool sound = words.size() == lengths.size();
    for (std::size_t k = 0; sound && k < words.size(); ++k)
    {
      sound = ParseWhole(words[k], *lengths[k]) && *lengths[k] > 0.0 && *lengths[k] <= kMaxLength;
    }
    if (!sound)
    {
      File.Fail(Node,
        std::string("HOMOGENEOUSLENGTHS should be ") +
          (lengths.size() == 1 ? "one number" : "two numbers") + " above 0, and below 1e150.");
    }
  }

  /// The numbers of functions in a list. Without a list: 0 to the number in NUMMODESPERDIR, at
  /// place `fromEnd` from its last, less one.
  std::vector<int> Numbers(const char* list, int fromEnd, std::size_t most) const
  {
    const auto numbers = Node.attribute(list) ? File.List(Node, Node.attribute(list).value(), most)
                                              : NumbersOfFunctions(fromEnd);
    std::vector<int> functions;
    for (const std::int64_t number : numbers)
    {
      if (number >= kMaxFunctions)
      {
        File.Fail(Node,
          std::string(list) + " names the function " + std::to_string(number) + ", one above " +
            std::to_string(kMaxFunctions - 1) + ".");
      }
      functions.push_back(static_cast<int>(number));
    }
    if (functions.empty())
    {
      File.Fail(Node, std::string(list) + " names no function.");
    }
    return functions;
  }

  std::vector<int> Distinct(const char* list, int fromEnd) const
  {
    std::vector<int> functions = Numbers(list, fromEnd, kMaxFunctions);
    std::vector<int> sorted = functions;
    std::ranges::sort(sorted);
    if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end())
    {
      File.Fail(
        Node, std::string(list) + " names the function " + std::to_string(*twice) + " twice.");
    }
    return functions;
  }

  /// The numbers where the file does not list them: 0 to the number in NUMMODESPERDIR less one.
  std::vector<std::int64_t> NumbersOfFunctions(int fromEnd) const
  {
    const auto words = SplitAtCommas(Node.attribute("NUMMODESPERDIR").value());
    std::int64_t count = 0;
    if (words.size() <= static_cast<std::size_t>(fromEnd) ||
      !ParseWhole(words[words.size() - static_cast<std::size_t>(fromEnd)], count) || count < 1 ||
      count > kMaxFunctions)
    {
      File.Fail(Node, "NUMMODESPERDIR does not give the number of homogeneous functions.");
    }
    std::vector<std::int64_t> numbers(static_cast<std::size_t>(count));
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
  }

  /// Reads lines of products: each product of a function of y and one of z has an entry in both
  /// lists, y's fastest.
  void ReadLines()
  {
    Homogeneous& along = Result.along;
    if (!Node.attribute("HOMOGENEOUSYIDS") || !Node.attribute("HOMOGENEOUSZIDS"))
    {
      along.y->functions = Distinct("HOMOGENEOUSYIDS", 2);
      along.z.functions = Distinct("HOMOGENEOUSZIDS", 1);
      if (along.Functions() > kMaxLines)
      {
        File.Fail(
          Node, "there are more than " + std::to_string(kMaxLines) + " homogeneous functions.");
      }
      return;
    }
    const auto ofY = Numbers("HOMOGENEOUSYIDS", 2, kMaxLines);
    const auto ofZ = Numbers("HOMOGENEOUSZIDS", 1, kMaxLines);
    const auto again = std::find(ofY.begin() + 1, ofY.end(), ofY.front());
    const auto run = static_cast<std::size_t>(again - ofY.begin());
    along.y->functions.assign(ofY.begin(), again);
    for (std::size_t k = 0; k < ofZ.size(); k += run)
    {
      along.z.functions.push_back(ofZ[k]);
    }
    const auto isDistinct = [](std::vector<int> list)
    {
      std::ranges::sort(list);
      return std::ranges::adjacent_find(list) == list.end();
    };
    bool sound = ofY.size() == ofZ.size() && ofY.size() == run * along.z.functions.size() &&
      isDistinct(along.y->functions) && isDistinct(along.z.functions);
    for (std::size_t k = 0; sound && k < ofY.size(); ++k)
    {
      sound = ofY[k] == ofY[k % run] && ofZ[k] == along.z.functions[k / run];
    }
    if (!sound)
    {
      File.Fail(Node,
        "HOMOGENEOUSYIDS and HOMOGENEOUSZIDS should name each product of functions once, those of "
        "y fastest.");
    }
  }

  void ReadStrip()
  {
    constexpr std::int64_t kMaxStrips = 1 << 16;
    const auto numbers = File.List(Node, Node.attribute("HOMOGENEOUSSIDS").value(), 2);
    if (numbers.size() != 1 || numbers.front() >= kMaxStrips)
    {
      File.Fail(Node, "HOMOGENEOUSSIDS should be the number of one strip, below 65536.");
    }
    Result.strip = static_cast<int>(numbers.front());
  }

  const Document& File;
  pugi::xml_node Node;
  HomogeneousBlock Result;
};
} // namespace

std::vector<std::string> SplitAtCommas(std::string_view text)
{
  std::vector<std::string> words;
  while (!text.empty())
  {
    const auto comma = std::min(text.find(','), text.size());
    words.emplace_back(WithoutBlanks(text.substr(0, comma)));
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return words;
}

HomogeneousBlock ReadHomogeneousBlock(const Document& document, const pugi::xml_node& node,
  std::string_view shape, std::string_view kind, std::vector<std::string>& families)
{
  return HomogeneousReader(document, node).Read(shape, kind, families);
}
} // namespace pixelexact::nektar
