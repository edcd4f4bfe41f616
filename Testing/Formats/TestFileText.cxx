// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/Error.h"
#include "Formats/FileText.h"
#include "Formats/MFEM/Text/TextScanner.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace pixelexact::testing
{
namespace
{
constexpr std::size_t kLarge = std::size_t{ 20 } << 20U; ///< which is mapped

/// A file of the numbers 0, 1, 2, ..., removed with it.
class NumberFile
{
public:
  NumberFile()
    : Path((std::filesystem::path(::testing::TempDir()) /
        ("pixelexact-text-" +
          std::string(::testing::UnitTest::GetInstance()->current_test_info()->name())))
             .string())
  {
    while (Content.size() < kLarge)
    {
      Content += std::to_string(Numbers++) + "\n";
    }
    std::ofstream(Path, std::ios::binary) << Content;
  }
  ~NumberFile() { std::filesystem::remove(Path); }
  NumberFile(const NumberFile&) = delete;
  NumberFile& operator=(const NumberFile&) = delete;

  std::string Path;
  std::string Content;
  int Numbers = 0;
};
} // namespace

TEST(FileText, IsTheFileAlsoWhereItWasForgotten)
{
  const NumberFile file;
  const FileText text(file.Path);
  EXPECT_EQ(text.Get(), file.Content);
  text.Forget(0, text.Get().size());
  EXPECT_EQ(text.Get(), file.Content);
}

TEST(FileText, WhatAParserWroteIsForgottenToo)
{
  const NumberFile file;
  const FileText text(file.Path);
  ASSERT_FALSE(text.Own().empty());
  text.Own()[0] = 'x';
  EXPECT_EQ(text.Get()[0], 'x');
  text.Forget(0, text.Get().size());
  EXPECT_EQ(text.Get()[0], '0');
}

TEST(FileText, IsReadForwardWithPlacesOfErrors)
{
  const NumberFile file;
  const FileText text(file.Path);
  mfem::TextScanner scanner({ "numbers", text.Get(), &text });
  for (int i = 0; i < file.Numbers; ++i)
  {
    ASSERT_EQ(scanner.Integer("a number"), i);
  }
  try
  {
    scanner.Fail("the end.");
  }
  catch (const InvalidData& error)
  {
    EXPECT_EQ(
      std::string(error.what()), "numbers, line " + std::to_string(file.Numbers) + ": the end.");
  }
}

TEST(FileText, RefusesAFileThatIsCutShortMeanwhile)
{
  const NumberFile file;
  const FileText text(file.Path);
  std::filesystem::resize_file(file.Path, kLarge / 2);
  EXPECT_THROW(text.Forget(0, 4096), InvalidData);
}

TEST(FileText, RefusesWhatIsNoFile)
{
  EXPECT_THROW(FileText("/nowhere/at/all"), InvalidData);
  EXPECT_THROW(FileText(::testing::TempDir()), InvalidData);
}
} // namespace pixelexact::testing
