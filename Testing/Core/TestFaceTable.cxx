// SPDX-License-Identifier: BSD-3-Clause
// What lies behind faces, in meshes made so that it is known: counted in closed form, and held
// against Gauss' theorem.
#include "CurvedMeshes.h"
#include "FaceCounts.h"

#include <gtest/gtest.h>

#include <chrono>

namespace pixelexact::testing
{
namespace
{
} // namespace

struct FaceCase
{
  const char* name;
  CurvedMesh (*make)();
  Counts counts;
};

class FacesOfMeshes : public ::testing::TestWithParam<FaceCase>
{
};

TEST_P(FacesOfMeshes, AreWhatTheyWereMadeAs)
{
  const CurvedMesh made = GetParam().make();
  const Mesh mesh = made.View();
  const ElementIndex index(mesh);
  const FaceTable faces(index);
  EXPECT_EQ(CountsOf(faces), GetParam().counts);
  ExpectNeighboursAgree(mesh, faces);
  ExpectClosed(mesh, faces);
}

// n^3 blocks have 6 n^2 sides on the boundary and twice 3 n^2 (n - 1) inside; a side is two
// triangles of tetrahedra, and of prisms in one direction of three.
INSTANTIATE_TEST_SUITE_P(Made, FacesOfMeshes,
  ::testing::Values(
    FaceCase{ "Hexahedra", [] { return Blocks(3, kHexahedra); }, { 54, 108, 0, 0 } },
    FaceCase{ "Prisms", [] { return Blocks(3, kPrisms); }, { 72, 27 * 10 - 72, 0, 0 } },
    FaceCase{ "Tetrahedra", [] { return Blocks(2, kTetrahedra); }, { 48, 8 * 24 - 48, 0, 0 } },
    FaceCase{ "Pyramids", [] { return Blocks(2, kPyramids); }, { 24, 8 * 30 - 24, 0, 0 } },
    FaceCase{
      "HexahedraThin", [] { return Blocks(3, kHexahedra, kThinPlacement); }, { 54, 108, 0, 0 } },
    FaceCase{
      "TetrahedraFar", [] { return Blocks(2, kTetrahedra, kFarPlacement); }, { 48, 144, 0, 0 } },
    // Blocks 1, 2, 4 and 7 are refined: 12 sides between large and small, each 1 to 4, less those
    // of the small block that is refined once more. Counted below by its sides.
    FaceCase{ "Hanging", [] { return Hanging(kHexahedra); }, { 66, 114, 78, 0 } }),
  [](const auto& test) { return std::string(test.param.name); });

TEST(FaceTable, AQuadrilateralAgainstTwoTrianglesHangs)
{
  for (const auto& make : { +[] { return Blocks(3, kMixed); }, +[] { return Hanging(kMixed); },
         +[] { return Blocks(3, kMixed, kThinPlacement); } })
  {
    const CurvedMesh made = make();
    const Mesh mesh = made.View();
    const ElementIndex index(mesh);
    const FaceTable faces(index);
    EXPECT_GT(faces.CountOf(FaceKind::Hanging), 0);
    EXPECT_EQ(faces.CountOf(FaceKind::Partly), 0);
    ExpectNeighboursAgree(mesh, faces);
    ExpectClosed(mesh, faces);
  }
}

/// The corners agree, and the edges; the faces part between them, by a gap or by an overlap.
/// A slit that opens between two elements of a block that is otherwise whole.
/// The same elements twice: neither is behind the other.
/// An element that meets itself, as periodic meshes of one element do: its ends stay boundary.
/// A hexahedron whose upper face is one edge beside one whose side is a triangle: a quadrilateral
/// with two corners in one place.
/// A quadrilateral with two corners in one place against a triangle: other corners, the same face.
/// Mirrored elements (det J < 0 throughout) have their outside where others have it.
TEST(FaceTable, AnEmptyMeshHasNone)
{
  const MeshBuilder mesh;
  EXPECT_EQ(TableOf(mesh).Faces(), 0);
}

/// $PIXELEXACT_FACE_ELEMENTS: cubes of order 1 and 3, with what their table takes.
TEST(FaceTable, CostOfManyElements)
{
  const char* asked = std::getenv("PIXELEXACT_FACE_ELEMENTS");
  const int n = static_cast<int>(std::lround(std::cbrt(asked ? std::atof(asked) : 1000.0)));
  for (const bool cubic : { false, true })
  {
    // All are one cube, moved: its coefficients serve them all.
    MeshBuilder one;
    AddCube(
      one, Vec3(0.0), cubic ? MeshBuilder::Map([](const LongVec3& x) { return x; }) : nullptr);
    const std::vector<std::int32_t> spaceOf(static_cast<std::size_t>(n) * n * n, 0);
    const std::vector<std::int64_t> offset(spaceOf.size(), 0);
    const std::vector<double> size(spaceOf.size(), 1.0);
    const std::vector<double> uncertainty(spaceOf.size(), 0.0);
    std::vector<double> centre;
    for (int i = 0; i < n * n * n; ++i)
    {
      centre.push_back(i % n);
      const int row = i / n % n;
      const int layer = i / n / n;
      centre.insert(centre.end(), { 1.0 * row, 1.0 * layer });
    }
    Mesh view = one.View();
    view.map.spaceOf = spaceOf;
    view.map.offset = offset;
    view.centre = centre;
    view.size = size;
    view.uncertainty = uncertainty;
    const ElementIndex index(view);
    const auto begin = std::chrono::steady_clock::now();
    const FaceTable faces(index);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    const std::int64_t side = std::int64_t{ n } * n;
    EXPECT_EQ(CountsOf(faces), (Counts{ 6 * side, 6 * side * n - 6 * side, 0, 0 }));
    std::printf("[ measured ] %d hexahedra of order %d: %.0f ns a face, %.1f bytes a face\n",
      n * n * n, cubic ? 3 : 1, seconds.count() * 1e9 / static_cast<double>(faces.Faces()),
      static_cast<double>(faces.MemoryUsage()) / static_cast<double>(faces.Faces()));
  }
}
} // namespace pixelexact::testing
