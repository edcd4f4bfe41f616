// SPDX-License-Identifier: BSD-3-Clause
// Faces that touch, nearly touch or touch in part: gaps, slits, overlaps, collapsed and small ones.
#include "CurvedMeshes.h"
#include "FaceCounts.h"

namespace pixelexact::testing
{
TEST(FaceContacts, SeparatedAndTouchingBodies)
{
  MeshBuilder mesh;
  AddCube(mesh, { 0.0, 0.0, 0.0 });
  AddCube(mesh, { 1.5, 0.0, 0.0 });
  AddCube(mesh, { 2.5, 1.0, 0.0 }); // along an edge
  EXPECT_EQ(CountsOf(TableOf(mesh)), (Counts{ 18, 0, 0, 0 }));
}

TEST(FaceContacts, AGapBeyondTheUncertaintyParts)
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

TEST(FaceContacts, FacesThatPartBetweenTheirCornersAreBoundary)
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

TEST(FaceContacts, ASlitInsideIsBoundaryOnBothSides)
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

TEST(FaceContacts, ASmallElementCoversAPartOfALargeOne)
{
  for (const double side : { 0.5, 0.05 })
  {
    MeshBuilder mesh;
    AddCube(mesh, { 0.0, 0.0, 0.0 });
    // The small face contains none of the large face's sample points; its own points detect it.
    AddCube(mesh, { 1.0, 0.45, 0.45 }, {}, side);
    const FaceTable faces = TableOf(mesh);
    EXPECT_EQ(CountsOf(faces), (Counts{ 10, 0, 1, 1 })) << side;
    EXPECT_EQ(faces.KindOf(0, 2), FaceKind::Partly);
    EXPECT_EQ(faces.KindOf(1, 1), FaceKind::Hanging);
  }
}

TEST(FaceContacts, DuplicateElementsHideNoBoundary)
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

TEST(FaceContacts, TheTwoEndsOfOneElementAreBoundary)
{
  MeshBuilder mesh;
  // A lens turned about its edge: the lower and the upper face of a flat element coincide.
  mesh.Add(UniformSpace(Shape::Hexahedron, 2),
    [](const LongVec3& xi) -> LongVec3 {
      return { xi[0], xi[1], xi[2] * xi[2] };
    });
  EXPECT_EQ(CountsOf(TableOf(mesh)), (Counts{ 6, 0, 0, 0 }));
}

TEST(FaceContacts, CollapsedFacesPairAndThoseWithoutAreaBoundNothing)
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

TEST(FaceContacts, ACollapsedQuadrilateralAgainstATriangleIsOneFace)
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

TEST(FaceContacts, MirroredElementsPairToo)
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
} // namespace pixelexact::testing
