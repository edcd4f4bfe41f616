// SPDX-License-Identifier: BSD-3-Clause
// The classic formats of netCDF, versions 1, 2 and 5, as "The NetCDF Classic Format Specification"
// of the NetCDF User's Guide (Unidata) defines them. The netCDF library is not used: it ends the
// program, or takes gigabytes, where a header is damaged.
#include "Formats/Exodus/NetcdfFile.h"

#include "Core/Base/Error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <map>
#include <string_view>

namespace pixelexact
{
namespace
{
/// Limits that no valid file exceeds. kMaxEntries holds for dimensions, attributes and variables
/// each.
constexpr std::uint64_t kMaxEntries = 1U << 20U;
constexpr std::uint64_t kMaxNameBytes = 4096;
constexpr std::uint64_t kMaxDimensions = 1024; ///< of a variable
constexpr std::uint64_t kMaxLength = std::uint64_t{ 1 } << 48U;

enum Tag : std::uint32_t
{
  kDimensions = 10,
  kVariables = 11,
  kAttributes = 12
};

enum Type : std::uint32_t
{
  kByte = 1,
  kChar,
  kShort,
  kInt,
  kFloat,
  kDouble,
  kUnsignedByte,
  kUnsignedShort,
  kUnsignedInt,
  kInt64,
  kUnsignedInt64
};

/// Bytes of a value of this type; 0: the format has no such type.
std::size_t BytesOf(std::uint32_t type)
{
  constexpr std::array<std::size_t, 12> kBytes{ 0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8 };
  return type < kBytes.size() ? kBytes[type] : 0;
}

/// A number stored with its most significant byte first.
std::uint64_t BigEndian(const unsigned char* bytes, std::size_t count)
{
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    value = value << 8U | bytes[i];
  }
  return value;
}

struct Variable
{
  std::vector<std::size_t> shape;
  std::map<std::string, std::string> texts; ///< attributes
  std::uint32_t type = 0;
  std::uint64_t begin = 0;  ///< of its values in the file
  std::size_t values = 1;   ///< of one record, or of the whole variable
  bool isOfRecords = false; ///< its first dimension is the one that grows
};

class ClassicFile final : public NetcdfFile
{
public:
  explicit ClassicFile(const std::string& path)
    : Descriptor(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK))
  {
    struct stat status
    {
    };
    if (Descriptor < 0 || fstat(Descriptor, &status) != 0)
    {
      throw InvalidData("it cannot be opened; check its permissions.");
    }
    Size = static_cast<std::uint64_t>(status.st_size);
    try
    {
      ReadHeader();
    }
    catch (...)
    {
      close(Descriptor);
      throw;
    }
  }
  ~ClassicFile() override { close(Descriptor); }
  ClassicFile(const ClassicFile&) = delete;
  ClassicFile& operator=(const ClassicFile&) = delete;

  [[nodiscard]] std::optional<std::size_t> Dimension(const std::string& name) const override;
  [[nodiscard]] std::optional<std::vector<std::size_t>> Shape(
    const std::string& variable) const override;
  [[nodiscard]] bool IsSingle(const std::string& variable) const override
  {
    return Find(variable).type == kFloat;
  }
  [[nodiscard]] std::vector<double> Reals(
    const std::string& variable, Places places) const override;
  [[nodiscard]] std::vector<std::int64_t> Integers(const std::string& variable) const override;
  [[nodiscard]] std::vector<std::string> Texts(const std::string& variable) const override;
  [[nodiscard]] std::string TextAttribute(
    const std::string& variable, const std::string& name) const override;

private:
  [[noreturn]] static void FailHeader()
  {
    throw InvalidData("its netCDF header is damaged or cut short; copy it again.");
  }
  [[noreturn]] static void Fail(const std::string& variable, const std::string& problem)
  {
    throw InvalidData("its variable '" + variable + "' " + problem);
  }

  // Functions that read the header, in file order.
  void Skip(std::uint64_t bytes);
  void ReadBytes(void* to, std::size_t count);
  std::uint64_t ReadNumber(std::size_t bytes);
  std::uint64_t ReadCount() { return ReadNumber(Version == 5 ? 8 : 4); }
  std::string ReadText(std::uint64_t length);
  std::string ReadName();
  std::uint64_t ReadListLength(Tag tag);
  std::map<std::string, std::string> ReadAttributes();
  void ReadVariable();
  void ReadHeader();
  void PlaceRecords(std::uint64_t records);

  [[nodiscard]] const Variable& Find(const std::string& variable) const;
  /// Reads values at `places`; `convert` makes a value from its bytes.
  template <class Value, class Convert>
  std::vector<Value> ReadValues(
    const std::string& name, Places places, const Convert& convert) const;
  void ReadAt(std::uint64_t at, void* to, std::size_t count) const;

  int Descriptor;
  std::uint64_t Size = 0;
  std::uint64_t At = 0; ///< in the header
  std::uint64_t Version = 0;
  std::uint64_t RecordBytes = 0;
  std::size_t RecordDimension = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> Lengths;           ///< of dimensions, by their numbers
  std::map<std::string, std::size_t> Numbers; ///< of dimensions
  std::map<std::string, Variable> Variables;
  std::vector<unsigned char> Buffer; ///< of the header, from BufferBegin
  std::uint64_t BufferBegin = 0;
};

void ClassicFile::ReadAt(std::uint64_t at, void* to, std::size_t count) const
{
  auto* bytes = static_cast<char*>(to);
  while (count > 0)
  {
    const ssize_t got = pread(Descriptor, bytes, count, static_cast<off_t>(at));
    if (got <= 0)
    {
      throw InvalidData("it cannot be read; it is cut short, or changes while it is read.");
    }
    bytes += got;
    at += static_cast<std::uint64_t>(got);
    count -= static_cast<std::size_t>(got);
  }
}

void ClassicFile::Skip(std::uint64_t bytes)
{
  if (bytes > Size - At)
  {
    FailHeader();
  }
  At += bytes;
}

void ClassicFile::ReadBytes(void* to, std::size_t count)
{
  constexpr std::uint64_t kBuffer = 65536; // longer than a name
  const std::uint64_t from = At;
  Skip(count);
  if (from < BufferBegin || At > BufferBegin + Buffer.size())
  {
    BufferBegin = from;
    Buffer.resize(std::min(kBuffer, Size - from));
    ReadAt(from, Buffer.data(), Buffer.size());
  }
  std::memcpy(to, Buffer.data() + (from - BufferBegin), count);
}

std::uint64_t ClassicFile::ReadNumber(std::size_t bytes)
{
  std::array<unsigned char, 8> raw{};
  ReadBytes(raw.data(), bytes);
  return BigEndian(raw.data(), bytes);
}

std::string ClassicFile::ReadText(std::uint64_t length)
{
  if (length > kMaxNameBytes)
  {
    FailHeader();
  }
  std::string text(length, '\0');
  ReadBytes(text.data(), length);
  Skip((4 - length % 4) % 4);
  return text;
}

std::string ClassicFile::ReadName()
{
  return ReadText(ReadCount());
}

std::uint64_t ClassicFile::ReadListLength(Tag tag)
{
  const std::uint64_t found = ReadNumber(4);
  const std::uint64_t count = ReadCount();
  if ((found != tag && (found != 0 || count != 0)) || count > kMaxEntries)
  {
    FailHeader();
  }
  return count;
}

std::map<std::string, std::string> ClassicFile::ReadAttributes()
{
  std::map<std::string, std::string> texts;
  const std::uint64_t count = ReadListLength(kAttributes);
  for (std::uint64_t i = 0; i < count; ++i)
  {
    std::string name = ReadName();
    const auto type = static_cast<std::uint32_t>(ReadNumber(4));
    const std::uint64_t values = ReadCount();
    const std::size_t bytes = BytesOf(type);
    if (bytes == 0 || values > Size / bytes)
    {
      FailHeader();
    }
    if (type == kChar && values <= kMaxNameBytes)
    {
      const std::string text = ReadText(values);
      texts[std::move(name)] = text.substr(0, text.find('\0'));
    }
    else
    {
      Skip((values * bytes + 3) / 4 * 4);
    }
  }
  return texts;
}

void ClassicFile::ReadVariable()
{
  const std::string name = ReadName();
  const std::uint64_t dimensions = ReadCount();
  if (dimensions > kMaxDimensions)
  {
    FailHeader();
  }
  Variable variable;
  std::uint64_t values = 1;
  for (std::uint64_t d = 0; d < dimensions; ++d)
  {
    const std::uint64_t id = ReadCount();
    if (id >= Lengths.size() || (id == RecordDimension && d > 0))
    {
      FailHeader();
    }
    variable.isOfRecords = variable.isOfRecords || id == RecordDimension;
    variable.shape.push_back(Lengths[id]);
    const std::uint64_t length = id == RecordDimension ? 1 : Lengths[id];
    if (length != 0 && values > kMaxLength / length)
    {
      FailHeader();
    }
    values *= length;
  }
  variable.texts = ReadAttributes();
  variable.type = static_cast<std::uint32_t>(ReadNumber(4));
  ReadCount(); // the size, which the shape gives
  variable.begin = ReadNumber(Version == 1 ? 4 : 8);
  variable.values = values;
  if (BytesOf(variable.type) == 0 || !Variables.emplace(name, std::move(variable)).second)
  {
    FailHeader();
  }
}

void ClassicFile::ReadHeader()
{
  std::array<unsigned char, 4> magic{};
  ReadBytes(magic.data(), magic.size());
  Version = magic[3];
  if (std::memcmp(magic.data(), "CDF", 3) != 0 || (Version != 1 && Version != 2 && Version != 5))
  {
    throw InvalidData("it is no netCDF file.");
  }
  const std::uint64_t records = ReadCount();
  const std::uint64_t dimensions = ReadListLength(kDimensions);
  for (std::uint64_t i = 0; i < dimensions; ++i)
  {
    const std::string name = ReadName();
    const std::uint64_t length = ReadCount();
    if (length > kMaxLength)
    {
      FailHeader();
    }
    if (length == 0 && RecordDimension == std::numeric_limits<std::size_t>::max())
    {
      RecordDimension = i;
    }
    Lengths.push_back(length);
    Numbers.emplace(name, i);
  }
  ReadAttributes();
  const std::uint64_t variables = ReadListLength(kVariables);
  for (std::uint64_t i = 0; i < variables; ++i)
  {
    ReadVariable();
  }
  PlaceRecords(records);
  Buffer = {};
}

/// Computes the places of record variables. A record holds one entry of each variable along the
/// unlimited dimension.
void ClassicFile::PlaceRecords(std::uint64_t records)
{
  std::uint64_t count = 0;
  std::uint64_t first = Size;
  std::uint64_t unpadded = 0;
  for (const auto& [name, variable] : Variables)
  {
    if (variable.isOfRecords)
    {
      ++count;
      first = std::min(first, variable.begin);
      unpadded = variable.values * BytesOf(variable.type);
      RecordBytes += (unpadded + 3) / 4 * 4;
      if (RecordBytes > kMaxLength)
      {
        FailHeader();
      }
    }
  }
  RecordBytes = count == 1 ? unpadded : RecordBytes; // a single variable has no padding
  const std::uint64_t unknown = Version == 5 ? std::numeric_limits<std::uint64_t>::max()
                                             : std::numeric_limits<std::uint32_t>::max();
  if (records == unknown)
  {
    records = RecordBytes == 0 ? 0 : (Size - first) / RecordBytes;
  }
  if (records > 0 && RecordBytes > 0 && records > Size / RecordBytes + 1)
  {
    FailHeader();
  }
  if (RecordDimension < Lengths.size())
  {
    Lengths[RecordDimension] = records;
  }
  for (auto& [name, variable] : Variables)
  {
    if (variable.isOfRecords)
    {
      variable.shape.front() = records;
    }
  }
}

std::optional<std::size_t> ClassicFile::Dimension(const std::string& name) const
{
  const auto found = Numbers.find(name);
  return found == Numbers.end() ? std::nullopt : std::optional(Lengths[found->second]);
}

const Variable& ClassicFile::Find(const std::string& variable) const
{
  const auto found = Variables.find(variable);
  if (found == Variables.end())
  {
    Fail(variable, "is not there; the file is damaged or of another program.");
  }
  return found->second;
}

std::optional<std::vector<std::size_t>> ClassicFile::Shape(const std::string& variable) const
{
  const auto found = Variables.find(variable);
  return found == Variables.end() ? std::nullopt : std::optional(found->second.shape);
}

template <class Value, class Convert>
std::vector<Value> ClassicFile::ReadValues(
  const std::string& name, Places places, const Convert& convert) const
{
  const Variable& variable = Find(name);
  const std::size_t bytes = BytesOf(variable.type);
  std::uint64_t count = variable.values;
  std::uint64_t first = 0; // value of a record
  std::uint64_t record = 0;
  std::uint64_t records = variable.isOfRecords ? variable.shape.front() : 1;
  for (std::size_t d = 0; d < places.size(); ++d)
  {
    if (d >= variable.shape.size() || places[d] >= variable.shape[d])
    {
      Fail(name, "has fewer values than the file says; it is damaged.");
    }
    if (d == 0 && variable.isOfRecords)
    {
      record = places[d];
      records = 1;
      continue;
    }
    count /= variable.shape[d];
    first += places[d] * count;
  }
  const std::uint64_t last = records == 0 ? 0 : record + records - 1;
  const std::uint64_t span = (first + count) * bytes;
  if (count == 0 || records == 0)
  {
    return {};
  }
  if (variable.begin > Size || span > Size - variable.begin ||
    (variable.isOfRecords && RecordBytes > 0 &&
      last > (Size - variable.begin - span) / RecordBytes))
  {
    Fail(name, "reaches beyond the end of the file; it is damaged or cut short: copy it again.");
  }
  constexpr std::uint64_t kBlock = std::uint64_t{ 1 } << 20U;
  std::vector<unsigned char> block(std::min(kBlock, count * bytes));
  std::vector<Value> values;
  values.reserve(count * records);
  for (std::uint64_t r = record; r <= last; ++r)
  {
    std::uint64_t at = variable.begin + r * RecordBytes + first * bytes;
    for (std::uint64_t left = count * bytes; left > 0;)
    {
      const std::uint64_t some = std::min<std::uint64_t>(left, block.size());
      ReadAt(at, block.data(), some);
      for (std::uint64_t i = 0; i < some; i += bytes)
      {
        values.push_back(convert(block.data() + i));
      }
      at += some;
      left -= some;
    }
  }
  return values;
}

std::vector<double> ClassicFile::Reals(const std::string& variable, Places places) const
{
  const std::uint32_t type = Find(variable).type;
  if (type != kFloat && type != kDouble)
  {
    Fail(variable, "should hold real numbers; the file is damaged or of another program.");
  }
  return ReadValues<double>(variable, places,
    [type](const unsigned char* bytes) -> double
    {
      return type == kFloat ? std::bit_cast<float>(static_cast<std::uint32_t>(BigEndian(bytes, 4)))
                            : std::bit_cast<double>(BigEndian(bytes, 8));
    });
}

std::vector<std::int64_t> ClassicFile::Integers(const std::string& variable) const
{
  const std::uint32_t type = Find(variable).type;
  if (type == kChar || type == kFloat || type == kDouble)
  {
    Fail(variable, "should hold integers; the file is damaged or of another program.");
  }
  const bool isSigned = type == kByte || type == kShort || type == kInt || type == kInt64;
  const std::size_t bytes = BytesOf(type);
  const auto unused = static_cast<unsigned>(64 - 8 * bytes);
  return ReadValues<std::int64_t>(variable, {},
    [=](const unsigned char* raw)
    {
      const std::uint64_t value = BigEndian(raw, bytes);
      return isSigned ? static_cast<std::int64_t>(value << unused) >> unused
                      : static_cast<std::int64_t>(value);
    });
}

std::vector<std::string> ClassicFile::Texts(const std::string& variable) const
{
  const Variable& found = Find(variable);
  if (found.type != kChar)
  {
    Fail(variable, "should hold text; the file is damaged or of another program.");
  }
  const std::size_t length = found.shape.empty() ? 1 : found.shape.back();
  const std::vector<char> letters = ReadValues<char>(
    variable, {}, [](const unsigned char* byte) { return static_cast<char>(*byte); });
  const std::string_view all(letters.data(), letters.size());
  std::vector<std::string> rows(length == 0 ? 0 : all.size() / length);
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    const std::string_view whole = all.substr(row * length, length);
    rows[row] = whole.substr(0, whole.find('\0'));
  }
  return rows;
}

std::string ClassicFile::TextAttribute(const std::string& variable, const std::string& name) const
{
  const auto& texts = Find(variable).texts;
  const auto found = texts.find(name);
  return found == texts.end() ? std::string() : found->second;
}
} // namespace

std::unique_ptr<NetcdfFile> OpenClassicNetcdf(const std::string& path)
{
  return std::make_unique<ClassicFile>(path);
}
} // namespace pixelexact
