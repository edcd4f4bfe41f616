// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Text/PieceNames.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <set>

namespace pixelexact::mfem
{
namespace
{
namespace fs = std::filesystem;

constexpr std::size_t kRankDigits = 6;

bool IsRank(const std::string& extension)
{
  return extension.size() == kRankDigits + 1 &&
    std::all_of(
      extension.begin() + 1, extension.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::string NameOf(const std::string& path, int rank)
{
  const std::string digits = std::to_string(rank);
  return fs::path(path)
    .replace_extension(std::string(kRankDigits - digits.size(), '0') + digits)
    .string();
}

/// The numbers of the files in the same folder that differ from `path` only in their number.
std::set<int> RanksBeside(const std::string& path)
{
  const fs::path file(path);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::set<int> ranks;
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator(folder, failure))
  {
    const fs::path other = entry.path().filename();
    const std::string extension = other.extension().string();
    if (other.stem() == file.stem() && IsRank(extension))
    {
      int rank = 0;
      std::from_chars(extension.data() + 1, extension.data() + extension.size(), rank);
      ranks.insert(rank);
    }
  }
  return ranks;
}
} // namespace

bool IsPieceName(const std::string& path)
{
  return IsRank(fs::path(path).extension().string());
}

std::vector<std::string> PiecesOf(const std::string& mesh)
{
  if (!IsPieceName(mesh))
  {
    return { mesh };
  }
  const std::set<int> ranks = RanksBeside(mesh);
  std::vector<std::string> names;
  for (const int rank : ranks)
  {
    if (rank != static_cast<int>(names.size()))
    {
      throw InvalidData(NameOf(mesh, static_cast<int>(names.size())) + " is missing: '" +
        NameOf(mesh, rank) +
        "' is a piece of the same mesh, by its name; copy all of them here, or "
        "give a piece a name without a number to see it alone.");
    }
    names.push_back(NameOf(mesh, rank));
  }
  return names.empty() ? std::vector{ mesh } : names;
}

std::vector<std::string> PiecesOf(
  const std::string& gridFunction, int pieces, const std::string& mesh)
{
  if (pieces == 1)
  {
    return { gridFunction };
  }
  if (!IsPieceName(gridFunction))
  {
    throw InvalidData(gridFunction + ": the mesh " + mesh + " has " + std::to_string(pieces) +
      " pieces; name one of as many of the grid function, such as u.000000.");
  }
  std::vector<std::string> names;
  for (int rank = 0; rank < pieces; ++rank)
  {
    names.push_back(NameOf(gridFunction, rank));
    std::error_code failure;
    if (!fs::exists(names.back(), failure))
    {
      throw InvalidData(names.back() + " is missing; the mesh " + mesh + " has " +
        std::to_string(pieces) + " pieces, and the grid function needs as many.");
    }
  }
  return names;
}

std::string FieldName(const std::string& path)
{
  fs::path file = fs::path(path).filename();
  if (IsRank(file.extension().string()))
  {
    file = file.stem();
    return file.extension() == ".gf" ? file.stem().string() : file.string();
  }
  if (file.extension() == ".gz")
  {
    file = file.stem();
  }
  return file.stem().string();
}
} // namespace pixelexact::mfem
