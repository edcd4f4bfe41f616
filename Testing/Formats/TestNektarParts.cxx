// SPDX-License-Identifier: BSD-3-Clause
#include "NektarTexts.h"

#include <algorithm>
#include <set>

namespace pixelexact::testing
{
namespace
{
/// Cubes of unit size one above the other, from z = first to z = last, numbered from 500 on, with
/// the numbers that all cubes of the stack would have.
std::string Stack(int first, int last, const std::string& more = "")
{
  std::string vertices;
  std::string edges;
  std::string faces;
  std::string solids;
  const auto entity = [](const char* tag, int id, const std::vector<int>& parts)
  {
    std::string text = std::string("<") + tag + " ID=\"" + std::to_string(id) + "\">";
    for (const int part : parts)
    {
      text += std::to_string(part) + " ";
    }
    return text + "</" + tag + ">";
  };
  for (int z = first; z <= last; ++z)
  {
    for (int k = 0; k < 4; ++k)
    {
      vertices += entity("V", 4 * z + k, { k == 1 || k == 2 ? 1 : 0, k / 2, z });
      edges += entity("E", 100 + 4 * z + k, { 4 * z + k, 4 * z + (k + 1) % 4 });
    }
    faces += entity("Q", 300 + z, { 100 + 4 * z, 101 + 4 * z, 102 + 4 * z, 103 + 4 * z });
    for (int k = 0; k < 4 && z < last; ++k)
    {
      edges += entity("E", 200 + 4 * z + k, { 4 * z + k, 4 * (z + 1) + k });
      faces += entity("Q", 400 + 4 * z + k,
        { 100 + 4 * z + k, 200 + 4 * z + (k + 1) % 4, 104 + 4 * z + k, 200 + 4 * z + k });
    }
  }
  for (int z = first; z < last; ++z)
  {
    const int side = 400 + 4 * z;
    solids += entity("H", 500 + z, { 300 + z, side, side + 1, side + 2, side + 3, 301 + z });
  }
  return Session("<VERTEX>" + vertices + "</VERTEX><EDGE>" + edges + "</EDGE><FACE>" + faces +
    "</FACE><ELEMENT>" + solids + "</ELEMENT>" + more);
}
} // namespace

TEST(NektarParts, PartsOfAMeshAreReadTogether)
{
  const std::string groups =
    "<COMPOSITE><C ID=\"1\" NAME=\"fluid\">H[500-501]</C><C ID=\"2\">F[300,302]</C></COMPOSITE>";
  const auto part = [](int z)
  {
    return "<COMPOSITE><C ID=\"1\" NAME=\"fluid\">H[" + std::to_string(500 + z) +
      "]</C><C ID=\"2\">F[" + std::to_string(300 + 2 * z) + "]</C></COMPOSITE>";
  };
  const std::string lower = Stack(0, 1, part(0));
  const std::string upper = Stack(1, 2, part(1));
  const SolverModel whole = ReadSession(Stack(0, 2, groups));
  const auto attribute = [](int id)
  {
    return kLinearHexahedron + "NUMMODESPERDIR=\"UNIORDER:2,2,2\" ID=\"" + std::to_string(id) +
      "\"";
  };
  const std::string first = Field(attribute(500), "1 2 3 4 5 6 7 8");
  const std::string second = Field(attribute(501), "11 12 13 14 15 16 17 18");
  const SolverModel parts = nektar::Read({ { "P0000000.xml", lower }, { "P0000001.xml", upper } },
    { { "P0000000.fld", first }, { "P0000001.fld", second } });
  ASSERT_EQ(parts.mesh.number, (std::vector<std::int64_t>{ 500, 501 }));
  for (int e = 0; e < 2; ++e)
  {
    EXPECT_EQ(parts.mesh.corners[e], whole.mesh.corners[e]);
    EXPECT_EQ(parts.mesh.attribute[e], 1);
    EXPECT_EQ(PointAt(parts, e, { 0, 0, 1 }).z, e + 1);
  }
  ASSERT_EQ(parts.mesh.groups.size(), 2U);
  EXPECT_EQ(parts.mesh.groups[0].name, "fluid");
  ASSERT_EQ(parts.mesh.boundary.size(), 2U);
  EXPECT_EQ(parts.mesh.boundary[1].element, 1);
  EXPECT_NEAR(ValueAt(parts, 0, 1, { -1, -1, -1 })[0], 11, 1e-14);
  // Parts may overlap.
  EXPECT_EQ(
    nektar::Read({ { "a.xml", Stack(0, 2) }, { "b.xml", upper } }, {}).mesh.number.size(), 2U);
}

/// Faces between two elements belong to both.
TEST(NektarParts, CompositesOfInnerFacesAreListedOnBothSides)
{
  const SolverModel model = ReadSession(Stack(0, 2,
    "<COMPOSITE><C ID=\"1\">H[500-501]</C><C ID=\"2\">F[301,302]</C><C ID=\"3\">F[302]</C>"
    "</COMPOSITE>"));
  std::multiset<std::array<int, 3>> found;
  for (const auto& face : model.mesh.boundary)
  {
    found.insert({ face.element, face.face, face.attribute });
  }
  EXPECT_EQ(found,
    (std::multiset<std::array<int, 3>>{ { 0, 5, 2 }, { 1, 4, 2 }, { 1, 5, 2 }, { 1, 5, 3 } }));
}

TEST(NektarParts, PartsThatAreNotNamedAreNoted)
{
  const auto part = [](int z)
  {
    return Replaced(
      Stack(z, z + 1), "<GEOMETRY", "<GEOMETRY PARTITION=\"" + std::to_string(z) + "\"");
  };
  const std::string parts[] = { part(0), part(1), part(2) };
  const auto notes = [&](const std::vector<int>& named)
  {
    std::vector<NamedText> sessions(named.size());
    std::ranges::transform(named, sessions.begin(),
      [&](int z) {
        return NamedText{ "P.xml", parts[z] };
      });
    return nektar::Read(sessions, {}).notes;
  };
  EXPECT_TRUE(notes({ 0, 1, 2 }).empty());
  for (const std::vector<int>& named : { std::vector{ 0 }, std::vector{ 0, 2 } })
  {
    const auto found = notes(named);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NE(found[0].find("partitioned"), std::string::npos) << found[0];
  }
}

TEST(NektarParts, MeshesThatDoNotFitAreRefused)
{
  const std::string lower = Stack(0, 1);
  const std::string upper = Stack(1, 2);
  ExpectRefusal({ { "a.xml", lower }, { "b.xml", Replaced(upper, ">0 0 1 <", ">0 0 1.5 <") } },
    { "b.xml", "vertex 4", "one mesh" });
  ExpectRefusal(
    { { "a.xml", lower }, { "b.xml", Session(Placed("XMOVE=\"1\"")) } }, { "b.xml", "vertex" });
  ExpectRefusal({ { "a.xml", upper }, { "b.xml", Replaced(upper, ">4 5 <", ">5 4 <") } },
    { "b.xml", "edge 104" });
  ExpectRefusal(
    { { "a.xml", Stack(0, 1, "<COMPOSITE><C ID=\"0\" NAME=\"a\">H[500]</C></COMPOSITE>") },
      { "b.xml", Stack(1, 2, "<COMPOSITE><C ID=\"0\" NAME=\"b\">H[501]</C></COMPOSITE>") } },
    { "b.xml", "composite" });
  const auto curve = [](const char* middle)
  {
    return std::string("<CURVED><E ID=\"0\" EDGEID=\"104\" NUMPOINTS=\"3\" "
                       "TYPE=\"PolyEvenlySpaced\">0 0 1 0.5 ") +
      middle + " 1 1 0 1</E></CURVED>";
  };
  ExpectRefusal({ { "a.xml", Stack(0, 1, curve("0.1")) }, { "b.xml", Stack(1, 2, curve("0")) } },
    { "b.xml", "edge 104", "twice" });
  EXPECT_NO_THROW(nektar::Read(
    { { "a.xml", Stack(0, 1, curve("0.1")) }, { "b.xml", Stack(1, 2, curve("0.1")) } }, {}));
  // Twice within a file: neither is dropped.
  ExpectRefusal({ { "a.xml", Replaced(lower, "</VERTEX>", "</VERTEX><VERTEX/>") } }, { "VERTEX" });
  ExpectRefusal(
    { { "a.xml", Replaced(lower, "</GEOMETRY>", "</GEOMETRY><GEOMETRY/>") } }, { "GEOMETRY" });
  ExpectRefusal({ { "a.xml", lower + upper.substr(upper.find("<NEKTAR>")) } }, { "NEKTAR" });
}
} // namespace pixelexact::testing
