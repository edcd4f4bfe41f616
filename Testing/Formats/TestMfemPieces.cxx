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
std::string Square(int left, bool withGroups = true)
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

template <class Function>
void ExpectRefusal(const Function& read, const std::vector<std::string>& parts)
{
  try
  {
    read();
    ADD_FAILURE() << "was read";
  }
  catch (const Error& error)
  {
    for (const auto& part : parts)
    {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos)
        << "'" << part << "' in: " << error.what();
    }
  }
}

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
  const std::string mesh = Write("mesh.000000", Square(0));
  Write("mesh.000001", Square(1));
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
  const std::string mesh = Write("mesh.000000", Square(0));
  Write("mesh.000001", Square(1));
  const std::string u = Write("u.000000", Linear(0));
  Write("u.000001", Linear(1));
  const SolverModel second = mfem::ReadFiles(mesh, { u }, { 1, 2 });
  EXPECT_EQ(second.mesh.attribute, (std::vector<std::int32_t>{ 2 }));
  EXPECT_EQ(second.fields.at(0).values.spaceOf.size(), 1U);
  EXPECT_EQ(second.piecesOfRun, 2);
  ASSERT_EQ(second.pieces.size(), 1U);
  EXPECT_EQ(second.pieces[0].piece, 1);
  EXPECT_EQ(second.pieces[0].elements, 1);
  // More processes than pieces: some have none, and each piece is somebody's.
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
  const std::string mesh = Write("mesh.000000", Square(0));
  // The file tells of two processes, and the name of no other.
  ExpectRefusal([&] { mfem::ReadFiles(mesh, {}); }, { "mesh.000000", "2 processes", "x.000001" });
  Write("mesh.000002", Square(1));
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
  std::string solid = Square(1, false);
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
  const std::string mesh = Write("mesh.000000", Square(0));
  Write("mesh.000001", Square(1));
  Write("mesh.000002", Square(2));
  ExpectRefusal(
    [&] { mfem::ReadFiles(mesh, {}); }, { "mesh.000002", "mesh.000000", "different runs" });
}

TEST_F(MfemPieces, EmptyPiecesArePartOfTheWhole)
{
  const std::string mesh = Write("mesh.000000", Square(0, false));
  Write("mesh.000001", "MFEM mesh v1.0\ndimension\n2\nelements\n0\nboundary\n0\nvertices\n0\n2\n");
  EXPECT_EQ(mfem::ReadFiles(mesh, {}).mesh.number.size(), 1U);
}

TEST_F(MfemPieces, RootFilesTellOfTheirCycle)
{
  const std::string root = Write("run_000002.mfem_root", kRoot);
  Write("run_000002/mesh.000000", Square(0));
  Write("run_000002/mesh.000001", Square(1));
  Write("run_000002/u.000000", Linear(0));
  Write("run_000002/u.000001", Linear(1));
  const SolverModel model = mfem::ReadRootFile(root);
  ExpectLinear(model);
  EXPECT_EQ(model.time, 0.25);
  ASSERT_EQ(model.notes.size(), 1U);
  EXPECT_NE(model.notes[0].find("'q' is a quadrature function"), std::string::npos);
  fs::remove(In("run_000002/u.000001"));
  ExpectRefusal([&] { mfem::ReadRootFile(root); }, { "u.000001 is missing" });
  fs::remove(In("run_000002/mesh.000001"));
  ExpectRefusal(
    [&] { mfem::ReadRootFile(root); }, { "run_000002.mfem_root", "2 pieces", "1 file" });
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
  refuse("\"assoc\"", "\"with\"", { "'assoc' is missing" });
}

TEST(MfemStreams, OfAllProcesses)
{
  const auto stream = [](int number)
  {
    return "parallel 2 " + std::to_string(number) + "\nsolution\n" + Square(number, false) +
      "mfem_mesh_end\n" + Linear(number);
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
  const std::string other = stream(0) + "parallel 3 1\nmesh\n" + Square(1, false);
  ExpectRefusal([&] { mfem::ReadStream({ "a.saved", other }); }, { "3 processes" });
  const std::string bare = stream(0) + "parallel 2 1\nmesh\n" + Square(1, false);
  ExpectRefusal([&] { mfem::ReadStream({ "a.saved", bare }); }, { "some did not" });
  const std::string many = "parallel 1000000 0\nmesh\n" + Square(0, false);
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
