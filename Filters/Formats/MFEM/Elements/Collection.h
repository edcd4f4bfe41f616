// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/ElementBasis.h"

#include "Core/Element/Mesh.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

// MFEM's finite element collections. Only this class implements their bases. Local orders are
// MFEM's: unknowns of vertices, edges, faces, interior.
namespace pixelexact::mfem
{
enum class Geometry : std::uint8_t
{
  Point = 0,
  Segment = 1,
  Triangle = 2,
  Square = 3,
  Tetrahedron = 4,
  Cube = 5,
  Prism = 6,
  Pyramid = 7
};

enum class Continuity : std::uint8_t
{
  H1,
  HCurl,
  HDiv,
  L2
};

class Collection
{
public:
  /// Parses a collection's name in a file: "H1_3D_P4", "H1@U_3D_P2", "H1Pos_3D_P3", "L2_T2_3D_P1",
  /// "L2Int_3D_P2", "ND_3D_P2", "RT_3D_P1", "Linear", "Quadratic", "Cubic", "Const3D",
  /// "LinearDiscont3D", ...; for elements of `dimension` 3, or 2 ("H1_2D_P4", ...). Throws
  /// Unsupported (NURBS, trace collections, those of another dimension) with a remedy, InvalidData
  /// where it is not a collection's name.
  static Collection Parse(const std::string& name, int dimension = 3);
  Collection(Collection&&) noexcept;
  Collection& operator=(Collection&&) noexcept;
  ~Collection();

  [[nodiscard]] Continuity GetContinuity() const;
  [[nodiscard]] Mapping GetMapping() const;
  [[nodiscard]] bool IsVector() const;           ///< vector-valued functions: H(curl), H(div)
  [[nodiscard]] int Order() const;               ///< the number in the name
  [[nodiscard]] std::string Description() const; ///< for people

  /// Unknowns that belong to the inside of an entity (MFEM's DofForGeometry).
  [[nodiscard]] int Unknowns(Geometry geometry) const;

  /// The order of an entity's unknowns in an element that has the entity with `orientation` (MFEM's
  /// numbering: segments +1, -1; triangles 0 to 5; squares 0 to 7). Entry i is the entity's unknown
  /// n, or -1 - n for its negative (MFEM's DofOrderForOrientation).
  [[nodiscard]] std::span<const int> UnknownOrder(Geometry geometry, int orientation) const;

  /// Whether pairs of unknowns on triangles are also mixed (H(curl) of order 2 and up), and the
  /// matrix that takes the stored pair to the element's: row-major, for MFEM's triangle
  /// orientation. Applied after UnknownOrder's gathering to unknowns (2 i, 2 i + 1) of the face.
  [[nodiscard]] bool MixesTriangleUnknowns() const;
  [[nodiscard]] std::array<double, 4> TriangleMixing(int orientation) const;

  /// The basis on a solid shape, or on a plane one as on a slab's solid (of order 0 across), made
  /// at first use. Throws Unsupported where MFEM defines none.
  [[nodiscard]] const ElementBasis& Basis(Geometry solid) const;

private:
  Collection();
  struct Internals;
  std::unique_ptr<Internals> Data;
};
} // namespace pixelexact::mfem
