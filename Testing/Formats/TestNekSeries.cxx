// SPDX-License-Identifier: BSD-3-Clause
// The lists of files of Nek5000's steps, and the files that they name.
#include "NekFiles.h"
#include "SolverModelViews.h"

#include "Formats/Nek5000/Series.h"

#include <filesystem>
#include <fstream>

namespace pixelexact::testing
{
namespace
{
namespace fs = std::filesystem;

/// A part's number, of two digits, between two texts.
std::string Numbered(const std::string& before, int part, const std::string& after)
{
  std::string name = before;
  name += part < 10 ? "0" : "";
  name += std::to_string(part);
  name += after;
  return name;
}

/// A folder of one test.
class NekSeries : public ::testing::Test
{
protected:
  NekSeries()
    : Folder(fs::path(::testing::TempDir()) /
        (std::string("pixelexact-nek-") +
          ::testing::UnitTest::GetInstance()->current_test_info()->name()))
  {
    fs::remove_all(Folder);
    fs::create_directories(Folder);
  }
  ~NekSeries() override { fs::remove_all(Folder); }

  std::string Write(const std::string& name, const std::string& text)
  {
    const fs::path path = Folder / name;
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
  }

  std::string WriteStep(const std::string& name, double time, bool hasMesh = true)
  {
    NekFile file;
    file.time = time;
    file.codes = hasMesh ? "XUP" : "UP";
    return Write(name, file.Text());
  }

  std::string WriteList(const std::string& fileTemplate, int first, int count)
  {
    return Write("x.nek5000",
      "filetemplate: " + fileTemplate + "\nfirsttimestep: " + std::to_string(first) +
        "\nnumtimesteps: " + std::to_string(count) + "\n");
  }

  std::string PathOf(const std::string& name) const { return (Folder / name).string(); }

  fs::path Folder;
};

nek5000::SeriesFile Parse(const std::string& text)
{
  return nek5000::ParseSeriesFile({ "run/x.nek5000", text });
}

const std::string kList = "filetemplate: a b%01d.f%05d\nfirsttimestep: 3\nnumtimesteps:\t12\n";
} // namespace

TEST(NekSeriesFile, IsRead)
{
  const nek5000::SeriesFile list = Parse("NEK3D\r\n# a comment\n\ntype: binary6\r\n" + kList);
  EXPECT_EQ(list.fileTemplate, "a b%01d.f%05d");
  EXPECT_EQ(list.first, 3);
  EXPECT_EQ(list.count, 12);
  EXPECT_TRUE(list.notes.empty());
  EXPECT_EQ(list.NamesOf("run/x.nek5000", 14).Of(0), "run/a b0.f00014");
  EXPECT_EQ(list.NamesOf("run/x.nek5000", 123456).Of(12), "run/a b12.f123456");

  const auto names = [](const std::string& fileTemplate, std::int64_t part, std::int64_t step)
  {
    nek5000::SeriesFile other;
    other.fileTemplate = fileTemplate;
    return other.NamesOf("x.nek5000", step).Of(part);
  };
  EXPECT_EQ(names("A%02d/x%03d.f%05d", 7, 1), "A07/x007.f00001");
  EXPECT_EQ(names("100%%x%d", 7, 1), "100%x1");
  EXPECT_EQ(names("/data/x.f%05d", 0, 1), "/data/x.f00001");
}

TEST(NekSeriesFile, OtherLinesAreNoted)
{
  const auto notes = Parse(kList + "meshcoords: 1\nmore words\n").notes;
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_EQ(notes[0], "run/x.nek5000, line 4: 'meshcoords' is not known here and was passed over.");
  EXPECT_NE(notes[1].find("'more words'"), std::string::npos);
}

TEST(NekSeriesFile, DamagedListsAreRefused)
{
  const auto refuses = [](const std::string& text, const std::vector<std::string>& parts)
  { ExpectRefusal([&] { Parse(text); }, parts); };
  refuses("", { "run/x.nek5000", "filetemplate" });
  refuses(Replaced(kList, "numtimesteps", "steps"), { "numtimesteps", "missing" });
  refuses(Replaced(kList, "12", "0"), { "line 3", "numtimesteps", "from 1" });
  refuses(Replaced(kList, "12", "12 13"), { "line 3", "numtimesteps" });
  refuses(Replaced(kList, " 3", " -3"), { "line 2", "firsttimestep", "from 0" });
  refuses(kList + "numtimesteps: 2\n", { "line 4", "occurs twice" });
  refuses(Replaced(kList, "%01d.f%05d", "0.f00001"), { "line 1", "%d" });
  refuses(Replaced(kList, "%01d", "%s"), { "line 1", "'%s'" });
  refuses(Replaced(kList, "%01d", "%99d"), { "line 1", "'%99d'" });
  refuses(Replaced(kList, "%05d", "%"), { "line 1", "'%'" });
}

TEST_F(NekSeries, StepsOfAList)
{
  WriteStep("x0.f00002", 0.5);
  WriteStep("x0.f00003", 1.5, false);
  WriteStep("x0.f00004", 2.5);
  WriteStep("x0.f00005", 3.5, false);
  const std::string list = WriteList("x%01d.f%05d", 2, 4);
  const nek5000::Series series({ list });
  EXPECT_EQ(series.Times(), (std::vector<double>{ 0.5, 1.5, 2.5, 3.5 }));
  EXPECT_EQ(series.FilesOf(1), std::vector{ PathOf("x0.f00003") });
  for (const auto& [step, mesh] :
    { std::pair(0, 0), std::pair(1, 0), std::pair(2, 2), std::pair(3, 2) })
  {
    EXPECT_EQ(series.StepOfMesh(step), mesh);
  }
  EXPECT_TRUE(series.Notes().empty());

  WriteList("x%01d.f%05d", 3, 2);
  EXPECT_EQ(nek5000::Series({ list }).StepOfMesh(0), 1); // the first one after it
  WriteList("x%01d.f%05d", 3, 1);
  ExpectRefusal(
    [&] { static_cast<void>(nek5000::Series({ list }).StepOfMesh(0)); }, { "x0.f00003", "mesh" });
  WriteList("x%01d.f%05d", 2, 2'000'000'000);
  ExpectRefusal([&] { nek5000::Series({ list }); },
    { "x0.f00006 is missing", "step 4 of the 2000000000", "numtimesteps" });
  ExpectRefusal(
    [&] {
      nek5000::Series({ list, PathOf("x0.f00002") });
    },
    { "leave out", "x0.f00002" });
}

TEST_F(NekSeries, FilesOfStepsByTheirTimes)
{
  const std::string late = WriteStep("x0.f00002", 2.0, false);
  const std::string early = WriteStep("x0.f00001", 1.0);
  const nek5000::Series series({ late, early });
  EXPECT_EQ(series.Times(), (std::vector<double>{ 1.0, 2.0 }));
  EXPECT_EQ(series.FilesOf(1), std::vector{ late });
  const std::string again = WriteStep("x0.f00003", 2.0, false);
  const nek5000::Series numbered({ late, early, again });
  EXPECT_EQ(numbered.Times(), (std::vector<double>{ 0.0, 1.0, 2.0 }));
  ASSERT_EQ(numbered.Notes().size(), 1U);
  EXPECT_NE(numbered.Notes()[0].find("do not ascend"), std::string::npos);
}

TEST_F(NekSeries, StepsInParts)
{
  NekFile file;
  file.parts = 12;
  file.total = 12;
  std::vector<std::string> flat;
  std::vector<std::string> deep;
  for (int part = 0; part < file.parts; ++part)
  {
    file.part = part;
    file.numbers = { part + 1 };
    flat.push_back(Write(Numbered("run1", part, ".f00001"), file.Text()));
    deep.push_back(Write(Numbered("A", part, Numbered("/run1", part, ".f00001")), file.Text()));
  }
  const nek5000::Series listed({ WriteList("run1%02d.f%05d", 1, 1) });
  EXPECT_EQ(listed.FilesOf(0), flat);
  const nek5000::Series folders({ WriteList("A%02d/run1%02d.f%05d", 1, 1) });
  EXPECT_EQ(folders.FilesOf(0), deep);
  // One or all of the parts give the step.
  for (const std::vector<std::string>& parts : { flat, deep })
  {
    for (const std::string& one : parts)
    {
      EXPECT_EQ(nek5000::Series({ one }).FilesOf(0), parts) << one;
    }
    EXPECT_EQ(nek5000::Series(parts).Times().size(), 1U);
  }
  const nek5000::Series unnumbered({ WriteList("run100.f%05d", 1, 1) });
  ExpectRefusal([&] { static_cast<void>(unnumbered.FilesOf(0)); },
    { "run100.f00001", "12 parts", "x%02d.f%05d" });
  fs::remove(flat[4]);
  ExpectRefusal([&] { static_cast<void>(nek5000::Series({ flat[0] }).FilesOf(0)); },
    { flat[4], "missing", "12 parts" });
  fs::remove(deep[4]);
  ExpectRefusal([&] { static_cast<void>(nek5000::Series({ deep[9] }).FilesOf(0)); }, { deep[4] });
  const std::string renamed = Write("other.f00001", file.Text());
  ExpectRefusal(
    [&] { nek5000::Series({ renamed }); }, { "other.f00001", "part 11 of 12", "names" });
}

TEST_F(NekSeries, MeshesOfOtherRunsAreRefused)
{
  const std::string mesh = WriteStep("x0.f00001", 1.0);
  NekFile file;
  file.numbers = { 1, 2, 3 };
  file.codes = "UP";
  file.time = 2.0;
  const std::string step = Write("x0.f00002", file.Text());
  const nek5000::Series series({ mesh, step });
  ExpectRefusal([&] { static_cast<void>(series.StepOfMesh(1)); },
    { "x0.f00002", "3 elements", "x0.f00001 has 2" });
}

TEST(NekStepNames, EndWithDigits)
{
  EXPECT_TRUE(nek5000::IsStepName("run/x0.f00001"));
  EXPECT_TRUE(nek5000::IsStepName("x0.f123456"));
  for (const char* name : { "x.f0001", "x.fld", "x.f0000a", "x.nek5000", ".f00001", "f00001" })
  {
    EXPECT_FALSE(nek5000::IsStepName(name)) << name;
  }
}
} // namespace pixelexact::testing
