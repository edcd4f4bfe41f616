// SPDX-License-Identifier: BSD-3-Clause
// Large files, whose blocks the XML parser does not see.
#include "NektarTexts.h"

#include "Formats/FileText.h"
#include "Formats/Nektar/Files/XmlBlocks.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>

namespace pixelexact::testing
{
namespace
{
constexpr int kModes = 28; ///< along a direction
constexpr int kFields = 50;

class LongFile
{
public:
  explicit LongFile(const std::string& text)
    : Path((std::filesystem::path(::testing::TempDir()) /
        ("pixelexact-blocks-" +
          std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) + ".fld"))
             .string())
  {
    std::ofstream(Path, std::ios::binary) << text;
  }
  ~LongFile() { std::filesystem::remove(Path); }
  LongFile(const LongFile&) = delete;
  LongFile& operator=(const LongFile&) = delete;

  SolverModel Read(const std::string& session) const
  {
    const FileText text(Path);
    return nektar::Read({ { "a.xml", session } }, { { Path, text.Get(), &text } });
  }

  std::string Path;
};

/// Fields of numbers that cannot be compressed, which makes a file large enough to be mapped.
std::string LongField()
{
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::vector<double> values(static_cast<std::size_t>(kFields * kModes * kModes * kModes));
  std::ranges::generate(values, [&] { return number(random); });
  std::string names = "f0";
  for (int f = 1; f < kFields; ++f)
  {
    names += ",f" + std::to_string(f);
  }
  const std::string modes = std::to_string(kModes);
  return "<NEKTAR>\n<Metadata><Time>2.5</Time></Metadata>\n<ELEMENTS FIELDS=\"" + names + "\" " +
    kLinearHexahedron + "NUMMODESPERDIR=\"UNIORDER:" + modes + "," + modes + "," + modes +
    "\" ID=\"5\" COMPRESSED=\"B64Z-LittleEndian\" BITSIZE=\"64\">\n" + Compressed(values) +
    "\n</ELEMENTS>\n</NEKTAR>\n";
}
} // namespace

TEST(NektarLongBlocks, AreReadAsShortOnesAre)
{
  const std::string text = LongField();
  const LongFile file(text);
  {
    const FileText mapped(file.Path);
    const auto shortened = nektar::WithoutLongBlocks(mapped);
    ASSERT_TRUE(shortened.has_value());
    ASSERT_EQ(shortened->blocks.size(), 1U);
    EXPECT_LT(shortened->text.size(), 2000U);
    EXPECT_EQ(std::ranges::count(shortened->text, '\n'), std::ranges::count(text, '\n'));
  }
  const SolverModel mapped = file.Read(Session(Cube()));
  const SolverModel plain = ReadSession(Session(Cube()), text);
  EXPECT_EQ(mapped.time, plain.time);
  ASSERT_EQ(mapped.fields.size(), static_cast<std::size_t>(kFields));
  for (std::size_t f = 0; f < mapped.fields.size(); ++f)
  {
    const CoefficientBlock& a = mapped.fields[f].values.coefficients;
    const CoefficientBlock& b = plain.fields[f].values.coefficients;
    EXPECT_TRUE(std::ranges::equal(a, b));
  }
}

TEST(NektarLongBlocks, DamageIsToldWithItsPlace)
{
  const auto message = [](const std::string& text)
  {
    const LongFile file(text);
    try
    {
      file.Read(Session(Cube()));
    }
    catch (const Error& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string sound = LongField();
  std::string text = sound;
  text[text.size() / 2] = '!'; // no block any more: the parser reads all
  EXPECT_NE(message(text).find("base64"), std::string::npos);
  text = sound;
  text.erase(text.size() / 2, 4000);
  EXPECT_NE(message(text).find("ID=\"5\""), std::string::npos);
  text = Replaced(sound, "</ELEMENTS>\n</NEKTAR>", "</ELEMENTS>\n</NEKTA>");
  EXPECT_NE(message(text).find("line 6"), std::string::npos) << message(text);
  // A mark in the file itself has no meaning.
  text = Replaced(sound, "<Time>2.5</Time>",
    "<Time>B\x01"
    "0\x01</Time>");
  EXPECT_NE(message(text).find("is no number"), std::string::npos) << message(text);
  EXPECT_FALSE(nektar::BlockAt("B64").has_value());
  EXPECT_FALSE(nektar::BlockAt("B\x01x\x01").has_value());
}
} // namespace pixelexact::testing
