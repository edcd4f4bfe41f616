// SPDX-License-Identifier: BSD-3-Clause
// What parallel runs of MFEM write, as files in a folder and as streams.
#include "SolverModelViews.h"

#include "Core/Base/Error.h"
#include "Formats/MFEM/Reader.h"
#include "Formats/MFEM/RootFile.h"
#include "Formats/MFEM/Text/PieceNames.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace pixelexact::testing
{
namespace
{
namespace fs = std::filesystem;

/// The unit square right of x = `left`, as one process of two has it.
std::string MakeSquarePiece(int left, bool withGroups = true)
{
  const std::string a = std::to_string(left);
  const std::string b = std::to_string(left + 1);
  std::string text = "MFEM mesh v1.2\n\ndimension\n2\n\nelements\n1\n" + b +
    " 3 0 1 2 3\n\nboundary\n1\n5 1 0 1\n\nvertices\n4\n2\n" + a + " 0\n" + b + " 0\n" + b +
    " 1\n" + a + " 1\n";
  if (withGroups)
  {
    text += "\nmfem_serial_mesh_end\n\ncommunication_groups\nnumber_of_groups 2\n\n# number of "
            "entities in each group, followed by ranks in group\n1 " +
      a +
      "\n2 0 1\n\ntotal_shared_vertices 2\ntotal_shared_edges 1\n\n# group 0 has no shared "
      "entities\n\n# group 1\nshared_vertices 2\n1\n2\n\nshared_edges 1\n1 2\n\nmfem_mesh_end\n";
  }
  return text;
}

/// x + 10 y at the vertices.
std::string Linear(int left)
{
  return "FiniteElementSpace\nFiniteElementCollection: H1_2D_P1\nVDim: 1\nOrdering: 0\n\n" +
    std::to_string(left) + "\n" + std::to_string(left + 1) + "\n" + std::to_string(left + 11) +
    "\n" + std::to_string(left + 10) + "\n";
}

class MfemPieces : public ::testing::Test
{
protected:
  void SetUp() override
  {
    Folder = fs::temp_directory_path() /
      ("pixelexact-pieces-" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
        "-" + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(Folder);
    fs::create_directories(Folder / "run_000002");
  }
  void TearDown() override { fs::remove_all(Folder); }

  std::string Write(const std::string& name, const std::string& text) const
  {
    std::ofstream(Folder / name) << text;
    return (Folder / name).string();
  }
  [[nodiscard]] std::string In(const std::string& name) const { return (Folder / name).string(); }

  fs::path Folder;
};

void ExpectLinear(const SolverModel& model, std::size_t field = 0)
{
  ASSERT_EQ(model.mesh.number, (std::vector<std::int64_t>{ 0, 1 }));
  for (int e = 0; e < 2; ++e)
  {
    const Vec3 xi(0.3, -0.7, 0.0);
    const Vec3 x = PointAt(model, e, xi);
    EXPECT_NEAR(x.x, e + 0.65, 1e-15);
    EXPECT_NEAR(ValueAt(model, field, e, xi)[0], x.x + 10 * x.y, 1e-14);
  }
}

const std::string kQuadrature =
  "QuadratureSpace\nType: default_quadrature\nOrder: 0\nVDim: 1\n\n1\n";

const std::string kRoot = R"({"dsets": {"main": {"cycle": 2, "time": 0.25, "time_step": 0.125,
  "domains": 2,
  "mesh": {"path": "run_000002/mesh.%06d", "format": "1",
           "tags": {"spatial_dim": "2", "topo_dim": "2", "max_lods": "32"}},
  "fields": {
    "u": {"path": "run_000002/u.%06d", "tags": {"assoc": "nodes", "comps": "1", "lod": "1"}},
    "q": {"path": "run_000002/q.%06d", "tags": {"assoc": "elements", "comps": "1"}}}}}})";
} // namespace

TEST_F(MfemPieces, AreOneMesh)
{
  const std::string mesh = Write("mesh.000000", MakeSquarePiece(0));
  Write("mesh.000001", MakeSquarePiece(1));
  const std::string u = Write("u.000000", Linear(0));
  Write("u.000001", Linear(1));
  for (const std::string& any : { mesh, In("mesh.000001") })
  {
    const SolverModel model = mfem::ReadFiles(any, { u });
    ExpectLinear(model);
    EXPECT_EQ(model.fields.at(0).name, "u");
    EXPECT_EQ(model.mesh.attribute, (std::vector<std::int32_t>{ 1, 2 }));
    // Each piece's lower edge.
    ASSERT_EQ(model.mesh.boundary.size(), 2U);
    EXPECT_EQ(model.mesh.boundary[1].element, 1);
    EXPECT_EQ(model.mesh.boundary[1].face, 2);
    EXPECT_TRUE(model.notes.empty());
  }
}

TEST_F(MfemPieces, ProcessesReadTheirOwn)
{
  const std::string mesh = Write("mesh.000000", MakeSquarePiece(0));
  Write("mesh.000001", MakeSquarePiece(1));
  const std::string u = Write("u.000000", Linear(0));
  Write("u.000001", Linear(1));
  const SolverModel second = mfem::ReadFiles(mesh, { u }, { 1, 2 });
  EXPECT_EQ(second.mesh.attribute, (std::vector<std::int32_t>{ 2 }));
  EXPECT_EQ(second.fields.at(0).values.spaceOf.size(), 1U);
  EXPECT_EQ(second.piecesOfRun, 2);
  ASSERT_EQ(second.pieces.size(), 1U);
  EXPECT_EQ(second.pieces[0].piece, 1);
  EXPECT_EQ(second.pieces[0].elements, 1);
  // With more processes than pieces some have none, and each piece is read once.
  int read = 0;
  for (int process = 0; process < 5; ++process)
  {
    const SolverModel model = mfem::ReadFiles(mesh, { u }, { process, 5 });
    EXPECT_EQ(model.piecesOfRun, 2);
    EXPECT_EQ(model.mesh.number.size(), model.pieces.size());
    read += static_cast<int>(model.pieces.size());
  }
  EXPECT_EQ(read, 2);
}

TEST_F(MfemPieces, MissingOnesAreNamed)
{
  const std::string mesh = Write("mesh.000000", MakeSquarePiece(0));
  // The file names two processes, and no other file exists.
  ExpectRefusal([&] { mfem::ReadFiles(mesh, {}); }, { "mesh.000000", "2 processes", "x.000001" });
  Write("mesh.000002", MakeSquarePiece(1));
  ExpectRefusal([&] { mfem::ReadFiles(mesh, {}); }, { "mesh.000001 is missing" });
  fs::rename(In("mesh.000002"), In("mesh.000001"));
  const std::string u = Write("u.000000", Linear(0));
  ExpectRefusal([&] { mfem::ReadFiles(mesh, { u }); }, { "u.000001 is missing", "2 pieces" });
  const std::string whole = Write("whole.gf", Linear(0));
  ExpectRefusal([&] { mfem::ReadFiles(mesh, { whole }); }, { "whole.gf", "u.000000" });
  std::string other = Linear(1);
  other.replace(other.find("H1_2D_P1"), 8, "L2_2D_P0");
  Write("u.000001", other);
  ExpectRefusal(
    [&] { mfem::ReadFiles(mesh, { u }); }, { "u.000001", "u.000000", "different spaces" });
  std::string solid = MakeSquarePiece(1, false);
  solid.replace(solid.find("dimension\n2"), 11, "dimension\n3");
  solid.replace(solid.find("2 3 0 1 2 3"), 11, "2 4 0 1 2 3");
  solid.replace(solid.find("5 1 0 1"), 7, "5 2 0 1 2");
  solid.replace(solid.find("4\n2\n1 0"), 7, "4\n3\n1 0 0 1 1 0 1 2 0 2 2");
  solid.resize(solid.find("2 2") + 3);
  Write("mesh.000001", solid);
  ExpectRefusal([&] { mfem::ReadFiles(mesh, {}); }, { "mesh.000001" });
}

TEST_F(MfemPieces, LeftoversOfAnotherRunAreRefused)
{
  const std::string mesh = Write("mesh.000000", MakeSquarePiece(0));
  Write("mesh.000001", MakeSquarePiece(1));
  Write("mesh.000002", MakeSquarePiece(2));
  ExpectRefusal(
    [&] { mfem::ReadFiles(mesh, {}); }, { "mesh.000002", "mesh.000000", "different runs" });
}

TEST_F(MfemPieces, EmptyPiecesArePartOfTheWhole)
{
  const std::string mesh = Write("mesh.000000", MakeSquarePiece(0, false));
  Write("mesh.000001", "MFEM mesh v1.0\ndimension\n2\nelements\n0\nboundary\n0\nvertices\n0\n2\n");
  EXPECT_EQ(mfem::ReadFiles(mesh, {}).mesh.number.size(), 1U);
}

TEST_F(MfemPieces, RootFilesNameTheirCycle)
{
  const std::string root = Write("run_000002.mfem_root", kRoot);
  Write("run_000002/mesh.000000", MakeSquarePiece(0));
  Write("run_000002/mesh.000001", MakeSquarePiece(1));
  Write("run_000002/u.000000", Linear(0));
  Write("run_000002/u.000001", Linear(1));
  Write("run_000002/q.000000", kQuadrature);
  Write("run_000002/q.000001", kQuadrature);
  const SolverModel model = mfem::ReadRootFile(root);
  ExpectLinear(model);
  EXPECT_EQ(model.time, 0.25);
  ASSERT_EQ(model.fields.size(), 2U);
  EXPECT_EQ(model.fields[1].name, "q");
  EXPECT_EQ(ValueAt(model, 1, 1, Vec3(0.3))[0], 1.0);
  ASSERT_EQ(model.notes.size(), 1U);
  EXPECT_NE(model.notes[0].find("values at 1 Gauss-Legendre point;"), std::string::npos);
  // The file's first line decides, and not the tag.
  for (int p = 0; p < 2; ++p)
  {
    Write("run_000002/q.00000" + std::to_string(p),
      "FiniteElementSpace\nFiniteElementCollection: L2_2D_P0\nVDim: 1\nOrdering: 0\n\n" +
        std::to_string(p + 7) + "\n");
  }
  const SolverModel elements = mfem::ReadRootFile(root);
  ASSERT_EQ(elements.fields.size(), 2U);
  EXPECT_EQ(elements.fields[0].name, "q");
  EXPECT_EQ(ValueAt(elements, 0, 0, Vec3(0.0))[0], 7.0);
  EXPECT_EQ(ValueAt(elements, 0, 1, Vec3(0.0))[0], 8.0);
  EXPECT_TRUE(elements.notes.empty());
  fs::remove(In("run_000002/u.000001"));
  ExpectRefusal([&] { mfem::ReadRootFile(root); }, { "u.000001 is missing" });
  fs::remove(In("run_000002/mesh.000001"));
  ExpectRefusal(
    [&] { mfem::ReadRootFile(root); }, { "run_000002.mfem_root", "2 pieces", "1 file" });
}

/// Two knot spans of degree 2 along x, a degree 1 along y; `elements`: of a piece, else the whole.
/// The control points are numbered: corners 0 to 3, bottom 4 and 5, top 6 and 7 from the right.
std::string Ribbon(
  const std::string& elements, const std::vector<int>& points, bool isMoved = false)
{
  const std::vector<std::string> places{ "0 0", "3 0.5", "3 1.5", "0 1", "1 0.25", "2 -0.25",
    "2 1.125", "1 0.75" };
  const std::vector<std::string> weights{ "1", "0.5", "2", "1", "0.75", "1.25", "1.5", "0.625" };
  std::string text =
    "MFEM NURBS mesh v1.0\ndimension\n2\nelements\n1\n7 3 0 1 2 3\nboundary\n4\n"
    "1 1 0 1\n2 1 1 2\n3 1 2 3\n4 1 3 0\nedges\n4\n0 0 1\n0 3 2\n1 0 3\n1 1 2\nvertices\n4\n"
    "knotvectors\n2\n2 4 0 0 0 0.5 1 1 1\n1 2 0 0 1 1\n" +
    (elements.empty() ? "" : "\nmesh_elements\n" + elements + "\n") + "\nweights\n";
  std::string nodes =
    "\nFiniteElementSpace\nFiniteElementCollection: NURBS\nVDim: 2\nOrdering: 1\n";
  for (const int point : points)
  {
    text += weights[static_cast<std::size_t>(point)] + "\n";
    nodes += (isMoved && point == 5 ? "2 -0.5" : places[static_cast<std::size_t>(point)]) + "\n";
  }
  return text + nodes;
}

/// Values of a NURBS space of a higher order, whose weights are 1, or of the mesh's own.
std::string OnPoints(
  const std::string& collection, const std::vector<int>& points, double shift = 0.0)
{
  std::string text =
    "FiniteElementSpace\nFiniteElementCollection: " + collection + "\nVDim: 1\nOrdering: 0\n\n";
  for (const int point : points)
  {
    text += std::to_string(point * point - 3 * point + shift) + "\n";
  }
  return text;
}

const std::vector<int> kAllPoints{ 0, 1, 2, 3, 4, 5, 6, 7 };
const std::vector<int> kLeft{ 0, 3, 4, 5, 6, 7 };
const std::vector<int> kRight{ 1, 2, 4, 5, 6, 7 };

TEST_F(MfemPieces, OfNurbsAreTheWholeMesh)
{
  const std::string whole = Write("whole.mesh", Ribbon("", kAllPoints));
  const std::string values = Write("u.gf", OnPoints("NURBS", kAllPoints));
  // Four values for each knot span.
  const auto l2 = [](int count, int first)
  {
    std::string text = "FiniteElementSpace\nFiniteElementCollection: L2_2D_P1\nVDim: 1\n"
                       "Ordering: 0\n\n";
    for (int i = 0; i < count; ++i)
    {
      text += std::to_string((first + i) * (first + i)) + "\n";
    }
    return text;
  };
  const std::string discontinuous = Write("d.gf", l2(8, 0));
  const std::string mesh = Write("mesh.000000", Ribbon("1\n0", kLeft));
  Write("mesh.000001", Ribbon("1\n1", kRight));
  const std::string u = Write("u.000000", OnPoints("NURBS", kLeft));
  Write("u.000001", OnPoints("NURBS", kRight));
  const std::string d = Write("d.000000", l2(4, 0));
  Write("d.000001", l2(4, 4));
  const SolverModel one = mfem::ReadFiles(whole, { values, discontinuous });
  for (const PieceOf& part : { PieceOf{}, PieceOf{ 1, 2 } }) // each process reads all
  {
    const SolverModel all = mfem::ReadFiles(mesh, { u, d }, part);
    EXPECT_EQ(all.piecesOfRun, 0);
    ASSERT_EQ(all.mesh.number, one.mesh.number);
    EXPECT_EQ(all.mesh.attribute, one.mesh.attribute);
    EXPECT_EQ(all.mesh.boundary.size(), one.mesh.boundary.size());
    ASSERT_EQ(all.fields.size(), 2U);
    EXPECT_TRUE(all.fields[0].continuous);
    for (int e = 0; e < static_cast<int>(one.mesh.number.size()); ++e)
    {
      const Vec3 xi(0.3, -0.7, 0.0);
      EXPECT_EQ(PointAt(all, e, xi), PointAt(one, e, xi));
      EXPECT_EQ(ValueAt(all, 0, e, xi), ValueAt(one, 0, e, xi));
      EXPECT_EQ(ValueAt(all, 1, e, xi), ValueAt(one, 1, e, xi));
    }
  }
}

TEST_F(MfemPieces, OfNurbsKeepValuesOfTheirOwn)
{
  const std::string mesh = Write("mesh.000000", Ribbon("1\n0", kLeft));
  Write("mesh.000001", Ribbon("1\n1", kRight));
  const std::string u = Write("u.000000", OnPoints("NURBS", kLeft));
  Write("u.000001", OnPoints("NURBS", kRight, 100.0));
  const SolverModel model = mfem::ReadFiles(mesh, { u });
  EXPECT_FALSE(model.fields.at(0).continuous);
  for (int e = 0; e < static_cast<int>(model.mesh.number.size()); ++e)
  {
    const double value = ValueAt(model, 0, e, Vec3(0.0))[0];
    EXPECT_EQ(value > 80.0, model.mesh.number[static_cast<std::size_t>(e)] == 1) << value;
  }
}

TEST_F(MfemPieces, OfNurbsThatDoNotFitAreRefused)
{
  const std::string mesh = Write("mesh.000000", Ribbon("1\n0", kLeft));
  const auto refuse = [&](const std::vector<std::string>& parts)
  { ExpectRefusal([&] { mfem::ReadFiles(mesh, {}); }, parts); };
  refuse({ "mesh.000000", "2 elements", "1 are", "PrintAsOne" });
  Write("mesh.000001", Ribbon("1\n0", kLeft));
  refuse({ "mesh.000001", "element 0", "another piece" });
  Write("mesh.000001", Ribbon("1\n2", kRight));
  refuse({ "mesh.000001", "element 2" });
  Write("mesh.000001", Ribbon("1\n1", kAllPoints));
  refuse({ "mesh.000001", "8 weights", "6 control points" });
  Write("mesh.000001", Ribbon("1\n1", kRight, true));
  refuse({ "different places", "different runs" });
  std::string other = Ribbon("1\n1", kRight);
  other.replace(other.find("0.5 1 1 1"), 3, "0.4");
  Write("mesh.000001", other);
  refuse({ "mesh.000001", "no pieces of one NURBS mesh" });
  Write("mesh.000001", MakeSquarePiece(0, false));
  refuse({ "mesh.000001", "no pieces of one NURBS mesh" });
  Write("mesh.000001", Ribbon("1\n1", kRight));
  const std::string u = Write("u.000000", OnPoints("NURBS", kLeft));
  Write("u.000001", OnPoints("NURBS", kAllPoints));
  ExpectRefusal([&] { mfem::ReadFiles(mesh, { u }); }, { "u.000001", "8 values", "has 6" });
  Write("u.000001", OnPoints("NURBS3", kRight));
  ExpectRefusal([&] { mfem::ReadFiles(mesh, { u }); }, { "u.000001", "different spaces" });
}

TEST_F(MfemPieces, DamagedRootFiles)
{
  const auto refuse =
    [](const std::string& from, const std::string& to, const std::vector<std::string>& parts)
  {
    std::string text = kRoot;
    text.replace(text.find(from), from.size(), to);
    ExpectRefusal([&] { mfem::ParseRootFile({ "a.mfem_root", text }); }, parts);
  };
  refuse("}}}}}}", "", { "a.mfem_root", "no JSON" });
  refuse("dsets", "sets", { "'dsets' is missing" });
  refuse("\"time\": 0.25", "\"time\": null", { "'time'", "no number" });
  refuse("\"domains\": 2", "\"domains\": 0", { "'domains'" });
  refuse("\"domains\": 2", "\"domains\": 2.5", { "'domains'" });
  refuse("mesh.%06d", "mesh", { "%06d" });
  refuse("mesh.%06d", "%s.%06d", { "%06d" });
  refuse("run_000002/u.%06d", "u", { "'u'", "%06d" });
}

TEST(MfemStreams, OfAllProcesses)
{
  const auto stream = [](int number)
  {
    return "parallel 2 " + std::to_string(number) + "\nsolution\n" +
      MakeSquarePiece(number, false) + "mfem_mesh_end\n" + Linear(number);
  };
  const std::string both = stream(1) + "keys aa\n" + stream(0) + "keys bb\n";
  ExpectLinear(mfem::ReadStream({ "a.saved", both }));
  const std::string half = stream(1);
  ExpectRefusal(
    [&] {
      mfem::ReadStream({ "a.saved", half });
    },
    { "2 processes", "process 0 is missing" });
  const std::string twice = stream(0) + stream(0);
  ExpectRefusal([&] { mfem::ReadStream({ "a.saved", twice }); }, { "there twice" });
  const std::string other = stream(0) + "parallel 3 1\nmesh\n" + MakeSquarePiece(1, false);
  ExpectRefusal([&] { mfem::ReadStream({ "a.saved", other }); }, { "3 processes" });
  const std::string bare = stream(0) + "parallel 2 1\nmesh\n" + MakeSquarePiece(1, false);
  ExpectRefusal([&] { mfem::ReadStream({ "a.saved", bare }); }, { "some did not" });
  const std::string many = "parallel 1000000 0\nmesh\n" + MakeSquarePiece(0, false);
  ExpectRefusal([&] { mfem::ReadStream({ "a.saved", many }); }, { "1000000" });
}

/// Two quarters of a square that was refined once, of two processes; each file has a leaf of the
/// other, after which the vertices count on.
TEST_F(MfemPieces, RefinedMeshesWithGhosts)
{
  const auto piece = [](int rank)
  {
    return "MFEM NC mesh v1.0\n\ndimension\n2\n\nrank " + std::to_string(rank) +
      "\n\nelements\n3\n-1 1 3 1 1 2\n0 1 3 0 0 4 6 3\n1 2 3 0 4 1 2 6\n\nboundary\n0\n\n"
      "vertex_parents\n2\n4 0 1\n6 3 2\n\ncoordinates\n4\n2\n0 0\n2 0\n2 1\n0 1\n";
  };
  // Conforming numbers of piece 1: the coarse vertices 1 and 2, then 4 and 6 as rank 0 meets them.
  const std::string mesh = Write("m.000000", piece(0));
  Write("m.000001", piece(1));
  const auto values = [](const char* list)
  {
    return std::string("FiniteElementSpace\nFiniteElementCollection: H1_2D_P1\nVDim: 1\n"
                       "Ordering: 0\n\n") +
      list;
  };
  const std::string u = Write("u.000000", values("0 10 1 11"));
  Write("u.000001", values("2 12 1 11"));
  ExpectLinear(mfem::ReadFiles(mesh, { u }));
}
} // namespace pixelexact::testing
