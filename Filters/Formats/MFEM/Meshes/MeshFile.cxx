// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Meshes/MeshFile.h"

#include "Core/Base/Error.h"

namespace pixelexact::mfem
{
namespace
{
using Edge = std::array<int, 2>;
constexpr auto kTriangle = Geometry::Triangle;
constexpr auto kSquare = Geometry::Square;

constexpr std::array<Edge, 3> kTriangleEdges{ Edge{ 0, 1 }, { 1, 2 }, { 2, 0 } };
constexpr std::array<std::int8_t, 3> kTriangleSides{ 2, 3, 4 };
constexpr std::array<Edge, 4> kSquareEdges{ Edge{ 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } };
constexpr std::array<std::int8_t, 4> kSquareSides{ 2, 1, 3, 0 };

constexpr std::array<Edge, 6> kTetrahedronEdges{ Edge{ 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 },
  { 1, 3 }, { 2, 3 } };
constexpr std::array<LocalFace, 4> kTetrahedronFaces{ LocalFace{ kTriangle, { 1, 2, 3, -1 }, 1 },
  { kTriangle, { 0, 3, 2, -1 }, 2 }, { kTriangle, { 0, 1, 3, -1 }, 0 },
  { kTriangle, { 0, 2, 1, -1 }, 3 } };

constexpr std::array<Edge, 12> kCubeEdges{ Edge{ 0, 1 }, { 1, 2 }, { 3, 2 }, { 0, 3 }, { 4, 5 },
  { 5, 6 }, { 7, 6 }, { 4, 7 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };
constexpr std::array<LocalFace, 6> kCubeFaces{ LocalFace{ kSquare, { 3, 2, 1, 0 }, 4 },
  { kSquare, { 0, 1, 5, 4 }, 2 }, { kSquare, { 1, 2, 6, 5 }, 1 }, { kSquare, { 2, 3, 7, 6 }, 3 },
  { kSquare, { 3, 0, 4, 7 }, 0 }, { kSquare, { 4, 5, 6, 7 }, 5 } };

constexpr std::array<Edge, 9> kPrismEdges{ Edge{ 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 5 },
  { 5, 3 }, { 0, 3 }, { 1, 4 }, { 2, 5 } };
constexpr std::array<LocalFace, 5> kPrismFaces{ LocalFace{ kTriangle, { 0, 2, 1, -1 }, 0 },
  { kTriangle, { 3, 4, 5, -1 }, 1 }, { kSquare, { 0, 1, 4, 3 }, 2 }, { kSquare, { 1, 2, 5, 4 }, 3 },
  { kSquare, { 2, 0, 3, 5 }, 4 } };

constexpr std::array<Edge, 8> kPyramidEdges{ Edge{ 0, 1 }, { 1, 2 }, { 3, 2 }, { 0, 3 }, { 0, 4 },
  { 1, 4 }, { 2, 4 }, { 3, 4 } };
constexpr std::array<LocalFace, 5> kPyramidFaces{ LocalFace{ kSquare, { 3, 2, 1, 0 }, 0 },
  { kTriangle, { 0, 1, 4, -1 }, 1 }, { kTriangle, { 1, 2, 4, -1 }, 2 },
  { kTriangle, { 2, 3, 4, -1 }, 3 }, { kTriangle, { 3, 0, 4, -1 }, 4 } };

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
  if (first == "FiniteElementSpace" || first == "QuadratureSpace" ||
    first.ends_with("GridFunction"))
  {
    scanner.Fail(
      "this is a grid function, without its mesh; name the mesh before it (x.mesh u.gf).");
  }
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

bool IsOfDimension(Geometry geometry, int dimension)
{
  switch (geometry)
  {
    case Geometry::Point:
      return dimension == 0;
    case Geometry::Segment:
      return dimension == 1;
    case Geometry::Triangle:
    case Geometry::Square:
      return dimension == 2;
    default:
      return dimension == 3;
  }
}

Cell ReadCell(TextScanner& scanner, int vertices, int dimension)
{
  static constexpr std::array kKinds{ " is no edge's: those of a plane mesh are segments (1).",
    " is no face's: faces and plane elements are triangles (2) or squares (3).",
    " is no solid's: elements are tetrahedra (4), cubes (5), prisms (6) or pyramids (7)." };
  Cell cell;
  cell.attribute = scanner.Integer("an attribute");
  const int geometry = scanner.Integer("an element's geometry type", 0, 7);
  cell.geometry = static_cast<Geometry>(geometry);
  if (!IsOfDimension(cell.geometry, dimension))
  {
    scanner.Fail("geometry type " + std::to_string(geometry) +
      kKinds.at(static_cast<std::size_t>(dimension - 1)));
  }
  for (int& v : std::span(cell.vertices).first(TableOf(cell.geometry).vertices))
  {
    v = scanner.Integer("a vertex", 0, vertices - 1);
  }
  return cell;
}

const GeometryTable& TableOf(Geometry geometry)
{
  static const GeometryTable segment{ 2, {}, {} };
  static const GeometryTable triangle{ 3, kTriangleEdges, {}, kTriangleSides };
  static const GeometryTable square{ 4, kSquareEdges, {}, kSquareSides };
  static const GeometryTable tetrahedron{ 4, kTetrahedronEdges, kTetrahedronFaces };
  static const GeometryTable cube{ 8, kCubeEdges, kCubeFaces };
  static const GeometryTable prism{ 6, kPrismEdges, kPrismFaces };
  static const GeometryTable pyramid{ 5, kPyramidEdges, kPyramidFaces };
  switch (geometry)
  {
    case Geometry::Segment:
      return segment;
    case Geometry::Triangle:
      return triangle;
    case Geometry::Square:
      return square;
    case Geometry::Tetrahedron:
      return tetrahedron;
    case Geometry::Cube:
      return cube;
    case Geometry::Prism:
      return prism;
    case Geometry::Pyramid:
      return pyramid;
    default:
      throw Error("points have no table.");
  }
}

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
      "-dimensional; only two- and three-dimensional ones are read. Curves: save them with "
      "Mesh::PrintVTU and make tubes of them (in ParaView: Extract Surface, Tube, Triangulate, "
      "Append Datasets).");
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
