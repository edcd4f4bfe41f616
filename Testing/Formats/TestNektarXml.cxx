// SPDX-License-Identifier: BSD-3-Clause
#include "NektarTexts.h"

namespace pixelexact::testing
{
namespace
{
const std::string kSpace = "NUMMODESPERDIR=\"UNIORDER:2,2,2\" ID=\"5\" ";
const std::vector<double> kValues{ 1, 2, 3, 4, 5, 6, 7, 8 };

std::string Utf16(const std::string& text, bool bigEndian)
{
  std::string wide = bigEndian ? "\xfe\xff" : "\xff\xfe";
  for (const char c : text)
  {
    wide += bigEndian ? '\0' : c;
    wide += bigEndian ? c : '\0';
  }
  return wide;
}

void ExpectCube(const std::string& session)
{
  EXPECT_NO_THROW({ EXPECT_EQ(PointAt(ReadSession(session), 0, { 1, 1, 1 }).x, 1); }) << session;
}
} // namespace

TEST(NektarXml, FieldsAreCompressedWhereNothingIsSaid)
{
  for (const char* attributes : { "", "BITSIZE=\"64\" ", "COMPRESSED=\"B64Z-LittleEndian\" ",
         "COMPRESSED=\"b64z-littleendian\" BITSIZE=\"64\"" })
  {
    const SolverModel model = ReadSession(
      Session(Cube()), Field(kLinearHexahedron + kSpace + attributes, Compressed(kValues)));
    EXPECT_NEAR(ValueAt(model, 0, 0, { 1, 1, 1 })[0], 8, 1e-14) << attributes;
  }
  ExpectRefusal(Session(Cube()),
    Field(kLinearHexahedron + kSpace + "COMPRESSED=\"B64Z-BigEndian\"", Compressed(kValues)),
    { "u.fld", "B64Z-BigEndian" });
  ExpectRefusal(Session(Cube()),
    Field(kLinearHexahedron + kSpace + "COMPRESSED=\"B64Z-LittleEndian\" BITSIZE=\"32\"",
      Compressed(kValues)),
    { "u.fld", "32" });
}

TEST(NektarXml, FieldsAndTimesOfOldFiles)
{
  // Nektar++ 3: the time among FIELDMETADATA, each block below a root of its own.
  const std::string block = Field(kLinearHexahedron + kSpace, Compressed(kValues));
  const std::string old = Replaced(block, "<Metadata><Time>2.5</Time></Metadata>",
    "<FIELDMETADATA><P PARAM=\"Kinvis\">1</P><P PARAM=\"Time\">0.75</P></FIELDMETADATA>");
  EXPECT_EQ(ReadSession(Session(Cube()), old).time, 0.75);
  const std::string second = Replaced(block, "ID=\"5\"", "ID=\"6\"");
  ExpectRefusal(
    Session(Cube()), block + second.substr(second.find("<NEKTAR>")), { "hexahedron 6" });
  ExpectRefusal(Session(Cube()), Replaced(block, "2.5", "2.5 s"), { "u.fld", "<Time>", "'s'" });
  ExpectRefusal(Session(Cube()), Replaced(block, "2.5", ""), { "u.fld", "<Time>", "one number" });
}

TEST(NektarXml, WhatNektarReadsIsRead)
{
  const std::string good = Session(Cube());
  const std::string bare = good.substr(good.find("<NEKTAR>"));
  ExpectCube(bare);
  ExpectCube("\xef\xbb\xbf" + good);
  ExpectCube("<!DOCTYPE NEKTAR>\n" + bare);
  ExpectCube("<?xml version=\"1.0\"?>\n<!DOCTYPE NEKTAR SYSTEM \"nektar.dtd\">" + bare);
  ExpectCube(Replaced(bare, "<VERTEX>", "<!-- two -- hyphens ---><VERTEX>"));
  ExpectCube(Replaced(bare, "<GEOMETRY", "<CONDITIONS>&Re; &lt; 1 & more</CONDITIONS><GEOMETRY"));
  ExpectCube(bare + "\n<OTHER/>\n");
  ExpectCube(Utf16(good, false));
  ExpectCube(Utf16(good, true));
  const std::string named =
    Session(Cube("<COMPOSITE><C ID=\"0\" NAME=\"\xe9\">H[5]</C></COMPOSITE>"));
  const SolverModel latin =
    ReadSession(Replaced(named, "version=\"1.0\"", "version=\"1.0\" encoding=\"ISO-8859-1\""));
  EXPECT_EQ(latin.mesh.groups.at(0).name, "\xc3\xa9");
}

TEST(NektarXml, WhatTinyXmlReadsOverIsNoted)
{
  const std::string good = Session(Cube());
  const auto expect = [&](const std::string& broken, const std::vector<std::string>& notes)
  {
    const SolverModel model = ReadSession(
      Replaced(good, "<GEOMETRY", "\n<CONDITIONS>" + broken + "</CONDITIONS><GEOMETRY"));
    EXPECT_EQ(PointAt(model, 0, { 1, 1, 1 }).x, 1) << broken;
    ASSERT_EQ(model.notes.size(), notes.size()) << broken;
    for (std::size_t i = 0; i < notes.size(); ++i)
    {
      EXPECT_NE(model.notes[i].find(notes[i]), std::string::npos) << model.notes[i];
    }
  };
  expect("<!N VAR=\"u\" VALUE=\"0\" />", { "a.xml, line 3: '<!N VAR=\"u\" VALUE=\"0\" />'" });
  expect("\n<--!I PROPERTY=\"x\"\n VALUE=\"y\" /--><P/>\n<1/>",
    { "line 4: '<--!I PROPERTY=\"x\"'", "line 6: '<1/>'" });
  expect("<F> Source <F/>", { "line 3: '<F/>' is read as the end" });
  expect("<F> a <G> b <G /> c <H/> </F>", { "'<G />' is read as the end" });
  expect("<P A=1/><P B = -2.5 C=\"3\"></P>", { "'A=1'", "'B = -2.5'" });
  expect("<F NAME=\"f\"><E/></F NAME=\"f\"\n><G></G\t>", { "line 3: '</F NAME=\"f\"'" });
  expect("<F>1<F/></F><!--- <!N --->", {});
  const std::string field = Field(kLinearHexahedron + kSpace, Compressed(kValues));
  const SolverModel model = ReadSession(good, Replaced(field, "<Metadata>", "<!Old/><Metadata>"));
  EXPECT_EQ(model.time, 2.5);
  ASSERT_EQ(model.notes.size(), 1U);
  EXPECT_NE(model.notes[0].find("u.fld, line"), std::string::npos);
}

TEST(NektarXml, WhatIsNoXmlIsToldWithItsLine)
{
  const std::string good = Session(Cube("\n\n<COMPOSITE></COMPOSITE>"));
  ExpectRefusal(Replaced(good, "</COMPOSITE>", "</COMPOSITES>"), "", { "a.xml, line 4" });
  ExpectRefusal(Replaced(good, "<GEOMETRY", "\n<CONDITIONS><P>1<P></CONDITIONS><GEOMETRY"), "",
    { "a.xml, line 3" });
  ExpectRefusal(Replaced(good, "<GEOMETRY", "\n<P A=/><GEOMETRY"), "", { "a.xml, line 3" });
  ExpectRefusal(Replaced(good, "<GEOMETRY", "\n<P A=1\"/><GEOMETRY"), "", { "a.xml, line 3" });
  ExpectRefusal(Replaced(good, "<GEOMETRY", "\n<!N <GEOMETRY"), "", { "a.xml" });
  ExpectRefusal(Replaced(good, "<GEOMETRY", "\n<P A=\"1\" B=\"2\" A=\"3\"/><GEOMETRY"), "",
    { "a.xml, line 3", "<P>", "A twice" });
  ExpectRefusal("damaged" + good, "", { "a.xml, line 1", "text", "'damaged'" });
  ExpectRefusal(good + "\nmore", "", { "a.xml, line", "'\nmore'" });
  ExpectRefusal(good + std::string(1, '\0') + good, "", { "a.xml, line 4", "zero byte" });
  ExpectRefusal(
    "\n<!DOCTYPE x [<!ENTITY a \"b\">]>\n<NEKTAR>&a;</NEKTAR>", "", { "a.xml, line 2", "DOCTYPE" });
  ExpectRefusal(Utf16("<NEKTAR>\n\n</NEKTA>", false), "", { "a.xml, line 3" });
}
} // namespace pixelexact::testing
