// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Files/FileParts.h"

#include "Core/Base/Error.h"
#include "Core/Base/ParseWhole.h"
#include "Formats/Hdf5/Hdf5File.h"
#include "Formats/Nektar/Files/Hdf5Xml.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace pixelexact::nektar
{
namespace
{
/// The metadata precede the data.
constexpr std::size_t kHead = std::size_t{ 1 } << 16U;

std::string HeadOf(const std::string& path)
{
  if (IsPipeOrDevice(path))
  {
    throw InvalidData("cannot read '" + path + "': " + kPipeRemedy + ".");
  }
  std::ifstream stream(path, std::ios::binary);
  std::string head(kHead, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  return IsHdf5(head) ? Hdf5Metadata(path) : head;
}

/// The number between a tag's end and what comes next, where there is nothing else.
std::optional<double> NumberBehind(std::string_view head, std::string_view tag)
{
  const auto at = head.find(tag);
  const auto begin = at == head.npos ? at : at + tag.size();
  const auto end = at == head.npos ? at : head.find('<', begin);
  if (end == head.npos)
  {
    return std::nullopt;
  }
  double number = 0.0;
  const bool whole = ParseWhole(WithoutBlanks(head.substr(begin, end - begin)), number);
  return whole ? std::optional(number) : std::nullopt;
}

namespace fs = std::filesystem;

/// The attribute's value; found as text, because parsing a session twice would take twice as long.
std::string MeshNamedIn(std::string_view session)
{
  constexpr std::string_view kAttribute = " HDF5FILE=";
  const auto at = session.find(kAttribute);
  const auto begin = at == session.npos ? at : at + kAttribute.size() + 1;
  if (begin == session.npos || begin > session.size())
  {
    return {};
  }
  const auto end = session.find(session[begin - 1], begin); // the same quotation mark
  return std::string(session.substr(begin, end == session.npos ? 0 : end - begin));
}
} // namespace

std::vector<std::string> FileParts(const std::string& path)
{
  std::error_code failure;
  if (!std::filesystem::is_directory(path, failure))
  {
    return { path };
  }
  std::vector<std::string> parts;
  for (const auto& entry : std::filesystem::directory_iterator(path))
  {
    const auto suffix = entry.path().extension();
    if (entry.is_regular_file() &&
      (suffix == ".xml" || suffix == ".fld" || suffix == ".chk" || suffix == ".rst"))
    {
      parts.push_back(entry.path().string());
    }
  }
  if (parts.empty())
  {
    throw InvalidData("the folder '" + path +
      "' holds no parts of a Nektar++ file (P0000000.xml; Info.xml, P0000000.fld, ...); name the "
      "folder that the solver wrote.");
  }
  std::ranges::sort(parts);
  return parts;
}

std::optional<double> FieldTime(const std::string& path)
{
  const std::string head = HeadOf(FileParts(path).front());
  const auto time = NumberBehind(head, "<Time>");
  return time ? time : NumberBehind(head, "PARAM=\"Time\">"); // the latter in Nektar++ 3
}

std::vector<std::string> FieldNames(const std::string& path)
{
  constexpr std::string_view kAttribute = " FIELDS=\"";
  std::vector<std::string> names;
  for (const std::string& part : FileParts(path))
  {
    const std::string head = HeadOf(part);
    const auto at = head.find(kAttribute);
    const auto end = at == head.npos ? at : head.find('"', at + kAttribute.size());
    if (end == head.npos)
    {
      continue; // a folder's Info.xml
    }
    std::string_view list(head.data() + at + kAttribute.size(), end - at - kAttribute.size());
    while (!list.empty())
    {
      const auto comma = std::min(list.find(','), list.size());
      names.emplace_back(WithoutBlanks(list.substr(0, comma)));
      list.remove_prefix(std::min(comma + 1, list.size()));
    }
    break;
  }
  return names;
}

std::vector<std::string> MissingMeshes(const std::vector<NamedText>& sessions)
{
  std::vector<std::string> missing;
  for (const NamedText& session : sessions)
  {
    const std::string name = IsHdf5(session.text) ? std::string() : MeshNamedIn(session.text);
    if (name.empty())
    {
      continue;
    }
    const std::string mesh = fs::path(session.name).replace_filename(name).string();
    const bool named = std::ranges::any_of(sessions,
      [&](const NamedText& other)
      { return fs::path(other.name).filename() == fs::path(name).filename(); });
    std::error_code failure;
    if (!named && fs::is_regular_file(mesh, failure) &&
      std::ranges::find(missing, mesh) == missing.end())
    {
      missing.push_back(mesh);
    }
  }
  return missing;
}
} // namespace pixelexact::nektar
