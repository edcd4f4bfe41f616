// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/MadeOnDemand.h"
#include "Core/Bounds/XiInverse.h"
#include "Core/Index/ElementIndex.h"

#include <array>
#include <vector>

namespace pixelexact
{
/// constant + slope . s >= 0: on the inner side of a face or of a box's end.
struct LeafSide
{
  double constant;
  Vec3 slope;
};

/// A box of an element's xi with the analytic inverse of the map over it, and bounds of a field.
/// Coordinates s are those of XiInverse.
struct VolumeLeaf
{
  XiInverse inverse;
  std::vector<LeafSide> sides;         ///< the leaf is where all hold
  std::vector<DiscBounds> fieldBounds; ///< by component, of |f - f_0|
  /// How far a kernel's value may be off the series, by component; in the box.
  std::vector<double> fieldNoise;
  bool isProven = false; ///< rays through the whole leaf have the tolerances
};

/// The leaves of a mesh's elements for one field, each element's made on first use. Safe to use
/// from several threads.
class VolumeLeaves
{
public:
  /// Largest interpolation errors for which an element is divided: of the field's components, in
  /// their units, and of s.
  struct Tolerances
  {
    double value;
    double place;
  };

  /// No leaf is narrower than this part of the element, per direction.
  static constexpr double kNarrowest = 1.0 / 64.0;
  /// Points of the interpolant with which a ray through the whole leaf meets the tolerances.
  static constexpr int kPoints = 24;

  /// The index and the field's arrays must outlive this object. The field needs polynomials
  /// without a mapping; components [first, first + count) are bounded.
  VolumeLeaves(const ElementIndex& index, const Field& field, int first, int count,
    const Tolerances& tolerances);

  [[nodiscard]] const std::vector<VolumeLeaf>& Of(int element) const;
  [[nodiscard]] const ElementIndex& Index() const { return index_; }
  [[nodiscard]] const Tolerances& GetTolerances() const { return tolerances_; }
  [[nodiscard]] int Components() const { return count_; }
  [[nodiscard]] const Space& FieldSpace(int element) const
  {
    return field_.values.SpaceOf(element);
  }
  /// The coefficients of the first bounded component; those of the others follow.
  [[nodiscard]] const double* FieldCoefficients(int element) const;

private:
  /// `direction`: gets that along which the leaf should be divided; -1: the field is not finite.
  /// A leaf that `mayDivide` and has no proof has no bounds of the field.
  [[nodiscard]] VolumeLeaf MakeLeaf(
    int element, const Box3& box, bool mayDivide, int& direction) const;
  void Divide(int element, const Box3& box, std::vector<VolumeLeaf>& leaves) const;

  const ElementIndex& index_;
  const Field& field_;
  int first_;
  int count_;
  Tolerances tolerances_;
  MadeOnDemand<std::vector<VolumeLeaf>> made_;
};
} // namespace pixelexact
