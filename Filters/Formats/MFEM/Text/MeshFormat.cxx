// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Text/MeshFormat.h"

#include "Core/Base/Error.h"

namespace pixelexact::mfem
{
namespace
{
MeshFormat ReadNurbsVersion(TextScanner& scanner)
{
  if (scanner.Peek() == "NC-patch")
  {
    scanner.FailUnsupported(
      "NURBS meshes whose patches do not conform (NC-patch) are not read; load the mesh with MFEM "
      "and save it as Lagrange cells (Mesh::PrintVTU with high_order_output).");
  }
  scanner.Expect("mesh");
  const std::string_view version = scanner.Word("the version");
  if (version != "v1.0" && version != "v1.1")
  {
    scanner.FailUnsupported("version " + std::string(version.substr(0, 10)) +
      " of NURBS meshes is not known; v1.0 and v1.1 are.");
  }
  return version == "v1.1" ? MeshFormat::NurbsSpaced : MeshFormat::Nurbs;
}

/// Other formats that MFEM, too, takes under its own suffix.
void RefuseOthers(TextScanner& scanner)
{
  constexpr const char* kConvert =
    " mesh, which is not read; save it in MFEM's format (Mesh(\"a.mesh\").Save(\"b.mesh\")).";
  const std::string_view first = scanner.Peek();
  if (first == "$MeshFormat")
  {
    scanner.FailUnsupported("this is a Gmsh mesh; give the file the suffix .msh.");
  }
  if (first == "areamesh2" || first == "curved_areamesh2" || first == "NETGEN" ||
    first == "NETGEN_Neutral_Format")
  {
    scanner.FailUnsupported("this is a Netgen" + std::string(kConvert));
  }
  if (first.starts_with("MeshVersionFormatted"))
  {
    scanner.FailUnsupported("this is a Medit mesh (as of Gmsh's and MMG's .mesh files), which is "
                            "not read; convert it: gmsh FILE.mesh -save -format msh41 -o NEW.msh.");
  }
  if (first == "TrueGrid")
  {
    scanner.FailUnsupported("this is a TrueGrid" + std::string(kConvert));
  }
}
} // namespace

MeshFormat ReadMeshFormat(TextScanner& scanner)
{
  RefuseOthers(scanner);
  scanner.Expect("MFEM");
  const std::string_view kind = scanner.Word("the kind of mesh");
  if (kind == "INLINE")
  {
    scanner.Expect("mesh");
    if (scanner.Word("the version") != "v1.0")
    {
      scanner.FailUnsupported("of INLINE meshes only version v1.0 is read.");
    }
    return MeshFormat::Inline;
  }
  if (kind == "NURBS")
  {
    return ReadNurbsVersion(scanner);
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

void RefusePiece(const TextScanner& scanner, int processes, int pieces)
{
  throw InvalidData(scanner.Name() + ": this is one piece of the mesh of a parallel run of " +
    std::to_string(processes) + " processes at least, but " +
    (pieces == 1 ? std::string("no other piece is") : std::to_string(pieces) + " pieces are") +
    " beside it; have all of them in one folder, named x.000000, x.000001, ... (ParMesh::Save), or "
    "save the whole mesh (ParMesh::PrintAsOne or SaveAsOne, grid functions with "
    "ParGridFunction::SaveAsOne).");
}
} // namespace pixelexact::mfem
