// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/MadeOnDemand.h"
#include "Core/Element/ElementQuantity.h"
#include "Core/Element/Kernels.h"
#include "Core/Element/PieceStore.h"
#include "Core/Index/ElementIndex.h"
#include "Core/Math/Mat.h"
#include "Core/Questions/EdgePolynomials.h"
#include "Core/Questions/Outline.h"
#include "Core/Questions/PointValues.h"
#include "Core/Questions/QuotientModes.h"
#include "Core/Tree/EtaBox.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace pixelexact
{
/// The map of an element, in the element's units, and a component of a field, at points and with
/// bounds over boxes of eta. Safe to use from several threads.
class EdgeFunctions
{
public:
  /// See EdgeBounds.
  EdgeFunctions(const Mesh& mesh, const ElementBounds& bounds, int element, const Field& field,
    int component, double rounding);
  /// Constructs the map alone.
  EdgeFunctions(const Mesh& mesh, const ElementBounds& bounds, int element);

  /// Whether the component has bounds. Mapped fields have none in pyramids, and none with products
  /// of high orders (QuotientModes).
  [[nodiscard]] bool IsKnown() const { return Known; }
  /// Whether the component is an expression.
  [[nodiscard]] bool HasJet() const { return Jet != nullptr; }
  /// False where a coefficient is not finite; then there are no values.
  [[nodiscard]] bool HasValues() const { return Jet ? Jet->IsFinite() : Component.finite; }
  [[nodiscard]] Shape GetShape() const { return Map.space.shape; }
  /// The number of components in the norm, or 1; 0: the map alone.
  [[nodiscard]] int Components() const { return Count; }
  /// Encloses all values in the element. It is -inf to inf where they are not known, and for mapped
  /// fields where det J is not proven to keep its sign.
  [[nodiscard]] const Interval& Values() const { return Range; }
  /// Bounds the rounding of the kernels' values, for fields that are not mapped (see ErrorsWith),
  /// and of the map's images, in the element's units.
  [[nodiscard]] double ValueError() const { return Error; }
  [[nodiscard]] double ImageError() const { return MapError; }
  /// Bounds the rounding of derivatives by xi.
  [[nodiscard]] double ValueSlopeError() const { return SlopeError; }
  [[nodiscard]] double ImageSlopeError() const { return MapSlopeError; }
  /// World units per unit of the element.
  [[nodiscard]] double Size() const { return Unit; }
  /// The uncertainty of the map and of points, by coordinate, in the element's units.
  [[nodiscard]] const std::array<double, 3>& Uncertainty() const { return Unsure; }
  /// The largest useful depth of subdivision of boxes on which the map is not regular, and of those
  /// where it is.
  [[nodiscard]] int Deepest(bool regular) const { return Subdivisions[regular ? 1 : 0]; }
  /// The estimated cost of subdividing a box, in nanoseconds of one core.
  [[nodiscard]] std::int64_t SubdivisionCost(const EtaBox& box) const;
  /// The depth to which boxes are subdivided without cost: there are few of them, and many queries
  /// share them.
  [[nodiscard]] int FreeSubdivisions() const { return Free; }
  /// The estimated cost of the map and the component at a point.
  [[nodiscard]] std::int64_t ViewCost() const { return CostOfView; }
  /// The estimated cost of finding a point's xi and the value there, where the map is regular and
  /// where it is not.
  [[nodiscard]] std::int64_t SampleCost(bool regular) const;
  [[nodiscard]] Vec3 InUnits(const Vec3& x) const { return (x - Centre) / Unit; }
  [[nodiscard]] Vec3 InWorld(const Vec3& y) const { return Centre + Unit * y; }
  /// Bounds the rounding of InUnits at x, by coordinate, in the element's units.
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
  /// See IsFlatOver (Regularity.h).
  [[nodiscard]] bool IsFlatOver(const EtaBox& box) const;
  /// The expansion of first order about a xi: its values between these places in xi, the corners of
  /// an Outline. `slopeError`: of the component at points there (ErrorsWith).
  struct Linear
  {
    Interval values;
    Vec3 slope{ 0.0 }; ///< by xi, of the last component
  };
  /// `known`: the value and slope there, if they have been computed and there is one component.
  struct ValueAndSlope
  {
    double value;
    Vec3 slope; ///< by xi
  };
  [[nodiscard]] Linear LinearValues(const Vec3& xi, std::span<const Vec3> places, double slopeError,
    const ValueAndSlope* known = nullptr) const;
  /// The value and slope of a component at a point.
  [[nodiscard]] ValueAndSlope ValueAndSlopeAt(int component, const Vec3& xi) const;

  /// Encloses all values over a box.
  [[nodiscard]] Interval ValuesOver(const EtaBox& box) const;
  /// The same, intersected with the values over a larger box; these alone where more would cost
  /// much.
  [[nodiscard]] Interval NarrowedOver(const EtaBox& box, const Interval& those) const
  {
    return Count == 0 || Divisor ? those : Intersect(ValuesOver(box), those);
  }
  /// Ranges of the map over a box.
  struct MapRanges
  {
    Box3 image;                                      ///< holds it, in world coordinates
    std::array<std::array<Interval, 3>, 3> slopes;   ///< by coordinate and xi
    std::vector<EdgePolynomials::MapHulls> ofPieces; ///< of the cube, that the box meets
  };
  [[nodiscard]] MapRanges MapOver(const EtaBox& box) const;
  /// Bounds the rounding of values and of their derivatives by xi over a box, both of kernels and
  /// of ValuesAt.
  struct Errors
  {
    double value;
    double slope;
  };
  /// First and second derivatives by xi of the map's coordinates and of the components, and the
  /// values of all components together. `map`: of the same box.
  struct Derivatives
  {
    std::array<HessianFunction::XiRanges, 3> map;
    std::vector<HessianFunction::XiRanges> components;
    Interval values;
    /// det J and its first derivatives, for mapped fields.
    Interval divisor{ 1.0 };
    std::array<Interval, 3> divisorSlopes{};
    /// The second derivatives as affine bounds, for one component that is not mapped, over boxes in
    /// one piece.
    std::optional<EdgePolynomials::Curves> curves;
    /// For expressions: the derivatives by xi differ from those of a function with these second
    /// derivatives by at most this. `errors`: the rounding (ErrorsWith).
    std::array<double, 3> beside{};
    Errors errors{};
  };
  [[nodiscard]] Derivatives DerivativesOver(const EtaBox& box, const MapRanges& map) const;
  [[nodiscard]] Errors ErrorsWith(const Derivatives& derivatives) const;

  EdgeFunctions(const EdgeFunctions&) = delete;
  EdgeFunctions& operator=(const EdgeFunctions&) = delete;

private:
  /// The polynomials of a jet over a piece, in batches of similar degrees.
  struct JetBatches
  {
    struct Batch
    {
      std::vector<std::size_t> places; ///< in the jet's list
      PolynomialBatch polynomials;
    };
    std::vector<Batch> batches;
    std::size_t count = 0; ///< of all polynomials

    [[nodiscard]] std::size_t Bytes() const;
  };
  /// The modes of the component or of a mapped field's quotient.
  struct Modes
  {
    ScaledModes component;
    int count;
    std::optional<QuotientModes> quotient;
    bool known;
    std::unique_ptr<const ElementJet> jet;
  };
  static Modes ModesOf(const Mesh& mesh, const ElementBounds& bounds, int element,
    const Field& field, int component, double rounding);
  EdgeFunctions(
    const Mesh& mesh, const ElementBounds& bounds, int element, Modes modes, double rounding);
  [[nodiscard]] std::vector<EdgePolynomials::Function> Functions() const;
  /// Encloses det J, in the element's units, over a box.
  [[nodiscard]] Interval DivisorOver(const EtaBox& box, int subdivisions) const;
  void TakeSlack(const QuotientModes& quotient);
  void BoundErrors(double rounding);
  template <class Visit>
  void ForEachPiece(const EtaBox& box, const Visit& visit) const;
  [[nodiscard]] Interval RangeOver(
    const EtaBox& box, const ScaledModes& modes, int component, Part part) const;
  /// Calls visit(polynomials). The polynomials are kept as long as memory allows.
  template <class Visit>
  void WithPolynomials(const PieceForm::Piece& piece, const Visit& visit) const;
  [[nodiscard]] Interval ValuesOf(std::span<const Interval> components) const;
  [[nodiscard]] JetBounds JetOver(const EtaBox& box) const;
  [[nodiscard]] std::unique_ptr<const JetBatches> MakeJetBatches(
    const PieceForm::Piece& piece) const;
  [[nodiscard]] EtaBox PartOfBox(const EtaBox& box, const PieceForm::Piece& piece) const;
  void AddJet(const JetBounds& jet, Derivatives& ranges) const;
  [[nodiscard]] PointValues ValuesOfJet(std::span<const Vec3> xi) const;
  void ChooseLevel();
  /// The error of `components` functions together (RangeIngredient::RoundingInKernels).
  [[nodiscard]] double ErrorOf(const ScaledModes& modes, int components, Part part) const;

  ScaledModes Map;
  ScaledModes Component;
  std::optional<ScaledModes> Divisor;
  std::unique_ptr<const ElementJet> Jet; ///< of an expression, in place of the component
  KernelSet MapKernels;
  KernelSet ComponentKernels;
  int Count;
  bool Known;
  int Level = 0;
  int Subdivisions[2] = {};
  std::int64_t Cost = 0;
  std::int64_t CostOfJet = 0; ///< the part of the expression
  int Free = 0;
  std::int64_t CostOfView = 0;
  Vec3 Centre;
  double Unit;
  std::array<double, 3> Unsure;
  double Error = 0.0;
  double SlopeError = 0.0; ///< of values' derivatives by xi
  double DivisorError = 0.0;
  double DivisorSlopeError = 0.0;
  // The errors of the quotient's polynomials, by order of the derivative: QuotientModes.
  std::array<double, 3> Slack{};
  std::array<double, 3> DivisorSlack{};
  double MapError = 0.0;
  double MapSlopeError = 0.0;
  Interval Range;
  std::unique_ptr<PieceStore<EdgePolynomials>> Kept;
  std::unique_ptr<PieceStore<JetBatches>> JetPolynomials;
  std::unique_ptr<MadeOnDemand<EdgePolynomials::Cost>> Costs; ///< of subdivisions in a piece
};
} // namespace pixelexact
