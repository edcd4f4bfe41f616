// SPDX-License-Identifier: BSD-3-Clause
// Names of the fields from the beginning of a field file.
#include "Formats/Nektar/Files/FileParts.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace pixelexact::testing
{
namespace
{
std::string Written(const std::string& name, const std::string& text)
{
  const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / name;
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path) << text;
  return path.string();
}

using Names = std::vector<std::string>;
} // namespace

TEST(NektarFieldNames, OfAFile)
{
  const std::string file = Written(
    "names.fld", "<NEKTAR><ELEMENTS FIELDS=\"u,v, w\" SHAPE=\"Hexahedron\">x</ELEMENTS></NEKTAR>");
  EXPECT_EQ(nektar::FieldNames(file), (Names{ "u", "v", "w" }));
}

TEST(NektarFieldNames, OfAFolder)
{
  Written("names_parts.fld/Info.xml", "<NEKTAR><Metadata /></NEKTAR>");
  const std::string part = Written("names_parts.fld/P0000000.fld", "<ELEMENTS FIELDS=\"p\">");
  EXPECT_EQ(nektar::FieldNames(std::filesystem::path(part).parent_path().string()), (Names{ "p" }));
}

TEST(NektarFieldNames, OfWhatIsNone)
{
  EXPECT_EQ(nektar::FieldNames(Written("names_none.fld", "<NEKTAR FIELDS=\"u")), Names{});
  EXPECT_EQ(nektar::FieldNames("no such file"), Names{});
}
} // namespace pixelexact::testing
