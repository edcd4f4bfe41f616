// SPDX-License-Identifier: BSD-3-Clause
// Exodus II files: sound ones in every format of netCDF, and damaged ones.
#include "Core/Base/Error.h"
#include "Formats/ApartProcess.h"
#include "Formats/Exodus/ExodusFile.h"
#include "Formats/FileText.h"

#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <new>

namespace pixelexact::testing
{
namespace
{
/// All numbers that a reader needs, one after the other.
std::vector<double> ReadAll(const std::string& path)
{
  const ExodusFile file(path);
  std::vector<double> all;
  const auto add = [&all](const auto& values)
  { all.insert(all.end(), values.begin(), values.end()); };
  for (const int direction : { 0, 1, 2 })
  {
    add(file.Coordinates(direction));
  }
  for (const auto& block : file.Blocks())
  {
    add(file.Connectivity(block));
  }
  for (const auto& set : file.SideSets())
  {
    add(set.elements);
    add(set.sides);
  }
  add(file.Times());
  for (std::size_t v = 0; !file.Times().empty() && v < file.NodalNames().size(); ++v)
  {
    add(file.AtNodes(v, 0));
  }
  return all;
}

class ExodusFileTest : public ::testing::Test
{
protected:
  void SetUp() override { std::filesystem::create_directories(Folder); }
  void TearDown() override { std::filesystem::remove_all(Folder); }

  std::string Write(const std::string& bytes) const
  {
    const std::string path = (Folder / "a.e").string();
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }

  /// Reads the bytes as a file: they are refused, or no more is read than they hold.
  void ExpectHarmless(const std::string& bytes, const std::string& what) const
  {
    const std::string path = Write(bytes);
    try
    {
      EXPECT_LE(ReadAll(path).size(), bytes.size()) << what;
    }
    catch (const Error& error)
    {
      EXPECT_FALSE(std::string(error.what()).empty());
    }
  }

  const std::filesystem::path Folder = std::filesystem::path(::testing::TempDir()) /
    ("pixelexact-exodus-" +
      std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};
} // namespace

TEST_F(ExodusFileTest, EveryByteMayBeDamaged)
{
  const std::string sound = ReadFileText(PIXELEXACT_DATA_DIR "/exodus_sides.e");
  constexpr std::array kBytes{ '\0', '\x7f', '\xff' };
  for (std::size_t at = 0; at < sound.size(); ++at)
  {
    std::string damaged = sound;
    damaged[at] = kBytes[at % kBytes.size()];
    ExpectHarmless(damaged, std::to_string(at));
  }
}

TEST_F(ExodusFileTest, MayBeCutShortAnywhere)
{
  const std::string sound = ReadFileText(PIXELEXACT_DATA_DIR "/exodus_sides.e");
  for (std::size_t size = 0; size < sound.size(); size += 7)
  {
    ExpectHarmless(sound.substr(0, size), std::to_string(size));
  }
}

TEST_F(ExodusFileTest, Netcdf4HoldsTheSame)
{
  try
  {
    EXPECT_EQ(ReadAll(PIXELEXACT_DATA_DIR "/exodus_netcdf4.e"),
      ReadAll(PIXELEXACT_DATA_DIR "/exodus_quadratic.e"));
  }
  catch (const Unsupported&)
  {
    GTEST_SKIP() << "built without the HDF5 library";
  }
}

TEST(ExodusVectors, EndingsMakeComponents)
{
  const auto fields = JoinComponents({ "u_x", "u_y", "u_z", "p", "vX", "vY", "Sxx", "Syy", "Szz",
    "Sxy", "Sxz", "Syz", "x", "y", "p", "ax", "by" });
  std::vector<std::string> names;
  std::size_t count = 0;
  for (const ExodusField& field : fields)
  {
    EXPECT_EQ(field.first, count);
    names.push_back(field.name + " " + std::to_string(field.count));
    count += field.count;
  }
  EXPECT_EQ(names,
    (std::vector<std::string>{
      "u_ 3", "p 1", "v 2", "S 6", "x 1", "y 1", "p_ 1", "ax 1", "by 1" }));
}

namespace
{
/// The message of RunApart for some work; empty where it succeeds.
std::string Complaint(const std::function<void()>& work)
{
  constexpr ApartLimits kLimits{ std::size_t{ 128 } << 20U, 1 };
  try
  {
    RunApart(kLimits, "the library", work);
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return {};
}
} // namespace

TEST(ApartProcess, TellsHowTheWorkEnded)
{
  int changed = 0;
  EXPECT_EQ(Complaint([&changed] { changed = 1; }), "");
  EXPECT_EQ(changed, 0);
  EXPECT_EQ(Complaint([] { throw InvalidData("line 3 is wrong"); }), "line 3 is wrong");
  for (const auto& work : std::vector<std::function<void()>>{ [] { std::raise(SIGSEGV); },
         [] { std::exit(0); }, [] { std::abort(); } })
  {
    EXPECT_NE(Complaint(work).find("the library ended, crashed"), std::string::npos);
  }
}

TEST(ApartProcess, EndsWhatTakesTooMuch)
{
  const auto loop = []
  {
    volatile bool isEndless = true;
    while (isEndless)
    {
    }
  };
  EXPECT_NE(Complaint(loop).find("did not come to an end"), std::string::npos);
#ifndef __SANITIZE_ADDRESS__ // which has an address space of its own
  const auto take = [] { ::operator delete(::operator new (std::size_t{ 1 } << 30U)); };
  EXPECT_NE(Complaint(take).find("more memory"), std::string::npos);
#endif
}
} // namespace pixelexact::testing
