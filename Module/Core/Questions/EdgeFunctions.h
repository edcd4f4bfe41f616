// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/HessianFunction.h"
#include "Core/Element/Kernels.h"
#include "Core/Index/ElementIndex.h"
#include "Core/Questions/Outline.h"
#include "Core/Questions/PointValues.h"
#include "Core/Tree/EtaBox.h"

#include <array>
#include <span>

namespace pixelexact
{
/// The map of an element, in the element's units, and a component of a field: at points, and bounds
/// over boxes of eta. Safe to use from several threads.
class EdgeFunctions
{
public:
  /// See EdgeBounds.
  EdgeFunctions(const Mesh& mesh, const ElementBounds& bounds, int element, const Field& field,
    int component, double rounding);
  /// Of the map alone.
  EdgeFunctions(const Mesh& mesh, const ElementBounds& bounds, int element);

  /// Whether the component is: nothing else is known of one that is not.
  [[nodiscard]] bool IsFinite() const { return Component.finite; }
  [[nodiscard]] Shape GetShape() const { return Map.space.shape; }
  /// Of which the norm is taken, if there are several; 0: of the map alone.
  [[nodiscard]] int Components() const { return Count; }
  /// Holds all values in the element.
  [[nodiscard]] const Interval& Values() const { return Range; }
  /// Bounds the rounding of values as the kernels make them; of the map's, in the element's units.
  [[nodiscard]] double ValueError() const { return Error; }
  [[nodiscard]] double ImageError() const { return MapError; }
  /// The same of derivatives by xi.
  [[nodiscard]] double ValueSlopeError() const { return SlopeError; }
  [[nodiscard]] double ImageSlopeError() const { return MapSlopeError; }
  /// World units in one of the element's.
  [[nodiscard]] double Size() const { return Unit; }
  /// Of the map and of points, by coordinate, in the element's units.
  [[nodiscard]] const std::array<double, 3>& Uncertainty() const { return Unsure; }
  /// How often boxes are worth halving: those on which the map is not regular, and those where it
  /// is.
  [[nodiscard]] int Deepest(bool regular) const { return Halvings[regular ? 1 : 0]; }
  [[nodiscard]] Vec3 InUnits(const Vec3& x) const { return (x - Centre) / Unit; }
  [[nodiscard]] Vec3 InWorld(const Vec3& y) const { return Centre + Unit * y; }
  /// By coordinate, in the element's units: of InUnits at x.
  [[nodiscard]] Vec3 RoundingInUnits(const Vec3& x) const;

  /// The map, and a component, at points.
  [[nodiscard]] PointValues ImagesAt(std::span<const Vec3> xi) const;
  [[nodiscard]] PointValues ValuesAt(int component, std::span<const Vec3> xi) const;

  /// The map at a point.
  struct View
  {
    Vec3 xi;
    Vec3 y; ///< its image
    Mat3 jacobian;
    Mat3 inverse; ///< of the Jacobian, as rounding leaves it
  };
  [[nodiscard]] View ViewAt(const Vec3& xi) const;
  /// Of the expansion of first order about a xi, between these places in xi: of an Outline.
  [[nodiscard]] Interval LinearValues(const Vec3& xi, std::span<const Vec3> places) const;

  /// Holds the image of a box, in world coordinates.
  [[nodiscard]] Box3 ImageOver(const EtaBox& box) const;
  [[nodiscard]] Interval ValuesOver(const EtaBox& box) const;
  /// By coordinate and xi.
  using Slopes = std::array<std::array<Interval, 3>, 3>;
  [[nodiscard]] Slopes SlopesOver(const EtaBox& box) const;
  /// Of the map's coordinates and of a component, if there are any: first and second derivatives
  /// by xi.
  using Derivatives = std::array<HessianFunction::XiRanges, 4>;
  [[nodiscard]] Derivatives DerivativesOver(const EtaBox& box, int component) const;

private:
  EdgeFunctions(const Mesh& mesh, const ElementBounds& bounds, int element, ScaledModes component,
    int count, double rounding);
  template <class Visit>
  void ForEachPiece(const EtaBox& box, const Visit& visit) const;
  [[nodiscard]] Interval RangeOver(
    const EtaBox& box, const ScaledModes& modes, int component, Part part) const;
  void ChooseLevel();
  /// Of `components` functions together, 4 times what the conversion to a part makes at most: the
  /// kernels make the same sums, but for the order of the factors (accuracy.md).
  [[nodiscard]] double ErrorOf(const ScaledModes& modes, int components, Part part) const;

  ScaledModes Map;
  ScaledModes Component;
  KernelSet MapKernels;
  KernelSet ComponentKernels;
  int Count;
  int Level = 0;
  int Halvings[2] = {};
  Vec3 Centre;
  double Unit;
  std::array<double, 3> Unsure;
  double Error = 0.0;
  double SlopeError = 0.0; ///< of values' derivatives by xi
  double MapError = 0.0;
  double MapSlopeError = 0.0;
  Interval Range;
};
} // namespace pixelexact
