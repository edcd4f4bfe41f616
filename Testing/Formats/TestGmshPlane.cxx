// SPDX-License-Identifier: BSD-3-Clause
#include "GmshTexts.h"
#include "SolverModelViews.h"

#include "Formats/FileText.h"
#include "Formats/Gmsh/ElementType.h"
#include "Formats/Gmsh/MeshPieces.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace pixelexact::testing
{
namespace
{
/// Places in an element of a slab, in its middle plane.
std::vector<Vec3> PlaneXi(Shape shape)
{
  std::vector<Vec3> points;
  for (const double a : { -0.9, -0.35, 0.2, 0.75 })
  {
    for (const double b : { -0.8, -0.1, 0.6 })
    {
      if (shape == Shape::Hexahedron)
      {
        points.emplace_back(a, b, 0.0);
      }
      else if (a + b <= 0.0)
      {
        points.emplace_back(a, 0.0, b);
      }
    }
  }
  return points;
}

Shape ShapeOf(const SolverModel& model, int element)
{
  return model.mesh.map.spaces[static_cast<std::size_t>(model.mesh.map.spaceOf[element])].shape;
}

/// A sheared element of a type, its nodes by the lattice, with a view of `function`.
template <class Function>
std::string OneElement(int type, bool triangle, int order, int nodes, Function&& function)
{
  const auto lattice = gmsh::PlaneOrder(triangle, order);
  std::string places = "$Nodes\n" + std::to_string(nodes) + "\n";
  std::string element = "$Elements\n1\n1 " + std::to_string(type) + " 2 0 1";
  std::string values;
  for (int i = 0; i < nodes; ++i)
  {
    const double u = static_cast<double>(lattice[static_cast<std::size_t>(i)][0]) / order;
    const double v = static_cast<double>(lattice[static_cast<std::size_t>(i)][1]) / order;
    const double x = 1.0 + 2.0 * u + 0.5 * v;
    const double y = -0.25 * u + v;
    std::ostringstream line;
    line.precision(17);
    line << i + 1 << " " << x << " " << y << " 3\n";
    places += line.str();
    element += " " + std::to_string(i + 1);
    line.str("");
    line << i + 1 << " " << function(x, y) << "\n";
    values += line.str();
  }
  return std::string(kFormat22) + places + "$EndNodes\n" + element + "\n$EndElements\n" +
    View("NodeData", "u", 0.0, 0, 1, nodes, values);
}

template <class Function>
void ExpectValues(const SolverModel& model, Function&& function, double tolerance)
{
  for (int e = 0; e < static_cast<int>(model.mesh.number.size()); ++e)
  {
    for (const Vec3& xi : PlaneXi(ShapeOf(model, e)))
    {
      const Vec3 x = PointAt(model, e, xi);
      EXPECT_NEAR(ValueAt(model, 0, e, xi)[0], function(x.x, x.y), tolerance);
    }
  }
}
} // namespace

TEST(GmshPlane, EveryOrderHoldsItsPolynomials)
{
  constexpr std::array kTriangles{ 2, 9, 21, 23, 25, 42, 43, 44, 45, 46 };
  constexpr std::array kSquares{ 3, 10, 36, 37, 38, 47, 48, 49, 50, 51 };
  for (int order = 1; order <= 10; ++order)
  {
    const auto power = [order](double x, double y) { return std::pow(0.4 * x - 0.3 * y, order); };
    for (const bool triangle : { true, false })
    {
      const int type = (triangle ? kTriangles : kSquares)[static_cast<std::size_t>(order - 1)];
      const int n = order + 1;
      const int nodes = triangle ? n * (n + 1) / 2 : n * n;
      const SolverModel model = ReadGmsh(OneElement(type, triangle, order, nodes, power));
      ASSERT_TRUE(model.mesh.slab);
      EXPECT_EQ(model.mesh.slab->middle, 3.0);
      ExpectValues(model, power, 1e-11);
    }
  }
}

TEST(GmshPlane, IncompleteQuadrilateralsHoldWhatIsLinearInOneDirection)
{
  constexpr std::array kTypes{ 16, 39, 40, 41, 57, 58, 59, 60, 61 };
  for (int order = 2; order <= 10; ++order)
  {
    // The value along u, whose direction is (2, -0.25).
    const auto power = [order](double x, double y)
    { return std::pow(((x - 1.0) - 0.5 * y) / 2.125, order); };
    const SolverModel model = ReadGmsh(
      OneElement(kTypes[static_cast<std::size_t>(order - 2)], false, order, 4 * order, power));
    ExpectValues(model, power, 1e-11);
  }
  ExpectParts(GmshMessage(OneElement(20, true, 3, 9, [](double x, double) { return x; })),
    { "triangles of order 3 with 9 nodes", "no nodes inside", "setOrder" });
}

TEST(GmshPlane, GmshsOwnNodesAreWhereTheyShouldBe)
{
  const std::string path = PIXELEXACT_DATA_DIR "/gmsh_plane_g6/gmsh_plane_g6.msh";
  const SolverModel model = ReadGmsh(ReadFileText(path));
  ASSERT_EQ(model.mesh.number.size(), 2U);
  // Both elements are straight, and Gmsh's nodes good to 1e-12.
  for (int e = 0; e < 2; ++e)
  {
    const bool triangle = ShapeOf(model, e) == Shape::Prism;
    const auto at = [&](double a, double b)
    { return PointAt(model, e, triangle ? Vec3(a, 0, b) : Vec3(a, b, 0)); };
    const Vec3 origin = at(-1, -1);
    for (const Vec3& xi : PlaneXi(ShapeOf(model, e)))
    {
      const double a = (1 + xi.x) / 2;
      const double b = (1 + (triangle ? xi.z : xi.y)) / 2;
      const Vec3 expected = origin + a * (at(1, -1) - origin) + b * (at(-1, 1) - origin);
      const Vec3 x = PointAt(model, e, xi);
      EXPECT_NEAR(x.x, expected.x, 2e-12);
      EXPECT_NEAR(x.y, expected.y, 2e-12);
    }
  }
  ExpectValues(
    model, [](double x, double y) { return x * x * x - 2 * x * y * y + y; }, 2e-11);
  // Sides by number, elements by number: the quadrilateral is the second.
  ASSERT_EQ(model.mesh.boundary.size(), 2U);
  for (const BoundaryFace& side : model.mesh.boundary)
  {
    EXPECT_EQ(side.attribute, ShapeOf(model, side.element) == Shape::Prism ? 6 : 5);
    EXPECT_EQ(side.face, ShapeOf(model, side.element) == Shape::Prism ? 3 : 0);
  }
}

TEST(GmshPlane, SchemesOfPlaneShapes)
{
  // u = a + b u + c v + d u v on the triangle: of order 2.
  const std::string scheme = "$InterpolationScheme\n\"s\"\n1\n3\n2\n4 4\n1 0 0 0\n0 1 0 0\n"
                             "0 0 1 0\n0 0 0 1\n4 2\n0 0\n1 0\n0 1\n1 1\n$EndInterpolationScheme\n";
  const std::string mesh = std::string(kFormat22) +
    "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n$Elements\n1\n1 2 2 0 1 1 2 3\n"
    "$EndElements\n";
  const std::string view = "$ElementNodeData\n2\n\"u\"\n\"s\"\n1\n0\n3\n0\n1\n1\n"
                           "1 4 0.5 2 -3 4\n$EndElementNodeData\n";
  const SolverModel model = ReadGmsh(mesh + scheme + view);
  ASSERT_EQ(model.fields.size(), 1U);
  ExpectValues(
    model, [](double x, double y) { return 0.5 + 2 * x - 3 * y + 4 * x * y; }, 1e-14);
}

TEST(GmshPlane, SurfacesInSpaceHaveANote)
{
  const SolverModel model = ReadGmsh(std::string(kFormat22) +
    "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 1\n$EndNodes\n$Elements\n1\n"
    "1 2 2 0 1 1 2 3\n$EndElements\n");
  ASSERT_TRUE(model.mesh.slab.has_value());
  EXPECT_TRUE(model.mesh.slab->inSpace);
  ASSERT_EQ(model.notes.size(), 1U);
  ExpectParts(model.notes[0], { "surface in space", "gmsh -3" });
}

TEST(GmshPieces, AreTheMeshInOneFile)
{
  const std::string folder = PIXELEXACT_DATA_DIR "/gmsh_split_tet_g2/gmsh_split_tet_g2";
  const std::vector<std::string> pieces = gmsh::PiecesOf(folder + "_2.msh");
  EXPECT_EQ(pieces, (std::vector{ folder + "_1.msh", folder + "_2.msh" }));
  const std::vector<std::string> whole{ folder + "_whole.msh" };
  EXPECT_EQ(gmsh::PiecesOf(whole[0]), whole);
  const auto read = [](const std::vector<std::string>& files)
  {
    std::vector<std::string> texts;
    std::ranges::transform(files, std::back_inserter(texts), ReadFileText);
    std::vector<NamedText> named;
    for (std::size_t i = 0; i < files.size(); ++i)
    {
      named.push_back({ files[i], texts[i] });
    }
    return gmsh::Read(named, 0, true, files.size());
  };
  const SolverModel parts = read(pieces);
  const SolverModel one = read(whole);
  EXPECT_TRUE(parts.notes.empty());
  EXPECT_EQ(parts.mesh.boundary.size(), one.mesh.boundary.size());
  EXPECT_EQ(parts.mesh.groups.size(), one.mesh.groups.size());
  ASSERT_EQ(parts.mesh.number.size(), one.mesh.number.size());
  for (int e = 0; e < static_cast<int>(one.mesh.number.size()); ++e)
  {
    const auto at = std::ranges::find(parts.mesh.number, one.mesh.number[e]);
    ASSERT_NE(at, parts.mesh.number.end());
    const auto other = static_cast<int>(at - parts.mesh.number.begin());
    const Vec3 xi(-0.4, -0.7, -0.6);
    EXPECT_EQ(PointAt(parts, other, xi), PointAt(one, e, xi));
  }
}

TEST(GmshPieces, MissingOnesAndThoseOfAnotherMeshAreRefused)
{
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(::testing::TempDir()) / "pixelexact-gmsh-pieces";
  fs::create_directories(folder);
  const std::string source = PIXELEXACT_DATA_DIR "/gmsh_split_tet_g2/gmsh_split_tet_g2_";
  const std::string first = (folder / "a_1.msh").string();
  const std::string second = (folder / "a_2.msh").string();
  fs::remove(first);
  fs::copy_file(source + "2.msh", second, fs::copy_options::overwrite_existing);
  try
  {
    gmsh::PiecesOf(second);
    ADD_FAILURE();
  }
  catch (const InvalidData& error)
  {
    ExpectParts(error.what(), { "a_1.msh is missing", "2 partitions" });
  }
  const std::string text = ReadFileText(source + "1.msh");
  std::string moved = ReadFileText(source + "2.msh");
  // Node 1's place, in one of the two.
  const auto read = [&](const std::string& a, const std::string& b) {
    return gmsh::Read({ { first, a }, { second, b } }, 0, true, 2);
  };
  EXPECT_NO_THROW(read(text, moved));
  EXPECT_THROW(read(text, text), InvalidData); // each element twice
  const auto nodes = moved.find("$Nodes");
  const auto place = moved.find("0.", nodes);
  moved[place] = '7';
  EXPECT_THROW(read(text, moved), InvalidData);
  fs::remove_all(folder);
}

TEST(GmshPieces, NumbersInNamesAloneMakeNoPieces)
{
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(::testing::TempDir()) / "pixelexact-gmsh-names";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const auto write = [&](int number, const std::string& tags)
  {
    const std::string path = (folder / ("m_" + std::to_string(number) + ".msh")).string();
    std::ofstream(path) << kFormat22 << kNodes22 << "$Elements\n1\n11 4 " << tags
                        << " 1 2 3 4\n$EndElements\n";
    return path;
  };
  const std::string second = write(2, "4 0 1 1 2");
  EXPECT_EQ(gmsh::PiecesOf(second), std::vector{ second });
  // A series of whole meshes: without partitions, or all of the same one.
  const std::string first = write(1, "2 0 1");
  EXPECT_EQ(gmsh::PiecesOf(second), std::vector{ second });
  EXPECT_EQ(gmsh::PiecesOf(first), std::vector{ first });
  write(1, "4 0 1 1 2");
  EXPECT_EQ(gmsh::PiecesOf(second), std::vector{ second });
  EXPECT_EQ(gmsh::PiecesOf(first), std::vector{ first });
  std::ofstream(first) << "no mesh";
  EXPECT_EQ(gmsh::PiecesOf(second), std::vector{ second });
  // Each holds the partition that its name counts.
  write(1, "4 0 1 1 1");
  EXPECT_EQ(gmsh::PiecesOf(second), (std::vector{ first, second }));
  const std::string fourth = write(4, "4 0 1 1 4");
  EXPECT_EQ(gmsh::PiecesOf(second), (std::vector{ first, second }));
  EXPECT_THROW(gmsh::PiecesOf(fourth), InvalidData); // the third is missing
  fs::remove_all(folder);
}

TEST(GmshPieces, PartsOfAViewStandInTheirFiles)
{
  // Both files have the same partition number, as when each piece is written separately.
  const std::string left = std::string(kFormat22) +
    "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n$Elements\n1\n"
    "1 4 4 0 1 1 1 1 2 3 4\n$EndElements\n" +
    View("NodeData", "u", 0.0, 0, 1, 4, "1 0\n2 1\n3 2\n4 3\n");
  const std::string right = std::string(kFormat22) +
    "$Nodes\n4\n5 1 1 1\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n$Elements\n1\n"
    "2 4 4 0 1 1 2 5 2 3 4\n$EndElements\n" +
    View("NodeData", "u", 0.0, 0, 1, 4, "5 6\n2 1\n3 2\n4 3\n");
  const SolverModel model = gmsh::Read({ { "a_1.msh", left }, { "a_2.msh", right } }, 0, true, 2);
  ASSERT_EQ(model.fields.size(), 1U);
  for (int e = 0; e < 2; ++e)
  {
    const Vec3 xi(-0.5, -0.6, -0.7);
    const Vec3 x = PointAt(model, e, xi);
    EXPECT_NEAR(ValueAt(model, 0, e, xi)[0], x.x + 2 * x.y + 3 * x.z, 1e-14);
  }
}
} // namespace pixelexact::testing
