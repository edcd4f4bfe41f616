// SPDX-License-Identifier: BSD-3-Clause
// Gmsh's meshes: both versions, text and bytes, groups, and what is refused.
#include "GmshTexts.h"
#include "SolverModelViews.h"

#include <limits>

namespace pixelexact::testing
{
namespace
{
std::string Binary22(bool swapped)
{
  return Bytes(swapped)
    .Text("$MeshFormat\n2.2 1 8\n")
    .Ints({ 1 })
    .Text("\n$EndMeshFormat\n$Nodes\n5\n")
    .Ints({ 1 })
    .Reals({ 0, 0, 0 })
    .Ints({ 2 })
    .Reals({ 1, 0, 0 })
    .Ints({ 3 })
    .Reals({ 0, 1, 0 })
    .Ints({ 4 })
    .Reals({ 0, 0, 1 })
    .Ints({ 5 })
    .Reals({ 1, 1, 1 })
    .Text("\n$EndNodes\n$Elements\n3\n")
    .Ints({ 2, 1, 2, 10, 0, 7, 2, 3, 4 })
    .Ints({ 4, 2, 2, 11, 0, 1, 1, 2, 3, 4, 12, 0, 2, 2, 3, 4, 5 })
    .Text("\n$EndElements\n$NodeData\n1\n\"u\"\n1\n0\n3\n0\n1\n5\n")
    .Ints({ 1 })
    .Reals({ 1 })
    .Ints({ 2 })
    .Reals({ 2 })
    .Ints({ 3 })
    .Reals({ 3 })
    .Ints({ 4 })
    .Reals({ 4 })
    .Ints({ 5 })
    .Reals({ 5 })
    .Text("\n$EndNodeData\n")
    .Data;
}

std::string Binary41(bool swapped)
{
  return Bytes(swapped)
    .Text("$MeshFormat\n4.1 1 8\n")
    .Ints({ 1 })
    .Text("\n$EndMeshFormat\n$Entities\n")
    .Sizes({ 0, 0, 1, 1 })
    .Ints({ 7 })
    .Reals({ 0, 0, 0, 1, 1, 1 })
    .Sizes({ 2 })
    .Ints({ 70, -71 })
    .Sizes({ 0 })
    .Ints({ 1 })
    .Reals({ 0, 0, 0, 1, 1, 1 })
    .Sizes({ 1 })
    .Ints({ 30 })
    .Sizes({ 1 })
    .Ints({ 7 })
    .Text("\n$EndEntities\n$Nodes\n")
    .Sizes({ 1, 5, 1, 5 })
    .Ints({ 2, 1, 1 }) // parametric on a surface
    .Sizes({ 5, 1, 2, 3, 4, 5 })
    .Reals({ 0, 0, 0, .1, .2, 1, 0, 0, .1, .2, 0, 1, 0, .1, .2, 0, 0, 1, .1, .2, 1, 1, 1, .1, .2 })
    .Text("\n$EndNodes\n$Elements\n")
    .Sizes({ 3, 3, 10, 12 })
    .Ints({ 2, 7, 2 })
    .Sizes({ 1, 10, 2, 3, 4 })
    .Ints({ 3, 1, 4 })
    .Sizes({ 1, 11, 1, 2, 3, 4 })
    .Ints({ 3, 2, 4 })
    .Sizes({ 1, 12, 2, 3, 4, 5 })
    .Text("\n$EndElements\n$ElementNodeData\n1\n\"u\"\n1\n0\n3\n0\n1\n2\n")
    .Ints({ 11, 4 })
    .Reals({ 1, 2, 3, 4 })
    .Ints({ 12, 4 })
    .Reals({ 2, 3, 4, 5 })
    .Text("\n$EndElementNodeData\n")
    .Data;
}

void ExpectPair(const SolverModel& model)
{
  ASSERT_EQ(model.mesh.number, (std::vector<std::int64_t>{ 11, 12 }));
  const Vec3 x = PointAt(model, 1, { -0.5, -0.5, -0.5 });
  EXPECT_NEAR(x.x, 0.5, 1e-15);
  EXPECT_NEAR(x.y, 0.5, 1e-15);
  EXPECT_NEAR(x.z, 0.5, 1e-15);
}
} // namespace

TEST(GmshReader, BothVersionsAsText)
{
  for (const auto& text : { kPair22, kPair41 })
  {
    const SolverModel model = ReadGmsh(text);
    ExpectPair(model);
    // Without physical groups entities replace them; the face lies between both elements.
    EXPECT_EQ(model.mesh.attribute, (std::vector<std::int32_t>{ 1, 2 }));
    ASSERT_EQ(model.mesh.boundary.size(), 2U);
    EXPECT_EQ(model.mesh.boundary[0].attribute, 7);
    EXPECT_EQ(model.mesh.boundary[0].face, 1); // opposite to the first vertex
    EXPECT_EQ(model.mesh.boundary[1].element, 1);
    EXPECT_EQ(model.mesh.boundary[1].face, 3); // the first three vertices
    EXPECT_TRUE(model.fields.empty());
    EXPECT_TRUE(model.notes.empty());
  }
}

/// Names without a dimension, and a third tag that is the partition.
TEST(GmshReader, Versions20And21)
{
  const std::string elements =
    "$Elements\n3\n10 2 3 5 7 1 2 3 4\n11 4 3 4 1 1 1 2 3 4\n12 4 3 4 2 2 2 3 4 5\n$EndElements\n";
  const auto model = [&](const std::string& version, const std::string& names)
  {
    return ReadGmsh("$MeshFormat\n" + version + " 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n" +
      names + "$EndPhysicalNames\n" + kNodes22 + elements);
  };
  for (const SolverModel& read :
    { model("2.0", "4 \"solid\"\n5 \"wall\"\n"), model("2", "3 4 \"solid\"\n2 5 \"wall\"\n"),
      model("2", "4\"solid\"\n5\"wall\"\n"), model("2.1", "3 4\"solid\"\n2 5 \"wall\"\n") })
  {
    ExpectPair(read);
    EXPECT_TRUE(read.notes.empty());
    EXPECT_EQ(read.mesh.attribute, (std::vector<std::int32_t>{ 4, 4 }));
    ASSERT_EQ(read.mesh.groups.size(), 2U);
    EXPECT_EQ(read.mesh.groups[0].name, "solid");
    EXPECT_FALSE(read.mesh.groups[0].boundary);
    EXPECT_EQ(read.mesh.groups[1].name, "wall");
    EXPECT_TRUE(read.mesh.groups[1].boundary);
  }
}

TEST(GmshReader, BinaryOfBothByteOrders)
{
  for (const bool swapped : { false, true })
  {
    for (const auto& text : { Binary22(swapped), Binary41(swapped) })
    {
      const SolverModel model = ReadGmsh(text);
      ExpectPair(model);
      ASSERT_EQ(model.fields.size(), 1U);
      EXPECT_NEAR(ValueAt(model, 0, 1, { -1, -1, -1 })[0], 2.0, 1e-15);
      EXPECT_NEAR(ValueAt(model, 0, 1, { -1, -1, 1 })[0], 5.0, 1e-15);
    }
  }
}

TEST(GmshReader, BinaryDataNeedNoLineEndBehindThem)
{
  for (std::string text : { Binary22(false), Binary22(true), Binary41(false), Binary41(true) })
  {
    const std::string whole = text;
    for (std::size_t at = text.find("\n$End"); at != std::string::npos; at = text.find("\n$End"))
    {
      text.erase(at, 1);
    }
    ASSERT_LT(text.size(), whole.size());
    const SolverModel model = ReadGmsh(text);
    ExpectPair(model);
    EXPECT_TRUE(model.notes.empty());
    ASSERT_EQ(model.fields.size(), 1U);
    EXPECT_EQ(
      ValueAt(model, 0, 1, { -1, -1, 1 })[0], ValueAt(ReadGmsh(whole), 0, 1, { -1, -1, 1 })[0]);
    ExpectParts(GmshMessage(text.substr(0, text.find("$EndNodes"))), { "$Nodes has no end" });
  }
}

TEST(GmshReader, ALonePartitionNumberIsNoSignOfOthers)
{
  std::string text = kPair22;
  for (const std::string element : { "11 4 2 0 1", "12 4 2 0 2" })
  {
    text.replace(text.find(element), element.size(), element.substr(0, 4) + " 4 0 1 1 2");
  }
  EXPECT_TRUE(ReadGmsh(text).notes.empty());
  const SolverModel model = ReadGmsh(std::string(kFormat41) +
    "$PartitionedEntities\n1\n0\n0 0 0 2\n1 3 1 1 1 0 0 0 1 1 1 1 4 0\n"
    "2 3 2 1 1 0 0 0 1 1 1 1 4 0\n$EndPartitionedEntities\n" +
    kNodes41 + kElements41);
  EXPECT_TRUE(model.notes.empty());
}

TEST(GmshReader, PhysicalGroupsOfVersion41)
{
  const SolverModel model = ReadGmsh(Binary41(false));
  // Element 12 belongs to an entity without a group.
  EXPECT_EQ(model.mesh.attribute, (std::vector<std::int32_t>{ 30, 0 }));
  // Both groups of the surface, the reversed one too, on both sides.
  ASSERT_EQ(model.mesh.boundary.size(), 4U);
  EXPECT_EQ(model.mesh.boundary[0].attribute, 70);
  EXPECT_EQ(model.mesh.boundary[1].attribute, 71);
  ASSERT_EQ(model.mesh.groups.size(), 3U);
  EXPECT_EQ(model.mesh.groups[0].id, 30);
  EXPECT_FALSE(model.mesh.groups[0].boundary);
  EXPECT_TRUE(model.mesh.groups[1].boundary);
}

TEST(GmshReader, ElementsInSeveralGroupsOfVersion22)
{
  // Gmsh writes such an element once for each group, with numbers of their own.
  const SolverModel model = ReadGmsh(std::string(kFormat22) +
    "$PhysicalNames\n2\n3 30 \"inner part\"\n2 5 \"wall\"\n$EndPhysicalNames\n" + kNodes22 +
    "$Elements\n4\n1 2 2 5 7 2 3 4\n2 4 2 30 1 1 2 3 4\n3 4 2 31 1 1 2 3 4\n4 4 2 30 1 2 3 4 5\n"
    "$EndElements\n" +
    View("ElementData", "k", 0, 0, 1, 3, "2 1.5\n3 1.5\n4 2.5\n"));
  EXPECT_EQ(model.mesh.number, (std::vector<std::int64_t>{ 2, 4 }));
  EXPECT_EQ(model.mesh.attribute, (std::vector<std::int32_t>{ 30, 30 }));
  ASSERT_EQ(model.notes.size(), 1U);
  ExpectParts(model.notes[0], { "1 element in several physical groups" });
  ASSERT_EQ(model.mesh.groups.size(), 2U);
  EXPECT_EQ(model.mesh.groups[0].name, "inner part");
  EXPECT_EQ(model.mesh.groups[1].name, "wall");
  EXPECT_EQ(ValueAt(model, 0, 0, { -0.5, -0.5, -0.5 })[0], 1.5);
  EXPECT_EQ(ValueAt(model, 0, 1, { -0.5, -0.5, -0.5 })[0], 2.5);
}

TEST(GmshReader, OnePieceOfAPartitionedMeshIsNoted)
{
  std::string text = kPair22;
  const std::string element = "11 4 2 0 1 1 2 3 4";
  text.replace(text.find(element), element.size(), "11 4 5 0 1 2 1 -2 1 2 3 4");
  const SolverModel old = ReadGmsh(text);
  ASSERT_EQ(old.notes.size(), 1U);
  ExpectParts(old.notes[0], { "1 partition of a mesh of 2", "not the whole mesh" });
  const SolverModel model = ReadGmsh(std::string(kFormat41) +
    "$PartitionedEntities\n3\n0\n0 0 0 1\n1 3 1 1 2 0 0 0 1 1 1 1 4 0\n$EndPartitionedEntities\n" +
    kNodes41 + kElements41);
  ASSERT_EQ(model.notes.size(), 1U);
  ExpectParts(model.notes[0], { "1 partition of a mesh of 3" });
  EXPECT_EQ(model.mesh.attribute, (std::vector<std::int32_t>{ 4, 0 }));
}

TEST(GmshReader, NumbersWithoutAMagnitudeAreRefused)
{
  std::string text = kPair22;
  const std::string element = "11 4 2 0 1 1 2 3 4";
  text.replace(text.find(element), element.size(), "11 4 5 0 1 2 1 -2147483648 1 2 3 4");
  ExpectParts(GmshMessage(text), { "-2147483648", "damaged" });
  const std::string entities = "$Entities\n0 0 0 1\n1 0 0 0 1 1 1 1 -2147483648 0\n$EndEntities\n";
  ExpectParts(GmshMessage(std::string(kFormat41) + entities + kNodes41 + kElements41),
    { "-2147483648", "damaged" });
}

TEST(GmshReader, SparseNumbersAndOtherSections)
{
  const SolverModel model =
    ReadGmsh("$Comments\nanything $here\n$EndComments\n" + std::string(kFormat41) +
      "$Nodes\n2 4 5 90000000000\n0 1 0 1\n90000000000\n0 0 1\n3 1 0 3\n5\n6\n70000\n0 0 0\n1 0 "
      "0\n0 1 0\n$EndNodes\n$Elements\n1 1 8 8\n3 1 4 1\n8 5 6 70000 90000000000\n$EndElements\n"
      "$Periodic\n0\n$EndPeriodic\n$Wishes\n1 2 3\n$EndWishes\n");
  EXPECT_NEAR(PointAt(model, 0, { -1, -1, 1 }).z, 1.0, 1e-15);
  ASSERT_EQ(model.notes.size(), 1U);
  ExpectParts(model.notes[0], { "$Wishes", "not known" });
}

TEST(GmshReader, RefusesWithReasons)
{
  ExpectParts(GmshMessage("(0 \"a Fluent file\")"), { "folder/a.msh", "$MeshFormat" });
  ExpectParts(GmshMessage("$NOD\n1\n1 0 0 0\n$ENDNOD\n"), { "version 1", "msh41" });
  ExpectParts(
    GmshMessage("$MeshFormat\n4.0 0 8\n$EndMeshFormat\n"), { "version 4.0", "2.0 to 2.2 and 4.1" });
  ExpectParts(GmshMessage("$MeshFormat\n4.1 2 8\n$EndMeshFormat\n"), { "file type is 2" });
  ExpectParts(GmshMessage("$MeshFormat\n4.1 0 16\n$EndMeshFormat\n"), { "data size is 16" });
  ExpectParts(GmshMessage(kFormat41), { "no $Nodes" });
  ExpectParts(GmshMessage(std::string(kFormat41) + kNodes41), { "no $Elements" });
  ExpectParts(GmshMessage(kPair41 + kNodes41), { "two sections $Nodes" });
  ExpectParts(GmshMessage(kPair41 + "junk"), { "junk", "line" });
  ExpectParts(GmshMessage(kPair41.substr(0, kPair41.size() - 15)), { "$Elements has no end" });
}

TEST(GmshReader, RefusesDamagedMeshes)
{
  const auto replaced = [](std::string text, const std::string& from, const std::string& to)
  {
    text.replace(text.find(from), from.size(), to);
    return GmshMessage(text);
  };
  ExpectParts(replaced(kPair41, "11 1 2 3 4", "11 1 2 3 9"), { "element 11", "node 9" });
  ExpectParts(replaced(kPair41, "11 1 2 3 4", "12 1 2 3 4"), { "element 12 is there twice" });
  ExpectParts(replaced(kPair41, "1\n2\n3\n", "1\n2\n2\n"), { "node 2 is there twice" });
  ExpectParts(replaced(kPair41, "1 5 1 5", "1 6 1 5"), { "5 nodes, but the section 6" });
  ExpectParts(replaced(kPair41, "1 5 1 5", "1 999999999 1 5"), { "cut short" });
  ExpectParts(replaced(kPair41, "3 3 10 12", "3 4 10 12"), { "3 elements, but the section 4" });
  ExpectParts(replaced(kPair41, "0 0 1\n", "0 nan 1\n"), { "element 11", "NaN" });
  ExpectParts(replaced(kPair41, "0 0 1\n", "0 x 1\n"), { "'x'", "coordinate", "line" });
  ExpectParts(replaced(kPair41, "3 1 4 1", "3 1 35 1"), { "type 35" });
  ExpectParts(replaced(kPair41, "3 1 4 1", "4 1 4 1"), { "dimension 4" });
  ExpectParts(replaced(kPair22, "11 4 2 0 1", "11 4 -1 0 1"), { "-1 tags" });
  EXPECT_EQ(replaced(kPair22, "11 4 2 0 1", "11 4 4 0 1 0 7"), "");
  ExpectParts(replaced(kPair22, "11 4 2 0 1", "11 4 5 0 1 0 7 77"), { "part of another" });
  ExpectParts(replaced(kPair22, "11 4 2 0 1", "11 4 5 0 1 1 1 77"), { "part of another" });
  ExpectParts(GmshMessage(std::string(kFormat22) + kNodes22 +
                "$Elements\n1\n1 32 2 0 1 1 2 3 4 5 1 2 3 4 5 1 2 3 4 5 1 2 3 4 5 1 2\n"
                "$EndElements\n"),
    { "a.msh", "tetrahedra of order 4 with 22 nodes", "complete" });
}
} // namespace pixelexact::testing
