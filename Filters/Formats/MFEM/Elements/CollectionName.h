// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Elements/Collection.h"

#include <cstdint>
#include <string>

// Parses the names of MFEM's finite element collections. Only this code interprets them.
namespace pixelexact::mfem
{
/// One-dimensional bases, with MFEM's numbers: the 2 of "L2_T2_3D_P1".
enum class LineBasis : std::uint8_t
{
  GaussLegendre = 0,
  GaussLobatto = 1,
  Positive = 2, ///< Bernstein
  OpenUniform = 3,
  ClosedUniform = 4,
  OpenHalfUniform = 5,
  Serendipity = 6,
  ClosedGaussLegendre = 7,
  IntegratedGaussLobatto = 8
};

/// MFEM's two spaces on pyramids, with its numbers: the 0 of "H1_3D_P3_Pyr0".
enum class PyramidSpace : std::uint8_t
{
  Bergot = 0,
  Fuentes = 1 ///< MFEM's default where the name has none
};

struct CollectionName
{
  std::string text;
  Continuity continuity = Continuity::H1;
  int order = 1;
  int dimension = 3;                          ///< of the elements
  LineBasis closed = LineBasis::GaussLobatto; ///< the basis of scalar functions
  LineBasis open = LineBasis::GaussLegendre;  ///< H(curl), H(div): where a component is lower
  PyramidSpace pyramid = PyramidSpace::Fuentes;
  bool integral = false;     ///< values are densities ("L2Int")
  bool shared = true;        ///< unknowns belong to vertices, edges and faces, not to elements
  bool legacy = false;       ///< of fixed order, by a name of its own
  bool entityOrdered = true; ///< local order: vertices, edges, faces, interior
};

/// Parses the name of a collection for elements of `dimension`. Throws Unsupported for other
/// collections and for those without a basis on solid or plane elements; InvalidData where it is
/// not a name.
CollectionName ParseCollectionName(const std::string& text, int dimension);

/// "Gauss-Lobatto nodes"
std::string Describe(LineBasis basis);
} // namespace pixelexact::mfem
