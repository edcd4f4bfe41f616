// SPDX-License-Identifier: BSD-3-Clause
// INLINE meshes of MFEM: boxes, by their numbers.
#include "SolverModelViews.h"

#include "Core/Base/Error.h"
#include "Formats/MFEM/Reader.h"

#include <gtest/gtest.h>

#include <map>

namespace pixelexact::testing
{
namespace
{
SolverModel ReadBox(const std::string& entries)
{
  const std::string text = "MFEM INLINE mesh v1.0\n\n" + entries;
  return mfem::Read({ "a.mesh", text }, {});
}

void ExpectBoxRefusal(const std::string& entries, const std::vector<std::string>& parts)
{
  ExpectRefusal([&] { ReadBox(entries); }, parts);
}

struct Kind
{
  const char* type;
  int perCell;
  int dimension;
};
constexpr Kind kKinds[] = { { "tri", 2, 2 }, { "quad", 1, 2 }, { "tet", 6, 3 }, { "wedge", 2, 3 },
  { "hex", 1, 3 }, { "pyramid", 6, 3 } };

/// The elements are images of affine maps: det J is the same all over each of them.
double VolumeOf(const SolverModel& model, int element)
{
  const double step = 1e-3;
  const Mesh mesh = ViewOf(model.mesh);
  const Vec3 centre = TensorToReference(mesh.ShapeOf(element), Vec3(0.0));
  const auto along = [&](const Vec3& direction)
  {
    const Vec3 forth = PointAt(model, element, centre + step * direction);
    const Vec3 back = PointAt(model, element, centre - step * direction);
    return (forth - back) / (2 * step);
  };
  const Vec3 a = along({ 1, 0, 0 });
  const Vec3 b = along({ 0, 1, 0 });
  const Vec3 c = along({ 0, 0, 1 });
  const double determinant =
    a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) + a.z * (b.x * c.y - b.y * c.x);
  // Volumes of the reference elements.
  const std::map<Shape, double> volume{ { Shape::Hexahedron, 8.0 }, { Shape::Prism, 4.0 },
    { Shape::Tetrahedron, 4.0 / 3 }, { Shape::Pyramid, 8.0 / 3 } };
  return determinant * volume.at(mesh.ShapeOf(element));
}
} // namespace

TEST(MfemInline, ElementsFillTheBox)
{
  for (const Kind& kind : kKinds)
  {
    const SolverModel model = ReadBox(std::string("type = ") + kind.type + "\nnx = 3\nny = 2\n" +
      (kind.dimension == 3 ? "nz = 1; sz = 0.5\n" : "") + "sx = 6.0\nsy=1;\n");
    const int cells = 6 * kind.perCell;
    ASSERT_EQ(static_cast<int>(model.mesh.number.size()), cells) << kind.type;
    double sum = 0.0;
    for (int e = 0; e < cells; ++e)
    {
      const double volume = VolumeOf(model, e);
      EXPECT_GT(volume, 0.0) << kind.type << " " << e;
      sum += volume;
    }
    const double height = model.mesh.slab ? model.mesh.slab->thickness : 0.5;
    EXPECT_NEAR(sum, 6 * height, 1e-11) << kind.type;
    EXPECT_TRUE(model.notes.empty());
  }
}

/// MFEM's attributes of sides, by the number of faces in each.
TEST(MfemInline, SidesHaveMfemsAttributes)
{
  const auto count = [](const SolverModel& model)
  {
    std::map<int, int> faces;
    for (const BoundaryFace& face : model.mesh.boundary)
    {
      ++faces[face.attribute];
    }
    return faces;
  };
  const std::string plane = "nx = 3\nny = 2\nsx = 1\nsy = 1\n";
  EXPECT_EQ(count(ReadBox("type = quad\n" + plane)),
    (std::map<int, int>{ { 1, 3 }, { 2, 2 }, { 3, 3 }, { 4, 2 } }));
  EXPECT_EQ(count(ReadBox("type = tri\n" + plane)),
    (std::map<int, int>{ { 1, 3 }, { 2, 2 }, { 3, 3 }, { 4, 2 } }));
  const std::string solid = plane + "nz = 1\nsz = 1\n";
  // The attributes are those below in z, y, x, then those above in x, y, z.
  EXPECT_EQ(count(ReadBox("type = hex\n" + solid)),
    (std::map<int, int>{ { 1, 6 }, { 2, 3 }, { 3, 2 }, { 4, 3 }, { 5, 2 }, { 6, 6 } }));
  EXPECT_EQ(count(ReadBox("type = wedge\n" + solid)),
    (std::map<int, int>{ { 1, 12 }, { 2, 3 }, { 3, 2 }, { 4, 3 }, { 5, 2 }, { 6, 12 } }));
  EXPECT_EQ(count(ReadBox("type = tet\n" + solid)),
    (std::map<int, int>{ { 1, 12 }, { 2, 6 }, { 3, 4 }, { 4, 6 }, { 5, 4 }, { 6, 12 } }));
  EXPECT_EQ(count(ReadBox("type = pyramid\n" + solid)),
    (std::map<int, int>{ { 1, 6 }, { 2, 3 }, { 3, 2 }, { 4, 3 }, { 5, 2 }, { 6, 6 } }));
}

TEST(MfemInline, Refusals)
{
  const std::string plane = "nx = 3\nny = 2\nsx = 1\nsy = 1\n";
  ExpectBoxRefusal("type = segment\nnx = 2\nsx = 1\n", { "a.mesh, line", "1-dimensional" });
  ExpectBoxRefusal("type = disc\n" + plane, { "'disc'", "pyramid" });
  ExpectBoxRefusal(plane, { "type ''" });
  ExpectBoxRefusal("type = hex\n" + plane, { "'nz'", "positive whole number" });
  ExpectBoxRefusal("type = quad\nnz = 1\n" + plane, { "'nz' is no entry" });
  ExpectBoxRefusal("type = quad\nnx = 3\n" + plane, { "twice" });
  ExpectBoxRefusal("type = quad\nnx 3\n", { "'nx 3'", "nx = 4" });
  ExpectBoxRefusal("type = quad\nnx = 3.5\nny = 1\nsx = 1\nsy = 1\n", { "'nx'", "3.5" });
  ExpectBoxRefusal("type = quad\nnx = 3\nny = 1\nsx = -1\nsy = 1\n", { "'sx'", "-1" });
  ExpectBoxRefusal(
    "type = quad\nnx = 1000000\nny = 1000000\nsx = 1\nsy = 1\n", { "a million elements" });
  const std::string text = "MFEM INLINE mesh v1.0\n\ntype = quad\n" + plane;
  const std::string field =
    "FiniteElementSpace\nFiniteElementCollection: L2_2D_P0\nVDim: 1\nOrdering: 0\n\n1 2 3 4 5 6";
  try
  {
    mfem::Read({ "a.mesh", text }, { { "u.gf", field } });
    ADD_FAILURE() << "was read";
  }
  catch (const Unsupported& error)
  {
    EXPECT_NE(std::string(error.what()).find("Mesh::Save"), std::string::npos) << error.what();
  }
}
} // namespace pixelexact::testing
