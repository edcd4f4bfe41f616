// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/ElementQuantity.h"
#include "Core/Element/HessianFunction.h"
#include "Core/Element/Mesh.h"
#include "Core/Expression/BoxValue.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace pixelexact
{
inline constexpr auto& kPairAt = HessianFunction::kPlaces;
/// The number of third derivatives, 111, 112, 113, 122, 123, 133, 222, 223, 233, 333.
inline constexpr std::size_t kThirds = 10;

/// Leaves of a graph on one element, over boxes: the polynomials in eta that they depend on, and
/// the value of each leaf from enclosures of those. Derivatives by x are computed from derivatives
/// by xi and the inverse Jacobian.
///
/// Mapped fields (H(curl), H(div), densities) have values alone, other fields derivatives up to the
/// third (HessianFunction::Thirds). Normals and values behind faces are unbounded.
class BoxLeaves
{
public:
  /// `fields`, `numbers` and the mesh must outlive it.
  BoxLeaves(std::span<const Graph::Node> leaves, std::span<const Field* const> fields,
    std::span<const std::int64_t> numbers, const Mesh& mesh, int element);

  [[nodiscard]] bool IsFinite() const { return Finite; }
  /// The level on which all of the polynomials are converted.
  [[nodiscard]] int Level() const { return level_; }
  [[nodiscard]] std::vector<BoxPolynomial> Polynomials(
    int level, const PieceForm::Piece& piece, const Box3& within) const;
  /// An estimate of the work of one box, with the operations of Evaluate.
  [[nodiscard]] ElementJet::Work WorkOf(int level) const;
  /// `polynomials`: enclosures of Polynomials, in their order, as BoxValue or ModelValue. Writes
  /// one value for each leaf, and d Phi / d xi in world units, row-major, to `jacobian` if given.
  template <class T>
  void Evaluate(std::span<const T> polynomials, std::span<T> leaves,
    std::array<T, 9>* jacobian = nullptr) const;

  /// Requests the Jacobian and bounds of rounding; Evaluate then includes the rounding errors of
  /// the kernels' values of the polynomials. `coordinateErrors`: see FieldFunction.
  void NeedJet(const Vec3& coordinateErrors);
  /// For each polynomial, a bound of the rounding of the kernels' values.
  [[nodiscard]] std::span<const double> Errors() const { return OfKernels; }

private:
  /// Places in the list of polynomials of a component of a field or of the map: the value, and the
  /// first of three derivatives by xi. -1: not in the list.
  struct Places
  {
    int value = -1;
    int slope = -1;
    bool hasSeconds = false;    ///< second derivatives come last, in the order of the components
    bool hasThirds = false;     ///< and third ones behind them
    bool hasCurvatures = false; ///< second derivatives by x
    bool hasTurned = false;     ///< derivatives by xi of those by x
    double secondsError = 0.0;  ///< of the kernels' second derivatives by xi
  };
  struct NeededField
  {
    const Field* field = nullptr;
    std::unique_ptr<const ScaledModes> modes; ///< null: the field is not needed
    std::vector<Places> components;
  };
  template <class T>
  struct Products;
  template <class T>
  struct FieldDerivatives;
  void Need(const Graph::Node& leaf);
  void NeedJacobian();
  void Choose(const ScaledModes& modes, int component, bool slopes, Places& places);
  [[nodiscard]] double UnitOfMap() const;
  template <class T>
  [[nodiscard]] Products<T> ProductsOf(std::span<const T> p) const;
  template <class T>
  [[nodiscard]] T LeafOf(
    const Graph::Node& leaf, std::span<const T> p, const Products<T>& products) const;
  template <class T>
  [[nodiscard]] T FieldValue(
    const Graph::Node& leaf, std::span<const T> p, const Products<T>& products) const;
  template <class T>
  [[nodiscard]] T FieldDerivative(
    const Graph::Node& leaf, std::span<const T> p, const Products<T>& products) const;
  template <class Visit>
  void ForEachDifferentiated(const Visit& visit) const;
  template <class T>
  [[nodiscard]] static FieldDerivatives<T> DerivativesOf(const Products<T>& products,
    std::span<const T> slopes, const std::array<T, 6>& seconds, std::span<const T> thirds,
    const Places& places);

  std::vector<Graph::Node> Leaves;
  Mesh mesh_;
  int Element;
  ScaledModes Map;
  std::array<Places, 3> OfMap;
  std::vector<NeededField> Fields;
  std::vector<RangeIngredient> Ingredients;
  bool NeedsJacobian = false;
  bool NeedsXi = false;
  bool NeedsSeconds = false;
  bool NeedsThirds = false;
  int level_ = 0;
  bool Finite = true;
  Vec3 OfCoordinates{ 0.0 };
  std::vector<double> OfKernels;
  double OfBends = 0.0; ///< second derivatives of the map
};

template <class Visit>
void BoxLeaves::ForEachDifferentiated(const Visit& visit) const
{
  for (const NeededField& needed : Fields)
  {
    for (std::size_t c = 0; c < needed.components.size(); ++c)
    {
      if (needed.components[c].slope >= 0)
      {
        visit(needed, static_cast<int>(c), needed.components[c]);
      }
    }
  }
}
} // namespace pixelexact
