// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/AffineMotion.h"
#include "Core/Element/Mesh.h"
#include "Core/Element/OwnedExpansion.h"
#include "Core/Math/Vec.h"

#include <span>
#include <vector>

// Deformed meshes: x + s u, with a displacement u that is a polynomial in xi on each element, and
// affine images.
namespace pixelexact
{
/// A term of a displacement: a component of a field times a constant vector. The field has no
/// mapping and is no expression.
struct WarpTerm
{
  const Field* field;
  int component;
  Vec3 direction;
};

/// The modes of an element's map and of its displacement, three components each, in the smallest
/// space that contains both.
struct JointModes
{
  Space space;
  std::vector<double> map;          ///< in units of the element, relative to its centre
  std::vector<double> displacement; ///< world units, each mode rounded once
};

/// Throws InvalidData, naming the field, where a coefficient of the displacement is not finite.
[[nodiscard]] JointModes JoinModes(
  const Mesh& mesh, int element, std::span<const WarpTerm> displacement);

/// A mesh that owns its arrays.
struct OwnedMesh
{
  OwnedExpansion map;
  std::vector<double> centre; ///< 3 per element
  std::vector<double> size;
  std::vector<double> uncertainty;

  [[nodiscard]] Mesh View() const { return { map.View(), centre, size, uncertainty }; }
};

/// The mesh with the map x + scale * u. Each coefficient is rounded once; the uncertainty grows by
/// that, by the rounding of the displacement's coefficients, and by `jump`: how far u may differ
/// between elements at the same point, in world units. Elements keep their centre and size where
/// these still fit. Parallel. Throws InvalidData for coefficients that are not finite and for
/// elements that become too large.
[[nodiscard]] OwnedMesh WarpedMesh(
  const Mesh& mesh, std::span<const WarpTerm> displacement, double scale, double jump);

/// The affine image of a mesh. `errors`: per element, how far the motion may be from the true one,
/// in world units; uncertainties are scaled by the motion and grow by that and by the rounding of
/// the coefficients. Parallel. Throws InvalidData for elements that become too large.
[[nodiscard]] OwnedMesh MovedMesh(
  const Mesh& mesh, const AffineMotion& motion, std::span<const double> errors);
} // namespace pixelexact
