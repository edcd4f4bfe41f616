// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/MadeOnDemand.h"
#include "Core/Element/Mesh.h"
#include "Core/Element/RangeIngredients.h"
#include "Core/Math/Interval.h"
#include "Core/Shape/ShapeFace.h"

#include <span>

namespace pixelexact
{
/// Plateaus are parts of an element on which a component has one value up to the precision of its
/// coefficients, such as walls on which a solver prescribes it.
///
/// Coefficients are results of conversions, which round. A coefficient is therefore known to
/// u max|c| at best (u = 2^-53, c all coefficients of the component in the element), and that
/// moves the component by at most
///   rho = u max|c| (sum over the modes of the largest |mode|).
/// A value v is *held* on a part if all values of the stored component there are proven to lie
/// within rho of v: a component whose coefficients differ from the stored ones by no more than
/// their rounding may be v there. A component that varies by more than 2 rho holds no value,
/// however small that is beside its largest. A field of zeros holds 0 and nothing else.
///
/// All functions return the interval of the values that are held, in the units of the modes'
/// exponent times 2^exponent (world values); it is empty where none is. `modes`: of `components`
/// (at least 1) components; of several it is their Euclidean norm. All must be finite.

/// The values that the component holds on the whole element.
[[nodiscard]] Interval HeldInElement(const ScaledModes& modes, int components);

/// The values that the component holds on a whole face. Costs about 4 (degree + 1)^2 evaluations of
/// all modes in long double.
[[nodiscard]] Interval HeldOnFace(const ScaledModes& modes, int components, const ShapeFace& face);

/// The plane n . x = offset, in the units of an element: n . Phi(xi) - offset is zero on it.
struct PlaneInElement
{
  Vec3 normal{ 0.0 };
  double offset = 0.0;
};

/// The values that the component holds on the part of a plane in the element, where the component
/// is v + lambda (n . Phi - offset) with a constant lambda. For other components none is found. rho
/// grows by |lambda| times the change of n . Phi - offset by the same rounding of the map and of
/// the plane's offset.
[[nodiscard]] Interval HeldOnPlane(
  const ScaledModes& modes, int components, const ScaledModes& map, const PlaneInElement& plane);

/// Computes and keeps the plateaus of one element. Safe to use from several threads. Mesh and field
/// must outlive it.
class ElementPlateaus
{
public:
  /// `component`: one of the field's, or -1: the Euclidean norm of all. Mapped fields, functions
  /// without coefficients, and fields that are not finite in the element hold nothing.
  ElementPlateaus(const Mesh& mesh, int element, const Field& field, int component);

  [[nodiscard]] const Interval& InElement() const;
  /// `face`: as in FacesOf.
  [[nodiscard]] const Interval& OnFace(int face) const;
  /// The plane is in world coordinates. The result is computed at each call.
  [[nodiscard]] Interval OnPlane(const Vec3& point, const Vec3& normal) const;

private:
  [[nodiscard]] ScaledModes Modes() const;
  [[nodiscard]] int Components() const;

  const Mesh& mesh_;
  int Element;
  const Field& field_;
  int Component;
  bool MayHold;
  MadeOnDemand<Interval> Kept{ 7 }; ///< of the faces, and last of the element
};
} // namespace pixelexact
