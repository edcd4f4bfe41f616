// SPDX-License-Identifier: BSD-3-Clause
// Fields of Nek5000, nekRS and neko: values, orders, byte orders, parts, and what is refused.
#include "NekFiles.h"
#include "SolverModelViews.h"

#include "Formats/Nek5000/Reader.h"

#include <cmath>
#include <limits>

namespace pixelexact::testing
{
namespace
{
const Vec3 kPlaces[] = { { -0.7, -0.2, 0.5 }, { 0.1, 0.9, -0.6 }, { 0.3, -0.9, 0.0 } };

SolverModel ReadNek(const std::vector<std::string>& parts)
{
  std::vector<NamedText> files;
  files.reserve(parts.size());
  for (const std::string& part : parts)
  {
    files.push_back({ "run/x" + std::to_string(files.size()) + ".f00000", part });
  }
  return nek5000::Read(files, files);
}

SolverModel ReadNek(const NekFile& file)
{
  return ReadNek(std::vector{ file.Text() });
}

void ExpectNekRefusal(const std::string& text, const std::vector<std::string>& parts)
{
  std::vector<std::string> named = parts;
  named.emplace_back("run/x0.f00000");
  ExpectRefusal([&] { ReadNek(std::vector{ text }); }, named);
}

/// Compares map and fields of each element with those of the file.
void ExpectModel(const SolverModel& model, const NekFile& file, double tolerance)
{
  ASSERT_EQ(model.fields.size(), file.fields.size());
  for (int e = 0; e < static_cast<int>(model.mesh.number.size()); ++e)
  {
    const auto number = static_cast<std::int32_t>(model.mesh.number[static_cast<std::size_t>(e)]);
    EXPECT_EQ(number, e + 1);
    for (Vec3 xi : kPlaces)
    {
      xi.z = file.isPlane ? 0.0 : xi.z;
      const Vec3 expected = file.place(number, xi);
      const Vec3 x = PointAt(model, e, xi);
      for (int d = 0; d < (file.isPlane ? 2 : 3); ++d)
      {
        EXPECT_NEAR(x[d], expected[d], tolerance);
      }
      for (std::size_t f = 0; f < file.fields.size(); ++f)
      {
        const auto value = ValueAt(model, f, e, xi);
        ASSERT_EQ(value.size(), static_cast<std::size_t>(file.fields[f].components));
        for (int c = 0; c < file.fields[f].components; ++c)
        {
          EXPECT_NEAR(
            value[static_cast<std::size_t>(c)], file.fields[f].values(expected, c), 10 * tolerance);
        }
      }
    }
  }
}

/// The file of order n whose values are polynomials of this order.
NekFile OfOrder(int n)
{
  NekFile file;
  file.nodes = n + 1;
  file.place = [](std::int32_t number, const Vec3& xi)
  { return Vec3(2.0 * number + xi.x + 0.25 * xi.y, xi.y, 0.5 * xi.z - 0.125 * xi.x); };
  file.fields[1].values = [n](const Vec3& x, int)
  { return std::pow(0.25 * x.x, n) - std::pow(x.z, n) + std::pow(x.y, n); };
  return file;
}
} // namespace

TEST(NekReader, EveryOrderHoldsItsPolynomials)
{
  for (const int n : { 1, 2, 3, 7, 11, 32 })
  {
    const NekFile file = OfOrder(n);
    ExpectModel(ReadNek(file), file, n < 12 ? 1e-14 : 1e-13);
  }
}

TEST(NekReader, MapsHaveTheOrdersThatTheirNodesNeed)
{
  for (const bool isPlane : { false, true })
  {
    for (const int word : { 4, 8 })
    {
      NekFile file;
      file.nodes = 6;
      file.isPlane = isPlane;
      file.word = word;
      file.fields[0].components = isPlane ? 2 : 3;
      const SolverModel curved = ReadNek(file);
      EXPECT_EQ(curved.mesh.map.SpaceOf(1).order, (std::array<std::uint8_t, 3>{ 2, 1, 1 }));
      EXPECT_EQ(curved.fields[1].values.SpaceOf(1).order[0], 5);
      ExpectModel(curved, file, word == 4 ? 1e-6 : 1e-14);
      file.place = [](std::int32_t number, const Vec3& xi) {
        return Vec3(2.0 * number + xi.x + (number == 2 ? 1e-4 * std::pow(xi.y, 5) : 0), xi.y, xi.z);
      };
      const SolverModel mixed = ReadNek(file);
      EXPECT_EQ(mixed.mesh.map.SpaceOf(0).order, (std::array<std::uint8_t, 3>{ 1, 1, 1 }));
      if (word == 8)
      {
        EXPECT_EQ(mixed.mesh.map.SpaceOf(1).order, (std::array<std::uint8_t, 3>{ 1, 5, 1 }));
      }
      ExpectModel(mixed, file, word == 4 ? 2e-6 : 1e-14);
    }
  }
}

TEST(NekReader, PrecisionsAndByteOrders)
{
  for (const bool isSwapped : { false, true })
  {
    NekFile file;
    file.isSwapped = isSwapped;
    const SolverModel exact = ReadNek(file);
    ExpectModel(exact, file, 1e-14);
    file.word = 4;
    const SolverModel single = ReadNek(file);
    ExpectModel(single, file, 1e-6);
    // The uncertainty covers the rounding of the coordinates.
    EXPECT_LT(exact.mesh.uncertainty[0], 1e-13);
    EXPECT_GT(single.mesh.uncertainty[0], 2.0 * 3.125 * 0x1p-24);
    EXPECT_LT(single.mesh.uncertainty[0], 1e-4);
  }
}

TEST(NekReader, ModelOfAStep)
{
  NekFile file;
  file.hasRanges = true;
  file.codes = "XUPTS03";
  file.tail = "  1.0000000E+00 F";
  file.fields.push_back({ 1, [](const Vec3& x, int) { return x.x; } });
  for (int s = 1; s <= 3; ++s)
  {
    file.fields.push_back({ 1, [s](const Vec3& x, int) { return x.y + s; } });
  }
  const SolverModel model = ReadNek(file);
  ExpectModel(model, file, 1e-14);
  std::vector<std::string> names;
  for (const SolverField& field : model.fields)
  {
    names.push_back(field.name);
    EXPECT_FALSE(field.continuous);
  }
  EXPECT_EQ(
    names, (std::vector<std::string>{ "velocity", "pressure", "temperature", "s1", "s2", "s3" }));
  EXPECT_TRUE(model.notes.empty());
  EXPECT_FALSE(model.mesh.slab);
}

TEST(NekReader, PlaneMeshesAreSlabs)
{
  NekFile file;
  file.isPlane = true;
  file.fields[0].components = 2;
  for (const bool hasRanges : { false, true })
  {
    file.hasRanges = hasRanges;
    const SolverModel model = ReadNek(file);
    ASSERT_TRUE(model.mesh.slab);
    EXPECT_EQ(model.mesh.slab->middle, 0.0);
    ExpectModel(model, file, 1e-14);
  }
}

TEST(NekReader, ElementsStandByTheirNumbersInAnyPart)
{
  NekFile first;
  first.numbers = { 4, 1 };
  first.total = 5;
  first.parts = 2;
  NekFile second = first;
  second.numbers = { 3, 5, 2 };
  second.part = 1;
  second.word = 4;
  second.isSwapped = true;
  const SolverModel model = ReadNek({ first.Text(), second.Text() });
  EXPECT_EQ(model.mesh.number, (std::vector<std::int64_t>{ 1, 2, 3, 4, 5 }));
  ExpectModel(model, first, 2e-6);

  const auto refuses = [](const NekFile& a, const NekFile& b, const std::vector<std::string>& parts)
  {
    ExpectRefusal([&] { ReadNek({ a.Text(), b.Text() }); }, parts);
  };
  refuses(second, first, { "run/x0.f00000", "is part 1 of 2", "in the place of part 0" });
  NekFile other = second;
  other.time = 1.0;
  refuses(first, other, { "run/x1.f00000", "are not those of run/x0.f00000" });
  other = second;
  other.numbers = { 3, 5, 1 };
  refuses(first, other, { "run/x1.f00000", "element 1 occurs twice" });
  other.numbers = { 3, 5, 6 };
  refuses(first, other, { "run/x1.f00000", "number 6", "1 to 5" });
  other.numbers = { 3, 5 };
  refuses(first, other, { "5 elements in 2 files", "4 in 2" });
  ExpectNekRefusal(first.Text(), { "5 elements in 2 files", "2 in 1" });
}

TEST(NekReader, MeshOfAnotherStep)
{
  NekFile first;
  NekFile second;
  second.codes = "UP";
  second.numbers = { 2, 1 };
  const std::string mesh = first.Text();
  const std::string step = second.Text();
  const std::vector<NamedText> meshes{ { "run/x0.f00000", mesh } };
  const std::vector<NamedText> steps{ { "run/x0.f00001", step } };
  ExpectModel(nek5000::Read(steps, meshes), second, 1e-14);
  const SolverModel fields = nek5000::Read(steps, {});
  EXPECT_TRUE(fields.mesh.number.empty());
  EXPECT_EQ(fields.fields.size(), 2U);
  ExpectRefusal([&] { nek5000::Read(steps, steps); }, { "run/x0.f00001", "no mesh" });
}

TEST(NekReader, NekoCountsItsOnlyFileFromOne)
{
  NekFile file;
  file.part = 1;
  file.codes = "XUPS00";
  ExpectModel(ReadNek(file), file, 1e-14);
}

TEST(NekReader, ValuesThatAreNotFinite)
{
  NekFile file;
  file.fields[1].values = [](const Vec3& x, int)
  { return x.x < 2.0 ? std::numeric_limits<double>::infinity() : 1.0; };
  const SolverModel model = ReadNek(file);
  ASSERT_EQ(model.notes.size(), 1U);
  EXPECT_NE(model.notes[0].find("'pressure' is NaN or infinite at nodes of 1 of 2 elements"),
    std::string::npos)
    << model.notes[0];
  EXPECT_TRUE(std::isnan(ValueAt(model, 1, 0, kPlaces[0])[0]));
  EXPECT_NEAR(ValueAt(model, 1, 1, kPlaces[0])[0], 1.0, 1e-15);
  file.place = [](std::int32_t, const Vec3&) { return Vec3(std::nan("")); };
  ExpectNekRefusal(file.Text(), { "element 1", "NaN" });
}

TEST(NekReader, PressureOfRestartsIsLeftOut)
{
  NekFile file;
  file.codes = "XUPT";
  file.tail = "  1.0000000E+00 T";
  file.fields.push_back({ 1, [](const Vec3& x, int) { return x.x; } });
  const SolverModel model = ReadNek(file);
  ASSERT_EQ(model.fields.size(), 2U);
  EXPECT_EQ(model.fields[1].name, "temperature");
  const double x = file.place(1, kPlaces[0]).x;
  EXPECT_NEAR(ValueAt(model, 1, 0, kPlaces[0])[0], x, 1e-14);
  ASSERT_EQ(model.notes.size(), 1U);
  EXPECT_NE(model.notes[0].find("the pressure has values at other nodes"), std::string::npos);
}

TEST(NekReader, DamagedFilesAreRefused)
{
  const NekFile file;
  const std::string text = file.Text();
  ExpectNekRefusal(text.substr(0, text.size() - 8), { "cut short" });
  ExpectNekRefusal(text.substr(0, 140), { "cut short" });
  ExpectNekRefusal(text.substr(0, 100), { "ends within the header" });
  ExpectNekRefusal(text + std::string(24, '\0'), { "damaged" });
  ExpectNekRefusal("", { "does not begin with '#std'" });
  ExpectNekRefusal("\x89HDF", { "does not begin with '#std'" });
  ExpectNekRefusal(Replaced(text, "#std", "#max"), { "'#max'", "#std" });
  std::string tag = text;
  tag[133] = '\x11';
  ExpectNekRefusal(tag, { "6.54321", "byte order" });
  const auto refuses =
    [&](const std::string& from, const std::string& to, const std::vector<std::string>& parts)
  { ExpectNekRefusal(Replaced(text, from, to), parts); };
  refuses("#std 8", "#std 2", { "2 bytes", "4 and 8" });
  refuses(" 3  3  3 ", "34  3  3 ", { "34 nodes", "at most 33" });
  refuses(" 3  3  3 ", " 1  3  3 ", { "one node" });
  refuses(" 3  3  3 ", " 3  0  3 ", { "'0'", "nodes" });
  refuses(" 3  3  3 ", " 3  x  3 ", { "'x'", "nodes" });
  refuses("         2 ", "2147483647 ", { "2147483647 elements", "cut short" });
  refuses("         2 ", "3000000000 ", { "3000000000", "number of elements" });
  refuses("         2 ", "        -2 ", { "'-2'" });
  refuses("0.0000000000000E+00", "               NaN ", { "time" });
  refuses("     0      1 XUP", "     0      0 XUP", { "number of files" });
  refuses("     0      1 XUP", "     3      2 XUP", { "3", "counted from 0, of 2" });
  refuses("XUP ", "XUQ ", { "'Q' is not known", "XUQ" });
  refuses("XUP ", "XPU ", { "'U' is in a place", "XPU" });
  refuses("XUP ", "XUS3", { "two digits" });
  refuses("XUP ", "XUPT", { "cut short" });
  ExpectNekRefusal(
    "    8    6    6    6  0.50000E+00   100 X U P T", { ".fld", "2008", "param(66)" });
  NekFile twice;
  twice.numbers = { 2, 2 };
  ExpectNekRefusal(twice.Text(), { "element 2 occurs twice" });
  twice.numbers = { 0, 1 };
  ExpectNekRefusal(twice.Text(), { "number 0", "1 to 2" });
}
} // namespace pixelexact::testing
