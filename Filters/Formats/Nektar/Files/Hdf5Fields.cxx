// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Files/Hdf5Xml.h"

#include "Core/Base/Error.h"
#include "Formats/Hdf5/Hdf5File.h"
#include "Formats/Nektar/Files/XmlBlocks.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace pixelexact::nektar
{
namespace
{
const std::string kRoot = "/NEKTAR";

/// The names of bases in the order of Nektar++ 5's enumeration.
constexpr std::array kFamilies{ "NoBasisType", "Ortho_A", "Ortho_B", "Ortho_C", "Modified_A",
  "Modified_B", "Modified_C", "OrthoPyr_C", "ModifiedPyr_C", "Fourier", "GLL_Lagrange",
  "Gauss_Lagrange", "Legendre", "Chebyshev", "Monomial", "FourierSingleMode", "FourierHalfModeRe",
  "FourierHalfModeIm" };

/// Columns of DECOMPOSITION. A row states how much of each data set belongs to a block of elements,
/// and names the group that describes it.
enum Column : std::size_t
{
  kElements,
  kValues,
  kOrders,
  kPlanesY,
  kPlanesZ,
  kStrips,
  kGroup,
  kColumns
};

/// The beginning of a block in each data set.
struct Offsets
{
  std::size_t elements = 0;
  std::size_t values = 0;
  std::size_t orders = 0;
  std::size_t planesY = 0;
  std::size_t planesZ = 0;
  std::size_t strips = 0;
};

template <class Number>
std::string Joined(std::span<const Number> numbers)
{
  std::string list;
  for (const Number number : numbers)
  {
    list += (list.empty() ? "" : ",") + std::to_string(number);
  }
  return list;
}

std::string Joined(const std::vector<std::string>& texts)
{
  std::string list;
  for (const std::string& text : texts)
  {
    list += (list.empty() ? "" : ",") + text;
  }
  return list;
}

std::string JoinedReals(const std::vector<double>& numbers)
{
  std::string list;
  for (const double number : numbers)
  {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof(text), number);
    list += (list.empty() ? "" : ",") + std::string(text, end.ptr);
  }
  return list;
}

class FieldsWriter
{
public:
  FieldsWriter(const Hdf5File& file, const std::string& name)
    : File(file)
    , Name(name)
  {
    const auto version = File.IntegerAttributes(kRoot, "FORMAT_VERSION");
    if (version != std::vector<std::int64_t>{ 1 })
    {
      throw Unsupported(Name + ": the version of the field file is not 1, which is read.");
    }
    Rows = File.Unsigned(kRoot + "/DECOMPOSITION");
    if (Rows.size() % kColumns != 0)
    {
      Contradiction("DECOMPOSITION is no table of seven columns");
    }
  }

  [[nodiscard]] std::string Head() const
  {
    std::string xml = "<NEKTAR><Metadata>";
    const std::string metadata = kRoot + "/Metadata";
    if (File.HasAttribute(metadata, "Time"))
    {
      const auto time = File.TextAttributes(metadata, "Time");
      xml += "<Time>" + (time.empty() ? "" : Plain(time.front())) + "</Time>";
    }
    return xml + "</Metadata>";
  }

  /// The names of the first block's fields, as XML.
  [[nodiscard]] std::string Names() const
  {
    return Rows.empty() ? "" : "<ELEMENTS FIELDS=\"" + TextsOf(GroupOf(0), "FIELDS") + "\"/>";
  }

  std::string Blocks()
  {
    Ids = File.Unsigned(kRoot + "/ELEMENTIDS");
    Values = File.Reals(kRoot + "/DATA");
    if (File.Has(kRoot + "/POLYORDERS"))
    {
      Orders = File.Unsigned(kRoot + "/POLYORDERS");
    }
    PlanesY = NumbersIn("HOMOGENEOUSYIDS");
    PlanesZ = NumbersIn("HOMOGENEOUSZIDS");
    Strips = NumbersIn("HOMOGENEOUSSIDS");
    std::string xml;
    Offsets at;
    for (std::size_t row = 0; row < Rows.size() / kColumns; ++row)
    {
      xml += BlockOf(row, at);
    }
    return xml;
  }

private:
  /// An optional data set of numbers.
  [[nodiscard]] std::vector<std::uint64_t> NumbersIn(const char* set) const
  {
    const std::string path = kRoot + "/" + set;
    return File.Has(path) ? File.Unsigned(path) : std::vector<std::uint64_t>();
  }

  [[noreturn]] void Contradiction(const std::string& what) const
  {
    throw InvalidData(Name + ": " + what + "; the file contradicts itself.");
  }

  [[nodiscard]] std::uint64_t At(std::size_t row, Column column) const
  {
    return Rows[row * kColumns + column];
  }

  [[nodiscard]] std::string GroupOf(std::size_t row) const
  {
    return kRoot + "/" + std::to_string(At(row, kGroup));
  }

  /// Text of the file, which must not contain XML's special characters.
  [[nodiscard]] std::string Plain(const std::string& text) const
  {
    if (text.find_first_of("<>&\"") != std::string::npos)
    {
      Contradiction("'" + text.substr(0, 40) + "' is no name or number");
    }
    return text;
  }

  [[nodiscard]] std::string TextsOf(const std::string& group, const char* attribute) const
  {
    return Plain(Joined(File.TextAttributes(group, attribute)));
  }

  /// Takes `count` entries of a data set, from the end of the last block.
  template <class Value>
  std::span<const Value> Take(
    const std::vector<Value>& all, std::size_t& at, std::uint64_t count, const char* set) const
  {
    if (count > all.size() - at)
    {
      Contradiction(std::string("DECOMPOSITION names more than ") + set + " holds");
    }
    const std::span<const Value> part(all.data() + at, static_cast<std::size_t>(count));
    at += part.size();
    return part;
  }

  std::string BlockOf(std::size_t row, Offsets& at) const
  {
    const std::string group = GroupOf(row);
    const auto ids = Take(Ids, at.elements, At(row, kElements), "ELEMENTIDS");
    const auto values = Take(Values, at.values, At(row, kValues), "DATA");
    const auto orders = Take(Orders, at.orders, At(row, kOrders), "POLYORDERS");
    std::string modes = TextsOf(group, "NUMMODESPERDIR");
    if (!modes.starts_with("UNIORDER:"))
    {
      modes = "MIXORDER:" + Joined(orders);
    }
    std::string xml = "<ELEMENTS FIELDS=\"" + TextsOf(group, "FIELDS") + "\" SHAPE=\"" +
      TextsOf(group, "SHAPE") + "\" BASIS=\"" + Families(group) + "\" NUMMODESPERDIR=\"" + modes +
      "\" ID=\"" + Joined(ids) + "\"";
    const auto list = [](const char* name, std::span<const std::uint64_t> numbers)
    {
      return numbers.empty() ? std::string()
                             : std::string(" ") + name + "=\"" + Joined(numbers) + "\"";
    };
    xml += list("HOMOGENEOUSYIDS", Take(PlanesY, at.planesY, At(row, kPlanesY), "HOMOGENEOUSYIDS"));
    xml += list("HOMOGENEOUSZIDS", Take(PlanesZ, at.planesZ, At(row, kPlanesZ), "HOMOGENEOUSZIDS"));
    xml += list("HOMOGENEOUSSIDS", Take(Strips, at.strips, At(row, kStrips), "HOMOGENEOUSSIDS"));
    if (File.HasAttribute(group, "HOMOGENEOUSLENGTHS"))
    {
      xml += " HOMOGENEOUSLENGTHS=\"" +
        JoinedReals(File.RealAttributes(group, "HOMOGENEOUSLENGTHS")) + "\"";
    }
    return xml + " " + kBlockAttributes + ">" + StoredBlock(std::as_bytes(values)) + "</ELEMENTS>";
  }

  /// Whether Nektar++ 4 wrote the file. Its enumeration differs after Modified_C.
  [[nodiscard]] bool IsOld() const
  {
    const std::string provenance = kRoot + "/Metadata/Provenance";
    const auto version = File.HasAttribute(provenance, "NektarVersion")
      ? File.TextAttributes(provenance, "NektarVersion")
      : std::vector<std::string>();
    return !version.empty() && version.front() < "5";
  }

  [[nodiscard]] std::string Families(const std::string& group) const
  {
    constexpr std::int64_t kCommon = 6; // Modified_C
    constexpr std::int64_t kOldFourier = 7;
    std::vector<std::string> names;
    for (const std::int64_t number : File.IntegerAttributes(group, "BASIS"))
    {
      if (number < 0 || number >= static_cast<std::int64_t>(kFamilies.size()))
      {
        Contradiction("a BASIS is number " + std::to_string(number) + ", which is none");
      }
      const bool old = number > kCommon && IsOld();
      if (old && !(number == kOldFourier && File.HasAttribute(group, "HOMOGENEOUSLENGTHS")))
      {
        throw Unsupported(Name + ": a BASIS is number " + std::to_string(number) +
          ", which differs between Nektar++ 4 and 5; write the file again (FieldConvert in.fld "
          "out.fld).");
      }
      names.emplace_back(old ? "Fourier" : kFamilies[static_cast<std::size_t>(number)]);
    }
    return Joined(names);
  }

  const Hdf5File& File;
  const std::string& Name;
  std::vector<std::uint64_t> Rows;
  std::vector<std::uint64_t> Ids;
  std::vector<double> Values;
  std::vector<std::uint64_t> Orders;
  std::vector<std::uint64_t> PlanesY; ///< numbers of functions along y
  std::vector<std::uint64_t> PlanesZ;
  std::vector<std::uint64_t> Strips;
};
} // namespace

std::string Hdf5Fields(const Hdf5File& file, const std::string& name)
{
  FieldsWriter writer(file, name);
  return writer.Head() + writer.Blocks() + "</NEKTAR>";
}

std::string Hdf5FieldsHead(const Hdf5File& file, const std::string& name)
{
  const FieldsWriter writer(file, name);
  return writer.Head() + writer.Names() + "</NEKTAR>";
}
} // namespace pixelexact::nektar
