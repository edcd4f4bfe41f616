// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Gmsh/Sections.h"

#include "Core/Base/Quote.h"

#include <algorithm>
#include <array>

namespace pixelexact::gmsh
{
namespace
{
constexpr const char* kFormat = "MeshFormat";
constexpr std::array kOld{ 2.0, 2.1, 2.2 };

void ReadEncoding(Scanner& scanner)
{
  Encoding encoding;
  encoding.version = scanner.TextNumber("the version");
  const auto mode = scanner.TextInteger("the file type");
  const auto bytes = scanner.TextInteger("the data size");
  const bool isOld = std::ranges::find(kOld, encoding.version) != kOld.end();
  if (!isOld && encoding.version != kNew)
  {
    scanner.FailUnsupported("version " + std::to_string(encoding.version).substr(0, 3) +
      " of the format is not read, 2.0 to 2.2 and 4.1 are; convert it: gmsh FILE.msh -save -format "
      "msh41 "
      "-o NEW.msh.");
  }
  if (mode != 0 && mode != 1)
  {
    scanner.Fail("the file type is " + std::to_string(mode) + ", not 0 (text) or 1 (binary).");
  }
  // In versions 2 the size of doubles, in 4.1 that of counts.
  if (bytes != 8 && !(bytes == 4 && encoding.version == kNew))
  {
    scanner.Fail("the data size is " + std::to_string(bytes) + " bytes, not 8.");
  }
  encoding.sizeBytes = static_cast<int>(bytes);
  encoding.binary = mode == 1;
  scanner.SetEncoding(encoding);
  if (encoding.binary)
  {
    constexpr int kSwappedOne = 1 << 24;
    scanner.EndLine();
    const int one = scanner.Int("the number one");
    if (one != 1 && one != kSwappedOne)
    {
      scanner.Fail("the number one that tells the order of bytes is " + std::to_string(one) +
        "; the file is damaged.");
    }
    encoding.swapped = one == kSwappedOne;
    scanner.SetEncoding(encoding);
  }
  scanner.EndSection(kFormat);
}
} // namespace

std::vector<Section> ListSections(Scanner& scanner)
{
  if (!scanner.Peek().starts_with('$'))
  {
    scanner.Fail("found " + Quote(scanner.Peek()) +
      " where a Gmsh file begins with '$MeshFormat'; it is a file of another program.");
  }
  std::vector<Section> sections;
  bool known = false;
  while (!scanner.Peek().empty())
  {
    const std::string_view word = scanner.Word("a section");
    if (!word.starts_with('$'))
    {
      scanner.Fail("found " + Quote(word) +
        " behind the end of a section; the file is damaged, or a section has a wrong end.");
    }
    Section section{ std::string(word.substr(1)), 0 };
    scanner.EndLine();
    section.begin = scanner.Position();
    if (section.name == kFormat)
    {
      ReadEncoding(scanner);
      known = true;
      continue;
    }
    if (!known && section.name != "Comments")
    {
      scanner.FailUnsupported("$" + section.name.substr(0, 40) +
        " stands before $MeshFormat: this is version 1 of the format or no Gmsh file; convert it: "
        "gmsh FILE.msh -save -format msh41 -o NEW.msh.");
    }
    scanner.LeaveSection(section.name);
    sections.push_back(std::move(section));
  }
  return sections;
}
} // namespace pixelexact::gmsh
