// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Mesh.h"
#include "Core/Faces/FaceTable.h"
#include "Core/Location/Locator.h"
#include "Core/Math/Rounding.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace pixelexact
{
/// The jump of a field across a face between elements: |[u]|, the magnitude of the difference of
/// the two sides' values; of vectors the Euclidean norm.
struct FaceJump
{
  ElementFace face;            ///< on whose points both sides are evaluated
  std::int32_t neighbour = -1; ///< the element on the other side at `xi`
  double largest = 0.0;        ///< at the samples; numeric
  Vec3 xi{ 0.0 };              ///< the sample of `largest`, in face.element
  /// Proven: no jump on the face exceeds it, rounding included. Infinite where nothing is proven.
  double bound = kInfinity;
  double square = 0.0; ///< the integral of |[u]|^2 over the face, by Gauss quadrature
  double area = 0.0;   ///< of the face where it has a neighbour, in the same way
};

struct FaceJumps
{
  /// The faces between elements, each once, in the order of elements and faces.
  std::vector<FaceJump> faces;
  std::int64_t notFound = 0;  ///< faces and samples whose other side is not known, left out
  std::int64_t notFinite = 0; ///< faces with a value that is not finite, which are left out
  double size = 0.0;          ///< the largest magnitude of a value at the samples
};

/// Compares a field's values on both sides of all faces between elements.
///
/// A face between two elements is sampled at M^2 Chebyshev points of its two parameters (collapsed
/// in triangles), M = 8 n, n the higher order of the two sides. The jump is a polynomial of degree
/// n in each parameter, so it is at most the largest sample over cos^2(n pi / (2 M)), which is 1.04
/// of it (H. Ehlich and K. Zeller, Schwankung von Polynomen zwischen Gitterpunkten, Mathematische
/// Zeitschrift 86, 1964). Bounds of the rounding of values and of sample points are added. Nothing
/// is proven for mapped fields, expressions, faces of pyramids and faces that meet parts of others,
/// as hanging ones. These are compared at Gauss points and, where whole faces meet, at Chebyshev
/// points as well.
///
/// Of faces that meet parts of each other each part counts once. Parallel; the result is
/// independent of the number of threads. Throws Unsupported for expressions with normals or jumps.
FaceJumps FindFaceJumps(const Locator& locator, const FaceTable& table, const Field& field,
  const std::function<void(double)>& progress = {});
} // namespace pixelexact
