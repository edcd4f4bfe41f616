// SPDX-License-Identifier: BSD-3-Clause
// Views of Gmsh files as fields.
#include "GmshTexts.h"
#include "SolverModelViews.h"

#include <cmath>

namespace pixelexact::testing
{
namespace
{
const std::string kNodal = "1 1\n2 2\n3 3\n4 4\n5 5\n";

std::vector<double> TimesOf(const std::string& text)
{
  return gmsh::ReadTimes({ { "folder/a.msh", text } });
}

std::string Named(
  const std::string& scheme, const std::string& section, int count, const std::string& values)
{
  return "$" + section + "\n2\n\"q\"\n\"" + scheme + "\"\n0\n3\n0\n1\n" + std::to_string(count) +
    "\n" + values + "$End" + section + "\n";
}

/// The functions 1, u, v, w u on tetrahedra.
const std::string kScheme = "$InterpolationScheme\n\"S\"\n2\n5\n2\n4 4\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
                            "0 0 0 1\n4 3\n0 0 0\n1 0 0\n0 1 0\n1 0 1\n3\n2\n1 1\n1\n1 2\n0 0\n"
                            "$EndInterpolationScheme\n";
} // namespace

TEST(GmshViews, NamesWithoutQuotationMarks)
{
  const SolverModel model =
    ReadGmsh(kPair22 + "$NodeData\n1\nlength of all \n0\n3\n0\n1\n5\n" + kNodal + "$EndNodeData\n");
  ASSERT_EQ(model.fields.size(), 1U);
  EXPECT_EQ(model.fields[0].name, "length of all");
}

TEST(GmshViews, ScalarsVectorsAndTensors)
{
  std::string vectors;
  std::string tensors;
  for (int node = 1; node <= 5; ++node)
  {
    const std::string n = std::to_string(node);
    vectors += n + " " + n + " 0 -" + n + "\n";
    tensors += n + " 1 2 3 4 5 6 7 8 " + n + "\n";
  }
  const SolverModel model = ReadGmsh(kPair41 + View("NodeData", "u", 0, 0, 1, 5, kNodal) +
    View("NodeData", "v", 0, 0, 3, 5, vectors) + View("NodeData", "t", 0, 0, 9, 5, tensors));
  ASSERT_EQ(model.fields.size(), 3U);
  const Vec3 xi(-0.5, -0.5, -0.5); // a quarter of each vertex
  EXPECT_NEAR(ValueAt(model, 0, 0, xi)[0], 2.5, 1e-15);
  EXPECT_NEAR(ValueAt(model, 1, 1, xi)[2], -3.5, 1e-15);
  EXPECT_NEAR(ValueAt(model, 2, 1, xi)[8], 3.5, 1e-15);
  EXPECT_TRUE(model.fields[0].continuous);
  EXPECT_TRUE(model.notes.empty());
}

TEST(GmshViews, ElementsWithoutValuesAreNaN)
{
  const SolverModel model =
    ReadGmsh(kPair41 + View("NodeData", "u", 0, 0, 1, 5, "1 1\n2 2\n3 3\n4 4\n9 5\n") +
      View("ElementData", "k", 0, 0, 1, 2, "12 7\n10 1\n"));
  EXPECT_NEAR(ValueAt(model, 0, 0, { -1, -1, 1 })[0], 4.0, 1e-15);
  EXPECT_TRUE(std::isnan(ValueAt(model, 0, 1, { -1, -1, 1 })[0]));
  EXPECT_TRUE(std::isnan(ValueAt(model, 1, 0, { -1, -1, 1 })[0]));
  EXPECT_EQ(ValueAt(model, 1, 1, { -1, -1, 1 })[0], 7.0);
  EXPECT_FALSE(model.fields[0].continuous);
  ASSERT_EQ(model.notes.size(), 3U);
  ExpectParts(model.notes[0], { "'u'", "1 value at nodes that the mesh does not have" });
  ExpectParts(model.notes[1], { "'u'", "1 of 2 elements", "NaN" });
  ExpectParts(model.notes[2], { "'k'", "1 of 2 elements", "NaN" });
}

TEST(GmshViews, OfSurfacesAloneAreLeftOut)
{
  const SolverModel model = ReadGmsh(kPair41 + View("ElementData", "flux", 0, 0, 1, 1, "10 3\n") +
    "$GaussPointData\n1\n$EndGaussPointData\n");
  EXPECT_TRUE(model.fields.empty());
  ASSERT_EQ(model.notes.size(), 2U);
  ExpectParts(model.notes[0], { "integration points" });
  ExpectParts(model.notes[1], { "'flux'", "left out" });
}

TEST(GmshViews, StepsWithTimes)
{
  const std::string text = kPair41 + View("NodeData", "u", 0.5, 0, 1, 5, kNodal) +
    View("NodeData", "u", 0.75, 2, 1, 5, "1 2\n2 2\n3 2\n4 2\n5 2\n") +
    View("ElementData", "k", 0.5, 0, 1, 2, "11 1\n12 2\n");
  EXPECT_EQ(TimesOf(text), (std::vector<double>{ 0.5, 0.75 }));
  const SolverModel later = ReadGmsh(text, {}, 1);
  ASSERT_EQ(later.fields.size(), 2U); // what has one step has it always
  EXPECT_NEAR(ValueAt(later, 0, 0, { 0, -1, -1 })[0], 2.0, 1e-15);
  EXPECT_NEAR(ValueAt(later, 1, 1, { 0, -1, -1 })[0], 2.0, 1e-15);
  EXPECT_TRUE(TimesOf(kPair41 + View("NodeData", "u", 0, 0, 1, 5, kNodal)).empty());
  EXPECT_TRUE(TimesOf(kPair41).empty());
}

TEST(GmshViews, StepsWhoseTimesDoNotAscendAreNumbered)
{
  // Times do not ascend, as for eigenmodes, whose time is their frequency.
  const std::string text = kPair41 + View("NodeData", "u", 5, 0, 1, 5, kNodal) +
    View("NodeData", "u", 5, 1, 1, 5, kNodal) + View("NodeData", "w", 5, 0, 1, 5, kNodal) +
    View("NodeData", "w", 5, 2, 1, 5, kNodal);
  EXPECT_EQ(TimesOf(text), (std::vector<double>{ 0, 1, 2 }));
  const SolverModel model = ReadGmsh(text, {}, 1);
  ASSERT_EQ(model.fields.size(), 1U);
  ASSERT_EQ(model.notes.size(), 2U);
  ExpectParts(model.notes[0], { "do not ascend" });
  ExpectParts(model.notes[1], { "'w'", "step 1", "left out" });
}

TEST(GmshViews, PartitionsOfAViewAreOne)
{
  const auto part = [](int partition, const std::string& values)
  {
    return "$NodeData\n1\n\"u\"\n1\n0\n4\n0\n1\n3\n" + std::to_string(partition) + "\n" + values +
      "$EndNodeData\n";
  };
  const SolverModel model =
    ReadGmsh(kPair41 + part(1, "1 1\n2 2\n3 3\n") + part(2, "3 3\n4 4\n5 5\n"));
  EXPECT_TRUE(model.notes.empty());
  EXPECT_NEAR(ValueAt(model, 0, 1, { -1, -1, 1 })[0], 5.0, 1e-15);
}

TEST(GmshViews, InterpolationSchemes)
{
  const SolverModel model =
    ReadGmsh(kPair41 + kScheme + Named("S", "ElementNodeData", 2, "11 4 1 2 3 4\n12 4 0 0 0 1\n"));
  ASSERT_EQ(model.fields.size(), 1U);
  // u = 0.6, v = 0.1, w = 0.2
  const Vec3 xi(0.2, -0.8, -0.6);
  EXPECT_NEAR(ValueAt(model, 0, 0, xi)[0], 1 + 2 * 0.6 + 3 * 0.1 + 4 * 0.6 * 0.2, 1e-15);
  EXPECT_NEAR(ValueAt(model, 0, 1, xi)[0], 0.12, 1e-15);
  ExpectParts(model.fields[0].basis, { "scheme 'S'" });
}

TEST(GmshViews, ASchemeCountsForTheViewsBehindIt)
{
  // Gmsh writes one scheme for each view, all of one name.
  std::string constant = kScheme;
  const std::string matrices = "4 4\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n4 3\n0 0 0\n1 0 0\n0 1 "
                               "0\n1 0 1\n";
  constant.replace(constant.find(matrices), matrices.size(), "1 1\n1\n1 3\n0 0 0\n");
  std::string second = Named("S", "ElementData", 2, "11 4\n12 5\n");
  second.replace(second.find("\"q\""), 3, "\"c\"");
  const SolverModel model = ReadGmsh(kPair41 + kScheme +
    Named("S", "ElementNodeData", 2, "11 4 1 2 3 4\n12 4 0 0 0 1\n") + constant + second);
  ASSERT_EQ(model.fields.size(), 2U);
  EXPECT_NEAR(ValueAt(model, 0, 1, { 0.2, -0.8, -0.6 })[0], 0.12, 1e-15);
  EXPECT_NEAR(ValueAt(model, 1, 1, { 0.2, -0.8, -0.6 })[0], 5.0, 1e-15);
}

TEST(GmshViews, FilesOfTheirOwn)
{
  const std::string view = std::string(kFormat22) + View("NodeData", "", 0, 0, 1, 5, kNodal);
  const SolverModel model = ReadGmsh(kPair41, { view });
  ASSERT_EQ(model.fields.size(), 1U);
  EXPECT_EQ(model.fields[0].name, "view"); // the file's
  ExpectParts(GmshMessage(view), { "a.msh", "no $Nodes" });
  ExpectParts(GmshMessage(kPair41, { kPair22 }), { "view.msh", "mesh of its own" });
}

TEST(GmshViews, RefusesWithReasons)
{
  const auto message = [](const std::string& view) { return GmshMessage(kPair41 + view); };
  const std::string view = View("NodeData", "u", 0, 0, 1, 5, kNodal);
  ExpectParts(message(view + view), { "'u'", "twice", "step 0" });
  ExpectParts(message(view + View("ElementData", "u", 0, 0, 1, 1, "11 1\n")), { "rename" });
  ExpectParts(message(View("NodeData", "u", 0, 0, 2, 5, kNodal)), { "2 components", "1, 3 and 9" });
  ExpectParts(message(View("NodeData", "u", 0, 0, 1, 4, kNodal)), { "'$EndNodeData'" });
  ExpectParts(message(View("NodeData", "u", 0, 0, 1, 99999, kNodal)), { "99999", "cut short" });
  ExpectParts(message(View("ElementNodeData", "u", 0, 0, 1, 1, "11 2 1 1\n")),
    { "2 values", "element 11", "4 nodes" });
  ExpectParts(message(View("ElementNodeData", "u", 0, 0, 1, 1, "11 0\n")), { "0 values" });
  ExpectParts(message(Named("T", "ElementNodeData", 1, "11 4 1 2 3 4\n")), { "'T'", "before it" });
  ExpectParts(message(kScheme + Named("S", "ElementNodeData", 1, "11 3 1 2 3\n")),
    { "3 values", "4 functions" });
  const auto scheme = [&](const std::string& from, const std::string& to)
  {
    std::string changed = kScheme;
    changed.replace(changed.find(from), from.size(), to);
    return message(changed + Named("S", "ElementNodeData", 1, "11 4 1 2 3 4\n"));
  };
  ExpectParts(scheme("5\n2\n4 4", "5\n4\n4 4"), { "4 matrices", "geometry" });
  ExpectParts(scheme("4 4\n", "3 4\n"), { "square" });
  ExpectParts(scheme("4 3\n", "4 2\n"), { "three for each of its 4" });
  ExpectParts(scheme("1 0 1\n", "1 0 0.5\n"), { "whole number" });
  ExpectParts(scheme("1 0 1\n", "1 30 1\n"), { "a.msh", "'q'", "'S'", "orders" });
  ExpectParts(message("$NodeData\n1\n\"u\"\n1\nnan\n3\n0\n1\n5\n" + kNodal + "$EndNodeData\n"),
    { "time", "finite" });
}
} // namespace pixelexact::testing
