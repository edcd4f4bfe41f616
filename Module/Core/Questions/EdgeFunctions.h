// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/MadeOnDemand.h"
#include "Core/Element/Kernels.h"
#include "Core/Index/ElementIndex.h"
#include "Core/Questions/EdgePolynomials.h"
#include "Core/Questions/Outline.h"
#include "Core/Questions/PointValues.h"
#include "Core/Tree/EtaBox.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

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

  /// Holds all values of a box.
  [[nodiscard]] Interval ValuesOver(const EtaBox& box) const;
  /// Of the map over a box.
  struct MapRanges
  {
    Box3 image; ///< holds it, in world coordinates
    std::array<std::array<Interval, 3>, 3> slopes;    ///< by coordinate and xi
    std::vector<EdgePolynomials::MapHulls> ofPieces; ///< of the cube, that the box meets
  };
  [[nodiscard]] MapRanges MapOver(const EtaBox& box) const;
  /// First and second derivatives by xi of the map's coordinates and of the components; and of
  /// these, together, the values. `map`: of the same box.
  struct Derivatives
  {
    std::array<HessianFunction::XiRanges, 3> map;
    std::vector<HessianFunction::XiRanges> components;
    Interval values;
  };
  [[nodiscard]] Derivatives DerivativesOver(const EtaBox& box, const MapRanges& map) const;

  ~EdgeFunctions();
  EdgeFunctions(const EdgeFunctions&) = delete;
  EdgeFunctions& operator=(const EdgeFunctions&) = delete;

private:
  EdgeFunctions(const Mesh& mesh, const ElementBounds& bounds, int element, ScaledModes component,
    int count, double rounding);
  template <class Visit>
  void ForEachPiece(const EtaBox& box, const Visit& visit) const;
  [[nodiscard]] Interval RangeOver(
    const EtaBox& box, const ScaledModes& modes, int component, Part part) const;
  /// Calls visit(the polynomials), which are kept as far as there is room.
  template <class Visit>
  void WithPolynomials(const PieceForm::Piece& piece, const Visit& visit) const;
  [[nodiscard]] Interval ValuesOf(std::span<const Interval> components) const;
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
  std::unique_ptr<MadeOnDemand<EdgePolynomials>> Kept; ///< by piece
  mutable std::atomic<std::int64_t> Bytes{ 0 };
};
} // namespace pixelexact
