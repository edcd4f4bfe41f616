// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Kernels.h"
#include "Core/Math/Vec.h"
#include "Core/Shape/Shape.h"

#include <memory>

namespace pixelexact
{
class ElementJet;
class ElementModels;
class ElementQuantity;
struct Mesh;

/// Lower and upper bounds, as arrays over points.
struct BoundArrays
{
  double* const* lower = nullptr;
  double* const* upper = nullptr;
};

/// Points of one element at which a function is evaluated; arrays of PaddedCount(xi.count) numbers,
/// coordinate by coordinate.
struct FunctionPoints
{
  LanePoints xi{};
  /// The points in the world, near Phi(xi); null: Phi(xi).
  const double* const* x = nullptr;
  /// Unit normals of a surface through the points; null where there is no surface.
  const double* const* normal = nullptr;
};

/// A function on a mesh that is evaluated at points and is no polynomial of xi: values of an
/// expression. Safe to use from several threads.
class FieldFunction
{
public:
  virtual ~FieldFunction() = default;

  /// Components of a value.
  [[nodiscard]] virtual int Components() const = 0;

  /// Throws Unsupported with the reason where Evaluate has no gradient.
  virtual void RequireGradient() const = 0;

  /// Whether values depend on the normal of a surface through the point.
  [[nodiscard]] virtual bool NeedsNormals() const = 0;

  /// Whether values at points of faces depend on the element on the other side (jumps): where there
  /// is none, and inside of elements, they may be NaN.
  [[nodiscard]] virtual bool NeedsNeighbours() const = 0;

  /// Evaluates at points of one element: `value[c]` and, unless it is null, `gradient[3 c + d]`,
  /// the derivative of component c by x_d in world units, as arrays of PaddedCount(xi.count)
  /// numbers. NaN and infinite where the function is. Throws as RequireGradient, and Unsupported
  /// where normals are needed and not given.
  virtual void Evaluate(const Mesh& mesh, int element, const FunctionPoints& points,
    double* const* value, double* const* gradient) const = 0;

  /// Intervals that hold the values at world points `x`, near whose preimages in the element `xi`
  /// are (EncloseValues); everything where nothing is proven.
  virtual void Enclose(const Mesh& mesh, int element, const LanePoints& xi, const LanePoints& x,
    const BoundArrays& values) const = 0;

  /// All components together, as their Euclidean norm.
  static constexpr int kNorm = -1;
  /// A component, or the norm, over boxes of an element's eta. The mesh's arrays must outlive it.
  [[nodiscard]] virtual std::unique_ptr<ElementQuantity> OnElement(
    const Mesh& mesh, int element, int component) const = 0;
  /// Returns whether JetOnElement gives a jet. Functions with jumps or normals and those without a
  /// gradient have none.
  [[nodiscard]] virtual bool HasJets() const = 0;
  /// The same with its gradient, or, in its place, a scalar of which it is a strictly monotone
  /// function (JetValue), such as v . v for |v|. Null where there is none. `coordinateErrors`:
  /// bounds of the distances of points from the images of their xi, in world units.
  [[nodiscard]] virtual std::unique_ptr<ElementJet> JetOnElement(
    const Mesh& mesh, int element, int component, const Vec3& coordinateErrors) const = 0;
  /// Returns whether ModelsOnElement gives models on elements of a shape. Functions with normals or
  /// jumps have none, nor have second derivatives where eta is collapsed.
  [[nodiscard]] virtual bool HasModels(Shape shape) const = 0;
  /// All components over boxes of an element's eta and on surfaces in it. Null where there are
  /// none. The mesh's arrays must outlive it.
  [[nodiscard]] virtual std::unique_ptr<ElementModels> ModelsOnElement(
    const Mesh& mesh, int element) const = 0;
  /// The value of JetOnElement's scalar where the component, or the norm, has this value.
  [[nodiscard]] virtual double JetValue(int component, double value) const = 0;
};
} // namespace pixelexact
