// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Filters/LoadMesh.h"

#include "Core/Math/Vec.h"

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

namespace pixelexact
{
/// The mesh files of a folder and those in it, in order; a file itself.
inline std::vector<std::filesystem::path> MeshFilesIn(const std::filesystem::path& path)
{
  if (!std::filesystem::is_directory(path))
  {
    return { path };
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path))
  {
    const std::string name = entry.path().filename().string();
    const bool isMesh = std::ranges::any_of(
      std::initializer_list<const char*>{ ".vtu", ".vtk", ".mesh", ".mesh.gz", ".xml", ".saved" },
      [&](const char* suffix) { return name.ends_with(suffix); });
    if (entry.is_regular_file() && isMesh)
    {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

/// The points of all oracles in the folder of a mesh file.
inline std::vector<Vec3> OraclePoints(const std::filesystem::path& file)
{
  const std::string stem = file.stem().string();
  std::vector<Vec3> points;
  for (const auto& entry : std::filesystem::directory_iterator(file.parent_path()))
  {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(".csv") && (name.starts_with("oracle") || name.starts_with(stem + ".")))
    {
      const auto table = testing::ReadTable(entry.path());
      for (std::size_t i = 0; i < table.at("x").size(); ++i)
      {
        points.emplace_back(table.at("x")[i], table.at("y")[i], table.at("z")[i]);
      }
    }
  }
  return points;
}
} // namespace pixelexact
