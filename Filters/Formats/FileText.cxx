// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/FileText.h"

#include "Core/Base/ParseWhole.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <memory>

namespace pixelexact
{
namespace
{
/// Text of numbers is compressed to about a third. A much higher ratio is not text of numbers.
constexpr std::uintmax_t kLargestExpansion = 200;
constexpr std::size_t kBlock = std::size_t{ 1 } << 20U;
/// Smaller files are read instead of mapped.
constexpr off_t kMinMapped = off_t{ 1 } << 23U;

bool IsGzip(int file)
{
  std::array<unsigned char, 2> magic{};
  return pread(file, magic.data(), magic.size(), 0) == 2 && magic[0] == 0x1f && magic[1] == 0x8b;
}

struct CloseFile
{
  void operator()(gzFile file) const { gzclose_r(file); }
};

/// Whether a decimal number that is not zero is below 1.
bool IsSmall(std::string_view number)
{
  const auto letter = std::min(number.find_first_of("eE"), number.size());
  const std::string_view digits = number.substr(0, letter);
  const std::string_view power = number.substr(std::min(letter + 1, number.size()));
  long exponent = 0;
  if (!power.empty() && !ParseWhole(power, exponent))
  {
    return power.starts_with('-');
  }
  const auto first = static_cast<long>(digits.find_first_of("123456789"));
  const auto point = static_cast<long>(std::min(digits.find('.'), digits.size()));
  // Compares the exponent with the position of the first digit relative to the point.
  return exponent < (first < point ? first - point + 1 : first - point);
}
} // namespace

bool IsPipeOrDevice(const std::string& path)
{
  std::error_code failure;
  const auto status = std::filesystem::status(path, failure);
  return std::filesystem::exists(status) && !std::filesystem::is_directory(status) &&
    !std::filesystem::is_regular_file(status);
}

void RequireRegularFile(const std::string& path)
{
  std::error_code failure;
  const auto status = std::filesystem::status(path, failure);
  if (!std::filesystem::exists(status))
  {
    throw InvalidData("there is no file '" + path + "'; check its name.");
  }
  if (std::filesystem::is_directory(status))
  {
    throw InvalidData("'" + path + "' is a folder; name a file.");
  }
  if (IsPipeOrDevice(path))
  {
    throw InvalidData("cannot read '" + path + "': " + kPipeRemedy + ".");
  }
}

std::string ReadFileText(const std::string& path)
{
  RequireRegularFile(path);
  std::error_code failure;
  const std::uintmax_t size = std::filesystem::file_size(path, failure);
  const std::unique_ptr<gzFile_s, CloseFile> file(gzopen(path.c_str(), "rb"));
  if (failure || !file)
  {
    throw InvalidData("'" + path + "' cannot be opened; check its permissions.");
  }
  std::string text;
  text.reserve(size + kBlock); // what is read next must fit, too: a copy would double the memory
  for (;;)
  {
    const std::size_t begin = text.size();
    text.resize(begin + kBlock);
    const int got = gzread(file.get(), text.data() + begin, kBlock);
    text.resize(begin + static_cast<std::size_t>(got < 0 ? 0 : got));
    int state = Z_OK;
    const char* message = gzerror(file.get(), &state);
    // For a truncated stream gzread reports no error; only the state is Z_BUF_ERROR.
    if (got < 0 || state != Z_OK)
    {
      throw InvalidData("'" + path + "' is damaged (" + message + "); copy it again.");
    }
    if (got == 0)
    {
      return text;
    }
    if (text.size() > kLargestExpansion * (size + 1))
    {
      throw InvalidData("'" + path + "' expands to more than " + std::to_string(kLargestExpansion) +
        " times its size; gunzip it if that is right.");
    }
  }
}

std::string ReadFileHead(const std::string& path, std::size_t bytes)
{
  std::error_code failure;
  if (!std::filesystem::is_regular_file(path, failure))
  {
    return {};
  }
  const std::unique_ptr<gzFile_s, CloseFile> file(gzopen(path.c_str(), "rb"));
  std::string head(bytes, '\0');
  const int got =
    file ? gzread(file.get(), head.data(), static_cast<unsigned int>(head.size())) : 0;
  head.resize(static_cast<std::size_t>(std::max(0, got)));
  return head;
}

FileText::FileText(const std::string& path)
  : Path(path)
{
  // Opening without blocking avoids waiting for a pipe without a writer.
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  struct stat status
  {
  };
  if (file >= 0 && fstat(file, &status) == 0 && S_ISREG(status.st_mode) &&
    status.st_size >= kMinMapped && !IsGzip(file))
  {
    const auto size = static_cast<std::size_t>(status.st_size);
    void* begin = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE, file, 0);
    if (begin != MAP_FAILED)
    {
      madvise(begin, size, MADV_SEQUENTIAL);
      File = file;
      Text = { static_cast<const char*>(begin), size };
      return;
    }
  }
  if (file >= 0)
  {
    close(file);
  }
  Held = ReadFileText(path);
  Text = Held;
}

FileText::~FileText()
{
  if (File >= 0)
  {
    munmap(const_cast<char*>(Text.data()), Text.size());
    close(File);
  }
}

std::span<char> FileText::Own() const
{
  return File >= 0 ? std::span(const_cast<char*>(Text.data()), Text.size()) : std::span<char>();
}

void FileText::Forget(std::size_t begin, std::size_t end) const
{
  if (File < 0)
  {
    return;
  }
  RequireSameSize();
  static const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  begin = begin / page * page;
  end = end == Text.size() ? end : end / page * page; // the last page ends with the text
  if (end > begin)
  {
    madvise(const_cast<char*>(Text.data()) + begin, end - begin, MADV_DONTNEED);
  }
}

/// Throws where the file was truncated since, because reading mapped pages beyond its end ends the
/// program.
void FileText::RequireSameSize() const
{
  struct stat status
  {
  };
  if (fstat(File, &status) != 0 || static_cast<std::size_t>(status.st_size) != Text.size())
  {
    throw InvalidData("'" + Path +
      "' changes while it is read; read it when its solver has written it to the end.");
  }
}

void ReadingTrace::MoveTo(std::size_t at)
{
  if (File != nullptr)
  {
    File->Forget(From, std::max(From, at));
    From = at;
    Next = at + kStep;
  }
}

void ReadingTrace::Forget(std::size_t at)
{
  File->Forget(From, at);
  From = at;
  Next = at + kStep;
}

void FileTexts::Add(const std::vector<std::string>& files)
{
  for (const auto& file : files)
  {
    const FileText& text = Storage.emplace_back(file);
    Named.push_back({ file, text.Get(), &text });
  }
}

bool ParseReal(std::string_view word, double& value)
{
  if (ParseWhole(word, value))
  {
    return true;
  }
  word.remove_prefix(word.starts_with('+') ? 1 : 0);
  double none = 0.0;
  const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), none);
  if (failure != std::errc::result_out_of_range || end != word.data() + word.size())
  {
    return false;
  }
  const bool negative = word.starts_with('-');
  word.remove_prefix(negative ? 1 : 0);
  value = IsSmall(word) ? 0.0 : std::numeric_limits<double>::infinity();
  value = negative ? -value : value;
  return true;
}
} // namespace pixelexact
