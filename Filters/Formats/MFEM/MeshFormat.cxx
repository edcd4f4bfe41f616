// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/MeshFormat.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace pixelexact::mfem
{
namespace
{
/// What MFEM writes a rank with, as suffix of a file's name.
constexpr std::size_t kRankDigits = 6;

} // namespace

MeshFormat ReadMeshFormat(TextScanner& scanner)
{
  scanner.Expect("MFEM");
  const std::string_view kind = scanner.Word("the kind of mesh");
  if (kind == "NURBS" || kind == "INLINE")
  {
    scanner.FailUnsupported(std::string(kind) +
      " meshes are not read; load the mesh with MFEM, give it polynomial nodes "
      "(Mesh::SetCurvature) and save that.");
  }
  if (kind == "NC")
  {
    scanner.Expect("mesh");
    const std::string_view version = scanner.Word("the version");
    if (version != "v1.0" && version != "v1.1")
    {
      scanner.FailUnsupported("version " + std::string(version.substr(0, 10)) +
        " of non-conforming meshes is not known; v1.0 and v1.1 are.");
    }
    return version == "v1.1" ? MeshFormat::NonconformingScaled : MeshFormat::Nonconforming;
  }
  if (kind != "mesh")
  {
    scanner.Fail("this is no MFEM mesh; its first line should be 'MFEM mesh v1.0' or alike.");
  }
  const std::string_view version = scanner.Word("the version");
  if (version != "v1.0" && version != "v1.1" && version != "v1.2" && version != "v1.3")
  {
    scanner.FailUnsupported("version " + std::string(version.substr(0, 10)) +
      " of meshes is not known; v1.0 to v1.3 are.");
  }
  return version == "v1.1" ? MeshFormat::Legacy : MeshFormat::Conforming;
}

int ReadDimension(TextScanner& scanner)
{
  const int dimension = scanner.Integer("the dimension");
  if (dimension != 2 && dimension != 3)
  {
    scanner.FailUnsupported("the mesh is " + std::to_string(dimension) +
      "-dimensional; only two- and three-dimensional ones are read.");
  }
  return dimension;
}

int ReadSpaceDimension(TextScanner& scanner, int dimension)
{
  const int space = scanner.Integer("the vertices' dimension");
  if (space < dimension || space > 3)
  {
    scanner.FailUnsupported("the vertices are in " + std::to_string(space) +
      "-dimensional space, the elements are " + std::to_string(dimension) +
      "-dimensional; only meshes in two- and three-dimensional space are read.");
  }
  return space;
}

void RefusePiece(const TextScanner& scanner, const std::string& sign)
{
  scanner.FailUnsupported("this is one piece of a parallel mesh (" + sign +
    "), the rest is in other files; save the whole mesh (ParMesh::PrintAsOne or SaveAsOne, grid "
    "functions with ParGridFunction::SaveAsOne) and read that.");
}

std::string OtherPiece(const std::string& path)
{
  const std::filesystem::path file(path);
  const std::string rank = file.extension().string();
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  if (rank.size() != kRankDigits + 1 || !std::all_of(rank.begin() + 1, rank.end(), isDigit))
  {
    return {};
  }
  std::filesystem::path other = file;
  other.replace_extension(rank == ".000000" ? ".000001" : ".000000");
  std::error_code failure;
  return std::filesystem::exists(other, failure) ? other.string() : std::string();
}
} // namespace pixelexact::mfem
