// SPDX-License-Identifier: BSD-3-Clause
// What lies behind faces, in meshes made so that it is known: counted in closed form, and held
// against Gauss' theorem.
#include "ClosedSurface.h"
#include "CurvedMeshes.h"

#include <gtest/gtest.h>

#include <chrono>

namespace pixelexact::testing
{
namespace
{
constexpr Shape kHexahedra[] = { Shape::Hexahedron };
constexpr Shape kPrisms[] = { Shape::Prism };
constexpr Shape kTetrahedra[] = { Shape::Tetrahedron };
constexpr Shape kPyramids[] = { Shape::Pyramid };
constexpr Shape kMixed[] = { Shape::Hexahedron, Shape::Pyramid, Shape::Tetrahedron, Shape::Prism,
  Shape::Tetrahedron };
const Placement kThin{ { 1.0L, 1e-3L, 1.0L }, { 0.0L, 0.0L, 0.0L } };
const Placement kFar{ { 0.01L, 0.01L, 0.01L }, { 3.0L, -7.0L, 5.0L } };

struct Counts
{
  std::int64_t boundary = 0;
  std::int64_t interior = 0;
  std::int64_t hanging = 0;
  std::int64_t partly = 0;

  bool operator==(const Counts&) const = default;
  friend std::ostream& operator<<(std::ostream& out, const Counts& c)
  {
    return out << c.boundary << " boundary, " << c.interior << " interior, " << c.hanging
               << " hanging, " << c.partly << " partly";
  }
};

Counts CountsOf(const FaceTable& faces)
{
  return { faces.CountOf(FaceKind::Boundary), faces.CountOf(FaceKind::Interior),
    faces.CountOf(FaceKind::Hanging), faces.CountOf(FaceKind::Partly) };
}

/// Every interior face's neighbour has it as its own.
void ExpectNeighboursAgree(const Mesh& mesh, const FaceTable& faces)
{
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    for (int f = 0; f < static_cast<int>(FacesOf(mesh.ShapeOf(e)).size()); ++f)
    {
      const ElementFace other = faces.NeighbourOf(e, f);
      if (faces.KindOf(e, f) != FaceKind::Interior)
      {
        EXPECT_EQ(other.element, -1);
        continue;
      }
      ASSERT_GE(other.element, 0) << e << ' ' << f;
      EXPECT_EQ(faces.NeighbourOf(other.element, other.face), (ElementFace{ e, f }));
    }
  }
}

void ExpectClosed(const Mesh& mesh, const FaceTable& faces)
{
  const SurfaceIntegrals integrals = IntegrateBoundary(mesh, faces);
  EXPECT_LT(LargestOf(integrals.area), 1e-11 * integrals.surface);
  EXPECT_NEAR(integrals.volume, integrals.inside, 1e-11 * integrals.inside);
}

/// A unit cube at `corner`, its points moved by `bend`.
void AddCube(
  MeshBuilder& mesh, const Vec3& corner, const MeshBuilder::Map& bend = {}, double side = 1.0)
{
  mesh.Add(UniformSpace(Shape::Hexahedron, bend ? 3 : 1),
    [=](const LongVec3& xi)
    {
      LongVec3 x;
      for (int d = 0; d < 3; ++d)
      {
        x[d] = corner[d] + side * (xi[d] + 1) / 2;
      }
      return bend ? bend(x) : x;
    });
}

FaceTable TableOf(const MeshBuilder& mesh)
{
  const Mesh view = mesh.View();
  const ElementIndex index(view);
  return FaceTable(index);
}
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
    FaceCase{ "HexahedraThin", [] { return Blocks(3, kHexahedra, kThin); }, { 54, 108, 0, 0 } },
    FaceCase{ "TetrahedraFar", [] { return Blocks(2, kTetrahedra, kFar); }, { 48, 144, 0, 0 } },
    // Blocks 1, 2, 4 and 7 are refined: 12 sides between large and small, each 1 to 4, less those
    // of the small block that is refined once more. Counted below by its sides.
    FaceCase{ "Hanging", [] { return Hanging(kHexahedra); }, { 66, 114, 78, 0 } }),
  [](const auto& test) { return std::string(test.param.name); });

TEST(FaceTable, AQuadrilateralAgainstTwoTrianglesHangs)
{
  for (const auto& make : { +[] { return Blocks(3, kMixed); }, +[] { return Hanging(kMixed); },
         +[] { return Blocks(3, kMixed, kThin); } })
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

TEST(FaceTable, SeparatedAndTouchingBodies)
{
  MeshBuilder mesh;
  AddCube(mesh, { 0.0, 0.0, 0.0 });
  AddCube(mesh, { 1.5, 0.0, 0.0 });
  AddCube(mesh, { 2.5, 1.0, 0.0 }); // along an edge
  EXPECT_EQ(CountsOf(TableOf(mesh)), (Counts{ 18, 0, 0, 0 }));
}

TEST(FaceTable, AGapBeyondTheUncertaintyParts)
{
  for (const double gap : { 0.0, 1e-6, 1e-13 })
  {
    for (const double uncertainty : { 0.0, 1e-5 })
    {
      MeshBuilder mesh;
      AddCube(mesh, { 0.0, 0.0, 0.0 });
      AddCube(mesh, { 1.0 + gap, 0.0, 0.0 });
      mesh.Uncertainty = { uncertainty, uncertainty };
      const bool together = gap <= uncertainty;
      EXPECT_EQ(
        CountsOf(TableOf(mesh)), together ? (Counts{ 10, 2, 0, 0 }) : (Counts{ 12, 0, 0, 0 }))
        << gap << ' ' << uncertainty;
    }
  }
}

/// The corners agree, and the edges; the faces part between them, by a gap or by an overlap.
TEST(FaceTable, FacesThatPartBetweenTheirCornersAreBoundary)
{
  for (const long double opening : { 1e-6L, -1e-6L, 0.1L })
  {
    MeshBuilder mesh;
    AddCube(mesh, { 0.0, 0.0, 0.0 }, [](const LongVec3& x) { return x; });
    AddCube(mesh, { 1.0, 0.0, 0.0 },
      [opening](const LongVec3& x) -> LongVec3 {
        return { x[0] + opening * (2 - x[0]) * x[1] * (1 - x[1]) * x[2] * (1 - x[2]), x[1], x[2] };
      });
    EXPECT_EQ(CountsOf(TableOf(mesh)), (Counts{ 12, 0, 0, 0 })) << static_cast<double>(opening);
  }
}

/// A slit that opens between two elements of a block that is otherwise whole.
TEST(FaceTable, ASlitInsideIsBoundaryOnBothSides)
{
  MeshBuilder mesh;
  const auto open = [](long double side)
  {
    return [side](const LongVec3& x) -> LongVec3
    {
      const long double here = x[2] * (2 - x[2]);
      return { x[0], x[1], x[2] + side * 1e-3L * x[0] * (1 - x[0]) * here };
    };
  };
  AddCube(mesh, { 0.0, 0.0, 0.0 }, open(-1));
  AddCube(mesh, { 0.0, 0.0, 1.0 }, open(1));
  AddCube(mesh, { 1.0, 0.0, 0.0 }, [](const LongVec3& x) { return x; });
  AddCube(mesh, { 1.0, 0.0, 1.0 }, [](const LongVec3& x) { return x; });
  const FaceTable faces = TableOf(mesh);
  EXPECT_EQ(CountsOf(faces), (Counts{ 18, 6, 0, 0 }));
  EXPECT_EQ(faces.KindOf(0, 5), FaceKind::Boundary);
  EXPECT_EQ(faces.KindOf(1, 0), FaceKind::Boundary);
  EXPECT_EQ(faces.KindOf(2, 5), FaceKind::Interior);
  EXPECT_EQ(faces.NeighbourOf(2, 5), (ElementFace{ 3, 0 }));
}

TEST(FaceTable, ASmallElementCoversAPartOfALargeOne)
{
  for (const double side : { 0.5, 0.05 })
  {
    MeshBuilder mesh;
    AddCube(mesh, { 0.0, 0.0, 0.0 });
    // Where none of the large face's own points is: it is told by the small one.
    AddCube(mesh, { 1.0, 0.45, 0.45 }, {}, side);
    const FaceTable faces = TableOf(mesh);
    EXPECT_EQ(CountsOf(faces), (Counts{ 10, 0, 1, 1 })) << side;
    EXPECT_EQ(faces.KindOf(0, 2), FaceKind::Partly);
    EXPECT_EQ(faces.KindOf(1, 1), FaceKind::Hanging);
  }
}

/// The same elements twice: neither is behind the other.
TEST(FaceTable, DuplicateElementsHideNoBoundary)
{
  MeshBuilder mesh;
  for (int copy = 0; copy < 2; ++copy)
  {
    AddCube(mesh, { 0.0, 0.0, 0.0 }, Bend);
    AddCube(mesh, { 1.0, 0.0, 0.0 }, Bend);
  }
  const Mesh view = mesh.View();
  const FaceTable faces = TableOf(mesh);
  EXPECT_EQ(CountsOf(faces), (Counts{ 20, 4, 0, 0 }));
  ExpectClosed(view, faces);
}

/// An element that meets itself, as periodic meshes of one element do: its ends stay boundary.
TEST(FaceTable, TheTwoEndsOfOneElementAreBoundary)
{
  MeshBuilder mesh;
  // A lens turned about its edge: the lower and the upper face of a flat element coincide.
  mesh.Add(UniformSpace(Shape::Hexahedron, 2),
    [](const LongVec3& xi) -> LongVec3 {
      return { xi[0], xi[1], xi[2] * xi[2] };
    });
  EXPECT_EQ(CountsOf(TableOf(mesh)), (Counts{ 6, 0, 0, 0 }));
}

/// A hexahedron whose upper face is one edge beside one whose side is a triangle: a quadrilateral
/// with two corners in one place.
TEST(FaceTable, CollapsedFacesPairAndThoseWithoutAreaBoundNothing)
{
  MeshBuilder mesh;
  for (const double start : { 0.0, 1.0 })
  {
    mesh.Add(UniformSpace(Shape::Hexahedron, 2),
      [start](const LongVec3& xi) -> LongVec3 {
        return { start + (xi[0] + 1) / 2, (xi[1] + 1) / 2 * (1 - xi[2]) / 2, (xi[2] + 1) / 2 };
      });
  }
  const FaceTable faces = TableOf(mesh);
  EXPECT_EQ(CountsOf(faces), (Counts{ 8, 4, 0, 0 }));
  EXPECT_EQ(faces.KindOf(0, 5), FaceKind::Interior);
  EXPECT_EQ(faces.NeighbourOf(0, 5), ElementFace{});
  EXPECT_EQ(faces.NeighbourOf(0, 2), (ElementFace{ 1, 1 }));
}

/// A quadrilateral with two corners in one place against a triangle: other corners, the same face.
TEST(FaceTable, ACollapsedQuadrilateralAgainstATriangleIsOneFace)
{
  MeshBuilder mesh;
  mesh.Add(UniformSpace(Shape::Hexahedron, 2),
    [](const LongVec3& xi) -> LongVec3 {
      return { (xi[0] - 1) / 2, (xi[1] + 1) / 2 * (1 - xi[2]) / 2, (xi[2] + 1) / 2 };
    });
  // Its face xi1 = -1 is the triangle y + z <= 1 of the plane x = 0.
  mesh.Add(UniformSpace(Shape::Tetrahedron, 1),
    [](const LongVec3& xi) -> LongVec3 {
      return { (xi[0] + 1) / 2, (xi[1] + 1) / 2, (xi[2] + 1) / 2 };
    });
  const FaceTable faces = TableOf(mesh);
  EXPECT_EQ(faces.KindOf(0, 2), FaceKind::Interior);
  EXPECT_EQ(faces.NeighbourOf(0, 2), (ElementFace{ 1, 1 }));
  EXPECT_EQ(faces.NeighbourOf(1, 1), (ElementFace{ 0, 2 }));
}

/// Mirrored elements (det J < 0 throughout) have their outside where others have it.
TEST(FaceTable, MirroredElementsPairToo)
{
  MeshBuilder mesh;
  AddCube(mesh, { 0.0, 0.0, 0.0 });
  mesh.Add(UniformSpace(Shape::Hexahedron, 1),
    [](const LongVec3& xi) -> LongVec3 {
      return { 1 + (1 - xi[0]) / 2, (xi[1] + 1) / 2, (xi[2] + 1) / 2 };
    });
  const FaceTable faces = TableOf(mesh);
  EXPECT_EQ(CountsOf(faces), (Counts{ 10, 2, 0, 0 }));
  EXPECT_EQ(faces.NeighbourOf(0, 2), (ElementFace{ 1, 2 }));
}

TEST(FaceTable, AnEmptyMeshHasNone)
{
  const MeshBuilder mesh;
  EXPECT_EQ(TableOf(mesh).Faces(), 0);
}

/// $PIXELEXACT_FACE_ELEMENTS: hexahedra of order 1 and 3 in a row, with what their table takes.
TEST(FaceTable, CostOfManyElements)
{
  const char* asked = std::getenv("PIXELEXACT_FACE_ELEMENTS");
  const int n = static_cast<int>(std::cbrt(asked ? std::atof(asked) : 1000.0) + 0.5);
  for (const bool curved : { false, true })
  {
    // One element's coefficients serve all where they are straight.
    MeshBuilder mesh;
    MeshBuilder one;
    AddCube(
      one, Vec3(0.0), curved ? MeshBuilder::Map([](const LongVec3& x) { return x; }) : nullptr);
    const std::vector<std::int32_t> spaceOf(static_cast<std::size_t>(n) * n * n, 0);
    const std::vector<std::int64_t> offset(spaceOf.size(), 0);
    const std::vector<double> size(spaceOf.size(), 1.0);
    const std::vector<double> uncertainty(spaceOf.size(), 0.0);
    std::vector<double> centre;
    for (int i = 0; i < n * n * n; ++i)
    {
      centre.push_back(i % n);
      centre.push_back(i / n % n);
      centre.push_back(i / n / n);
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
      n * n * n, curved ? 3 : 1, seconds.count() * 1e9 / static_cast<double>(faces.Faces()),
      static_cast<double>(faces.MemoryUsage()) / static_cast<double>(faces.Faces()));
  }
}
} // namespace pixelexact::testing
