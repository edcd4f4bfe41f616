// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Files/Hdf5Meshes.h"

#include "Formats/Hdf5/Hdf5File.h"

#include <algorithm>
#include <filesystem>

namespace pixelexact::nektar
{
namespace
{
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
