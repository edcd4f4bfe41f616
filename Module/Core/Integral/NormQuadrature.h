// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/FacePlaces.h"
#include "Core/Integral/FieldNorms.h"
#include "Core/Math/Vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pixelexact
{
/// A box of eta, with the integrals over it, and the differences of the two rules, by quantity.
struct NormBox
{
  Box3 box;
  std::vector<double> sums;
  std::vector<double> errors;
};

/// The quadrature of one element.
class ElementQuadrature
{
public:
  std::vector<NormBox> boxes;
  ElementNorms norms;
  std::int64_t looked = 0;

  [[nodiscard]] double Sum(std::size_t quantity) const { return Total(&NormBox::sums, quantity); }
  [[nodiscard]] double Error(std::size_t quantity) const
  {
    return Total(&NormBox::errors, quantity);
  }

private:
  [[nodiscard]] double Total(std::vector<double> NormBox::*of, std::size_t quantity) const;
};

/// Integrates 1, |f|, |f|^2 and the components of f over elements, with Gauss rules of two numbers
/// of points on boxes of eta.
class NormQuadrature
{
public:
  /// Numbers of the quantities; the components follow.
  static constexpr std::size_t kVolume = 0;
  static constexpr std::size_t kAbsolute = 1;
  static constexpr std::size_t kSquare = 2;
  static constexpr std::size_t kFirstComponent = 3;

  /// `isPlane`: the mesh stands for a plane mesh. `order`: of the fields that an expression reads.
  NormQuadrature(const Mesh& mesh, const Field& field, bool isPlane, int order);

  [[nodiscard]] std::size_t Quantities() const { return kFirstComponent + Components; }
  /// The number of points of both rules.
  [[nodiscard]] std::int64_t PointsOfBox() const;

  /// Integrates over the whole element.
  void Begin(int element, ElementQuadrature& quadrature) const;
  /// Subdivides the boxes with the largest errors until the errors are at most `allowed`, or there
  /// are `boxes` of them.
  void Refine(int element, const std::vector<double>& allowed, std::int64_t boxes,
    ElementQuadrature& quadrature) const;

private:
  struct BoxSums;
  /// The direction of eta across the slab; -1: there is none.
  [[nodiscard]] int Across(int element) const;
  /// Adds the children's errors to `errors`.
  template <class IsWorse>
  void Subdivide(int element, const Box3& box, const IsWorse& isWorse,
    ElementQuadrature& quadrature, std::vector<double>& errors) const;
  void Add(int element, const Box3& box, ElementQuadrature& quadrature) const;
  [[nodiscard]] BoxSums Over(int element, const Box3& box, const GaussRule& rule) const;
  /// det J by xi, in world units.
  [[nodiscard]] std::vector<double> Determinants(int element, std::span<const Vec3> xi) const;
  void AddBatch(
    int element, std::span<const Vec3> eta, std::span<const double> weights, BoxSums& result) const;

  const Mesh& mesh_;
  const Field& field_;
  std::size_t Components;
  bool IsPlane;
  std::array<GaussRule, 2> Rules;
};
} // namespace pixelexact
