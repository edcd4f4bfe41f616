// SPDX-License-Identifier: BSD-3-Clause
#include "MfemTexts.h"

#include "Formats/MFEM/Meshes/RefinementTree.h"
#include "Formats/MFEM/Reader.h"

#include <gtest/gtest.h>

#include <set>

namespace pixelexact::testing
{
namespace
{
using namespace mfemtexts;

/// A unit cube's vertices in MFEM's order, as text.
constexpr const char* kCubeVertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n";

std::string OneCube(const std::string& attributes = "7")
{
  return "MFEM mesh v1.0\r\n# a comment\n\ndimension\n3\n\nelements\n1\n" + attributes +
    " 5 0 1 2 3 4 5 6 7\n\nboundary\n1\n3 3 1 2 6 5\n\nvertices\n8\n3\n" + kCubeVertices;
}

std::string MakeFieldText(
  const std::string& collection, int vdim, int ordering, const std::string& values)
{
  return "FiniteElementSpace\nFiniteElementCollection: " + collection +
    "\nVDim: " + std::to_string(vdim) + "\nOrdering: " + std::to_string(ordering) + "\n\n" + values;
}
} // namespace

TEST(MfemReader, StraightCubeWithAttributesAndBoundary)
{
  const SolverModel model = ReadTexts(OneCube());
  const Vec3 x = PointAt(model, 0, { -0.5, 0.0, 0.75 });
  EXPECT_NEAR(x.x, 0.25, 1e-16);
  EXPECT_NEAR(x.y, 0.5, 1e-16);
  EXPECT_NEAR(x.z, 0.875, 1e-16);
  EXPECT_EQ(model.mesh.attribute.at(0), 7);
  ASSERT_EQ(model.mesh.boundary.size(), 1U);
  EXPECT_EQ(model.mesh.boundary[0].attribute, 3);
  EXPECT_EQ(model.mesh.boundary[0].face, 1); // x = 1 is VTK's second face
}

TEST(MfemReader, BothOrderingsOfAVectorField)
{
  // f = (x + 2 y, z) at the vertices.
  const double corners[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  std::string first;
  std::string second;
  std::string interleaved;
  for (const auto& c : corners)
  {
    const std::string a = std::to_string(c[0] + 2 * c[1]) + "\n";
    const std::string b = std::to_string(c[2]) + "\n";
    first += a;
    second += b;
    interleaved += a + b;
  }
  const SolverModel model = ReadTexts(OneCube(),
    { MakeFieldText("H1_3D_P1", 2, 0, first + second),
      MakeFieldText("Linear", 2, 1, interleaved) });
  for (std::size_t f = 0; f < 2; ++f)
  {
    const auto value = ValueAt(model, f, 0, { 0.2, -0.4, 0.6 });
    EXPECT_NEAR(value[0], 0.6 + 2 * 0.3, 1e-15);
    EXPECT_NEAR(value[1], 0.8, 1e-15);
  }
  EXPECT_EQ(model.fields[0].name, "u");
  EXPECT_TRUE(model.fields[0].continuous);
}

TEST(MfemReader, ComplexGridFunctionsAreTwo)
{
  // At the vertices x + 2 y + i z, and a vector of this and three times this.
  const double corners[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  std::string parts[2];
  std::string vectors[2];
  for (const auto& c : corners)
  {
    const double values[2] = { c[0] + 2 * c[1], c[2] };
    for (int part = 0; part < 2; ++part)
    {
      parts[part] += std::to_string(values[part]) + " ";
      vectors[part] += std::to_string(values[part]) + " " + std::to_string(3 * values[part]) + " ";
    }
  }
  const std::string scalar =
    "ComplexGridFunction\n" + MakeFieldText("H1_3D_P1", 1, 0, parts[0] + parts[1]);
  const std::string vector =
    "ParComplexGridFunction\n" + MakeFieldText("H1_3D_P1", 2, 1, vectors[0] + vectors[1]);
  const SolverModel model = ReadTexts(OneCube(), { scalar, vector });
  ASSERT_EQ(model.fields.size(), 4U);
  EXPECT_EQ(model.fields[0].name, "u_real");
  EXPECT_EQ(model.fields[1].name, "u_imag");
  const Vec3 xi(0.2, -0.4, 0.6);
  EXPECT_NEAR(ValueAt(model, 0, 0, xi)[0], 1.2, 1e-15);
  EXPECT_NEAR(ValueAt(model, 1, 0, xi)[0], 0.8, 1e-15);
  EXPECT_NEAR(ValueAt(model, 2, 0, xi)[1], 3.6, 2e-15);
  EXPECT_NEAR(ValueAt(model, 3, 0, xi)[1], 2.4, 2e-15);
  ExpectMessage(Message(OneCube(),
                  { "ComplexGridFunction\n" + MakeFieldText("H1_3D_P1", 1, 0, parts[0] + "1") }),
    { "u.gf", "9 numbers", "imaginary" });
  ExpectMessage(
    Message(OneCube(), { "ComplexGridFunction\n" + MakeFieldText("H1_3D_P1", 1, 0, parts[0]) }),
    { "u.gf", "4" });
}

TEST(MfemReader, UnusedVerticesAreDroppedAsMfemDoes)
{
  const std::string mesh = "MFEM mesh v1.0\ndimension\n3\nelements\n1\n1 4 0 2 3 4\nboundary\n0\n"
                           "vertices\n5\n3\n0 0 0\n9 9 9\n1 0 0\n0 1 0\n0 0 1\n";
  const SolverModel model = ReadTexts(mesh, { MakeFieldText("H1_3D_P1", 1, 0, "1 2 3 4") });
  EXPECT_NEAR(PointAt(model, 0, { 1, -1, -1 }).x, 1.0, 1e-16);
  EXPECT_NEAR(ValueAt(model, 0, 0, { 1, -1, -1 })[0], 2.0, 1e-15);
}

TEST(MfemReader, RefinedCubeWithoutNodes)
{
  // One cube divided along x: vertices 8 to 11 are on the edges in x.
  const std::string mesh =
    std::string("MFEM NC mesh v1.0\ndimension\n3\nelements\n3\n-1 1 5 1 1 2\n"
                "0 1 5 0 0 8 9 3 4 10 11 7\n0 2 5 0 8 1 2 9 10 5 6 11\n"
                "boundary\n1\n4 3 8 1 2 9\nvertex_parents\n4\n8 0 1\n9 2 3\n10 4 5\n11 6 7\n"
                "coordinates\n8\n3\n") +
    kCubeVertices;
  const SolverModel model = ReadTexts(mesh);
  ASSERT_EQ(model.mesh.number.size(), 2U);
  EXPECT_NEAR(PointAt(model, 1, { 0, 0, 0 }).x, 0.75, 1e-16);
  EXPECT_EQ(model.mesh.attribute[1], 2);
  ASSERT_EQ(model.mesh.boundary.size(), 1U);
  EXPECT_EQ(model.mesh.boundary[0].element, 1);
}

/// A boundary element between two elements belongs to both. In a periodic mesh they are at its two
/// ends, and the file does not distinguish them.
TEST(MfemReader, BoundaryElementsBetweenElementsAreListedOnBothSides)
{
  const std::string mesh = "MFEM mesh v1.0\ndimension\n3\nelements\n2\n1 5 0 1 2 3 4 5 6 7\n"
                           "1 5 4 5 6 7 8 9 10 11\nboundary\n3\n5 3 4 5 6 7\n6 3 7 6 5 4\n"
                           "2 3 8 9 10 11\nvertices\n12\n3\n" +
    std::string(kCubeVertices) + "0 0 2\n1 0 2\n1 1 2\n0 1 2\n";
  const SolverModel model = ReadTexts(mesh);
  std::multiset<std::array<int, 3>> found;
  for (const auto& face : model.mesh.boundary)
  {
    found.insert({ face.element, face.face, face.attribute });
  }
  // VTK's faces 4 and 5 are z = 0 and z = 1.
  EXPECT_EQ(found,
    (std::multiset<std::array<int, 3>>{
      { 0, 5, 5 }, { 1, 4, 5 }, { 0, 5, 6 }, { 1, 4, 6 }, { 1, 5, 2 } }));
}

TEST(MfemReader, HilbertCurveVisitsNeighboursOneAfterTheOther)
{
  const int x[8] = { 0, 1, 1, 0, 0, 1, 1, 0 };
  const int y[8] = { 0, 0, 1, 1, 0, 0, 1, 1 };
  const int z[8] = { 0, 0, 0, 0, 1, 1, 1, 1 };
  std::set<std::array<int, 8>> states;
  for (int s = 0; s < 24; ++s)
  {
    const auto& state = mfem::HilbertCurve(s);
    states.insert(state.child);
    for (int i = 0; i < 7; ++i)
    {
      const int a = state.child[i];
      const int b = state.child[i + 1];
      EXPECT_EQ(std::abs(x[a] - x[b]) + std::abs(y[a] - y[b]) + std::abs(z[a] - z[b]), 1);
      // The curve leaves a child next to where it enters the following one.
      const int out = mfem::HilbertCurve(state.state[i]).child[7];
      const int in = mfem::HilbertCurve(state.state[i + 1]).child[0];
      EXPECT_EQ(std::abs(2 * (x[a] - x[b]) + x[out] - x[in]) +
          std::abs(2 * (y[a] - y[b]) + y[out] - y[in]) +
          std::abs(2 * (z[a] - z[b]) + z[out] - z[in]),
        1);
    }
  }
  EXPECT_EQ(states.size(), 24U);
}

TEST(MfemReader, StreamsEndWithCommands)
{
  const std::string text = "solution\n" + OneCube() + "\n" +
    MakeFieldText("L2_3D_P0", 1, 0, "42\n") + "keys maaaa\nautopause on\n";
  const SolverModel model = mfem::ReadStream({ "a.saved", text });
  EXPECT_EQ(model.fields.at(0).name, "solution");
  EXPECT_EQ(ValueAt(model, 0, 0, { 0, 0, 0 })[0], 42.0);
  EXPECT_FALSE(model.fields[0].continuous);
}

TEST(MfemReader, AttributeSetsAreGroups)
{
  std::string mesh = OneCube();
  mesh.replace(mesh.find("v1.0"), 4, "v1.3");
  mesh.insert(mesh.find("boundary"), "attribute_sets\n1\n\"the rod\"\n2\n7 8\n\n");
  mesh.insert(mesh.find("vertices"), "bdr_attribute_sets\n1\nend\n1\n3\n\n");
  mesh += "\nmfem_mesh_end\n";
  const SolverModel model = ReadTexts(mesh);
  ASSERT_EQ(model.mesh.groups.size(), 3U);
  EXPECT_EQ(model.mesh.groups[0].name, "the rod");
  EXPECT_EQ(model.mesh.groups[1].id, 8);
  EXPECT_TRUE(model.mesh.groups[2].boundary);
}

TEST(MfemReader, PiecesOfParallelMeshesAreRefused)
{
  // A piece as ParMesh::ParPrint writes it, with the groups of shared entities after it.
  std::string piece = OneCube();
  piece.replace(piece.find("v1.0"), 4, "v1.2");
  const std::string serial = piece;
  const std::string groups =
    "communication_groups\nnumber_of_groups 2\n\n# number of entities in each group, followed by "
    "ranks in group\n1 0\n2 0 1\n\ntotal_shared_vertices 4\ntotal_shared_edges 4\n"
    "total_shared_faces 1\n";
  piece += "\nmfem_serial_mesh_end\n\n" + groups + "\nmfem_mesh_end\n";
  ExpectMessage(Message(piece), { "a.mesh", "one piece", "2 processes", "x.000001", "PrintAsOne" });
  // A piece with nodes, whose numbers end where the groups begin.
  std::string curved = piece;
  curved.replace(curved.find("vertices\n8\n3\n") + 11, std::string(kCubeVertices).size() + 2,
    "nodes\n" + MakeFieldText("H1_3D_P1", 3, 1, kCubeVertices));
  ExpectMessage(Message(curved), { "one piece", "SaveAsOne" });
  ExpectMessage(Message(serial + "\n" + groups), { "one piece" });
  const std::string stream = "mesh\n" + piece;
  EXPECT_THROW(mfem::ReadStream({ "a.saved", stream }), InvalidData);
  // A piece of a refined mesh, of another rank than the first.
  ExpectMessage(
    Message("MFEM NC mesh v1.0\ndimension\n3\nrank 1\nelements\n1\n1 1 5 0 0 1 2 3 4 5 6 7\n"
            "coordinates\n8\n3\n" +
      std::string(kCubeVertices)),
    { "one piece", "SaveAsOne" });
  // A run of one process has it all.
  std::string alone = piece;
  alone.replace(alone.find("2 0 1\n"), 6, "1 0\n");
  EXPECT_EQ(Message(alone), "");
  ExpectMessage(Message(serial + "\nmfem_serial_mesh_end\n" + groups + "shared_vertices 1\nx\n"),
    { "'x'", "processes share" });
  // The whole as the same version has it.
  EXPECT_EQ(Message(serial + "\nmfem_mesh_end\n"), "");
}

TEST(MfemReader, NothingBehindTheDataIsPassedOver)
{
  ExpectMessage(Message(OneCube() + "2 2 2\n"), { "a.mesh, line", "'2'", "behind the end" });
  ExpectMessage(Message(OneCube() + "\nmfem_mesh_end\n0 1 2\n"), { "'0'", "behind the end" });
  ExpectMessage(Message(OneCube() + "\nsomething\n"), { "'something'" });
  ExpectMessage(
    Message(OneCube(), { MakeFieldText("L2_3D_P0", 1, 0, "1\nmore\n") }), { "u.gf", "'more'" });

  const auto message = [](const std::string& text)
  {
    try
    {
      mfem::ReadStream({ "a.saved", text });
    }
    catch (const Error& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string first =
    "solution\n" + OneCube() + "\n" + MakeFieldText("L2_3D_P0", 1, 0, "42\n");
  // A title may speak of meshes.
  EXPECT_EQ(message(first + "window_title 'MFEM mesh v1.0 of a solution'\nkeys aa\n"), "");
  ExpectMessage(message(first + "pause\n" + first), { "a.saved", "another mesh" });
  ExpectMessage(message("mesh\n" + OneCube() + "1 1 1\n"), { "a.saved", "number" });
}

TEST(MfemReader, NumbersAreReadWhole)
{
  const auto field = [](const std::string& number)
  { return Message(OneCube(), { MakeFieldText("L2_3D_P0", 1, 0, number) }); };
  for (const char* sound : { "1", "-1", "+1", "1e3", "+1.5E-3", ".5", "5." })
  {
    EXPECT_EQ(field(sound), "") << sound;
  }
  for (const char* broken :
    { "1x", "1,5", "+-1", "--1", "0x1p3", "1e", "1.5.2", "1d3", "N10", "nano" })
  {
    ExpectMessage(field(broken), { "u.gf, line", broken });
  }
  // Beyond the range of doubles.
  const auto value = [](const std::string& number)
  {
    const SolverModel model = ReadTexts(OneCube(), { MakeFieldText("L2_3D_P0", 1, 0, number) });
    return ValueAt(model, 0, 0, { 0, 0, 0 })[0];
  };
  EXPECT_EQ(value("1e-400"), 0.0);
  EXPECT_EQ(value("0." + std::string(400, '0') + "1"), 0.0);
  EXPECT_EQ(value("0." + std::string(400, '0') + "1e401"), 1.0);
  EXPECT_EQ(value("-1234e-99999999999999999999"), 0.0);
  EXPECT_EQ(value("10e-325"), 0.0);
  for (const std::string wrong : { "0 1 2 3 4 5 6 7.0", "0 1 2 3 4 5 6 +-7", "0 1 2 3 4 5 6 7x" })
  {
    std::string mesh = OneCube();
    mesh.replace(mesh.find("0 1 2 3 4 5 6 7"), 15, wrong);
    ExpectMessage(Message(mesh), { "a.mesh, line", "no whole number" });
  }
}

TEST(MfemReader, MessagesNameFileLineAndRemedy)
{
  ExpectMessage(Message(""), { "a.mesh, line 1", "cut short" });
  ExpectMessage(Message("hello"), { "a.mesh, line 1", "'hello'" });
  ExpectMessage(Message("MFEM mesh v7.0"), { "v7.0", "v1.0 to v1.3" });
  ExpectMessage(Message("MFEM mesh v1.0\ndimension\n1\n"), { "line 3", "1-dimensional" });
  ExpectMessage(Message("MFEM NC mesh v1.0\ndimension\n1\n"), { "line 3", "1-dimensional" });
  ExpectMessage(Message("MFEM mesh v1.0\nelements\n1\n"), { "line 2", "begin", "'dimension'" });

  std::string mesh = OneCube();
  mesh.replace(mesh.find("elements\n1"), 10, "elements\n99999999");
  ExpectMessage(Message(mesh), { "line 8", "99999999", "more bytes" });
  mesh = OneCube();
  mesh.replace(mesh.find("elements\n1"), 10, "elements\n99999999999999");
  ExpectMessage(Message(mesh), { "no whole number" });
  // Three times this many do not fit an int.
  mesh = OneCube();
  mesh.replace(mesh.find("vertices\n8"), 10, "vertices\n1073741824");
  ExpectMessage(Message(mesh), { "a vertex coordinate", "cut short" });
  mesh = OneCube();
  mesh.replace(mesh.find("6 7\n"), 3, "6 8");
  ExpectMessage(Message(mesh), { "element 0", "vertex 8", "only 8" });
  mesh = OneCube();
  mesh.replace(mesh.find(" 5 0 1"), 2, " 3");
  ExpectMessage(Message(mesh), { "no solid" });
  mesh = OneCube();
  mesh.replace(mesh.rfind("1 1 1"), 5, "1 x 1");
  ExpectMessage(Message(mesh), { "'x'", "no number" });
  mesh = OneCube();
  mesh.replace(mesh.rfind("1 1 1"), 5, "1 nan 1");
  ExpectMessage(Message(mesh), { "element 0", "NaN" });
  ExpectMessage(Message(OneCube().substr(0, 120)), { "cut short" });
}

TEST(MfemReader, OtherFormatsOfTheSameSuffixAreNamed)
{
  ExpectMessage(Message("$MeshFormat\n2.2 0 8\n"), { "Gmsh", ".msh" });
  ExpectMessage(Message("areamesh2\n4\n"), { "Netgen", "Save" });
  for (const char* first : { "MeshVersionFormatted 2\nDimension 3\n", " MeshVersionFormatted\n1\n",
         "# made by hand\nMeshVersionFormatted 2\n" })
  {
    ExpectMessage(Message(first), { "Medit", "gmsh FILE.mesh -save" });
  }
  ExpectMessage(Message("TrueGrid\n"), { "TrueGrid", "Save" });
}

TEST(MfemReader, FieldsThatDoNotFitAreRefusedWithBothNumbers)
{
  ExpectMessage(
    Message(OneCube(), { MakeFieldText("H1_3D_P2", 1, 0, "1 2 3") }), { "u.gf", "3", "27" });
  ExpectMessage(
    Message(OneCube(), { MakeFieldText("H1_3D_P2", 1, 0, "1 2 three") }), { "u.gf, line" });
  ExpectMessage(
    Message(OneCube(), { MakeFieldText("Nonsense_9", 1, 0, "1") }), { "u.gf", "Nonsense_9" });
  ExpectMessage(Message(OneCube(), { "FiniteElementSpace\nFiniteElementCollection: L2_3D_P0\n" }),
    { "u.gf", "cut short" });
  ExpectMessage(Message(OneCube(), { MakeFieldText("NURBS2", 1, 0, "1") }), { "u.gf", "NURBS" });
  ExpectMessage(Message(OneCube(), { MakeFieldText("L2_3D_P33", 1, 0, "1") }), { "u.gf", "33" });
}

/// PETSc writes a value of a ghost cell beyond each face of the border after those of the elements.
TEST(MfemReader, GhostCellsBehindTheElementsAreNoted)
{
  const SolverModel model =
    ReadTexts(OneCube(), { MakeFieldText("L2_3D_P0", 1, 1, "42 0 0 0 0 0 0\n") });
  EXPECT_EQ(ValueAt(model, 0, 0, Vec3(0.0))[0], 42.0);
  ASSERT_EQ(model.notes.size(), 1U);
  ExpectMessage(model.notes[0], { "u.gf", "of 7 values the first 1", "ghost cells" });
  const SolverModel pairs = ReadTexts(OneCube(), { MakeFieldText("L2_3D_P0", 2, 1, "4 5 6 7\n") });
  EXPECT_EQ(ValueAt(pairs, 0, 0, Vec3(0.0)), (std::vector<double>{ 4.0, 5.0 }));
  const std::string triangles =
    "MFEM mesh v1.0\ndimension\n2\nelements\n2\n1 2 0 1 2\n1 2 0 2 3\nboundary\n0\nvertices\n4\n2\n"
    "0 0\n1 0\n1 1\n0 1\n";
  EXPECT_EQ(ReadTexts(triangles, { MakeFieldText("L2_2D_P0", 1, 1, "1 2 0 0 0 0\n") }).notes.size(),
    1U); // 4 edges
  ExpectMessage(
    Message(triangles, { MakeFieldText("L2_2D_P0", 1, 1, "1 2 0 0 0 0 0\n") }), { "7 values" });
  // More than the cube's six faces, parts of cells, component by component, nodes of a higher
  // order.
  ExpectMessage(
    Message(OneCube(), { MakeFieldText("L2_3D_P0", 1, 1, "1 2 3 4 5 6 7 8\n") }), { "8 values" });
  ExpectMessage(Message(OneCube(), { MakeFieldText("L2_3D_P0", 2, 1, "1 2 3\n") }), { "3 values" });
  ExpectMessage(
    Message(OneCube(), { MakeFieldText("L2_3D_P0", 2, 0, "1 2 3 4\n") }), { "4 values" });
  ExpectMessage(
    Message(OneCube(), { MakeFieldText("L2_3D_P1", 1, 1, "1 2 3 4 5 6 7 8 9\n") }), { "9 values" });
}

TEST(MfemReader, DamagedRefinementTrees)
{
  const std::string head = "MFEM NC mesh v1.0\ndimension\n3\nelements\n";
  ExpectMessage(Message(head + "2\n-1 1 5 1 1 1\n0 1 5 0 0 1 2 3 4 5 6 7\n"), { "two parents" });
  ExpectMessage(Message(head + "1\n-1 1 5 1 4 5\n"), { "a child is 4" });
  const std::string cube = "1\n0 1 5 0 0 1 2 3 4 5 6 7\n";
  ExpectMessage(Message(head + cube + "coordinates\n1\n3\n0 0 0\n"), { "neither coordinates" });
  ExpectMessage(
    Message(head + cube + "vertex_parents\n2\n0 1 1\n1 0 0\ncoordinates\n8\n3\n" + kCubeVertices),
    { "generations" });
}
} // namespace pixelexact::testing
