// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Nurbs/NurbsMesh.h"
#include "Formats/Rational/ElementParts.h"
#include "Formats/Rational/RationalElement.h"

namespace pixelexact::mfem
{
/// The functions of a NURBS grid function, or of a mesh's nodes, with MFEM's numbers of their
/// control points. Messages of what it throws name no file.
class NurbsSpace
{
public:
  /// The space that a header names: the mesh's own, or one of other orders, whose weights are 1
  /// where it gives none. The mesh outlives it. Throws InvalidData and Unsupported.
  NurbsSpace(const NurbsMesh& mesh, const GridFunctionFile& file);

  /// Control points, where those of identified boundaries are one.
  [[nodiscard]] std::int64_t Size() const { return Points; }
  [[nodiscard]] bool IsContinuous() const;
  /// "NURBS of order 2" or "NURBS of orders 1 to 3".
  [[nodiscard]] std::string Description() const;
  /// The degree along a knot vector of the mesh.
  [[nodiscard]] int Degree(int vector) const { return Vectors[vector].degree; }

  /// The control points of some elements, ascending: the order in which the process that has these
  /// elements numbers them.
  [[nodiscard]] std::vector<int> PointsOf(std::span<const int> elements) const;
  /// Weights of all control points, which must be positive, in place of those of the header.
  void SetWeights(std::vector<double> weights);

  /// The values in the order of control points, `components` for each. Throws InvalidData where
  /// there are more or fewer.
  [[nodiscard]] std::vector<double> ValuesOf(const GridFunctionFile& file) const;
  /// The function on a part of the element at `place`, from such values, or from those of the
  /// control points `rows` alone, which are ascending and hold the element's.
  [[nodiscard]] rational::RationalElement ElementOf(const GridPlace& place,
    const rational::ElementPart& part, std::span<const double> values, int components,
    std::span<const int> rows = {}) const;

private:
  void RequireWeights() const;
  void Identify(const std::vector<int>& masters, const std::vector<int>& slaves,
    const PatchNumbering& numbering);
  /// Visits the places in a boundary's grid, those of one span after those of another.
  template <class Visit>
  void ForSpans(const PatchNumbering::Boundary& boundary, Visit&& visit) const;
  [[nodiscard]] const KnotVector& Along(std::size_t patch, int direction) const;
  /// An element's control points, the last direction fastest.
  [[nodiscard]] std::vector<std::size_t> PointsAt(
    const GridPlace& place, std::array<int, 3>& first) const;

  const NurbsMesh& Mesh;
  std::vector<KnotVector> Vectors;
  std::vector<KnotVector> Flipped;     ///< the same from their other ends
  std::vector<std::vector<int>> Spans; ///< first control points, per knot vector
  std::vector<std::vector<int>> FlippedSpans;
  std::vector<std::vector<int>> Grids; ///< control points per patch, the first direction fastest
  std::vector<double> Weights;         ///< empty: all are 1
  std::int64_t Points = 0;
};
} // namespace pixelexact::mfem
