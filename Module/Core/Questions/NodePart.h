// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/RootFinder.h"
#include "Core/Questions/Questions.h"

namespace pixelexact
{
/// What of a node a question is about: all of it, or its end on a face; and what the parameters of
/// a polynomial system over it stand for, two or three of the eta, each scaled to [0,1].
class NodePart
{
public:
  /// Without a face, all of the node.
  NodePart(const ElementTree::Node& node, const ShapeFace* face);

  /// Whether the node reaches the face.
  [[nodiscard]] bool IsEmpty() const { return Empty; }
  [[nodiscard]] const EtaBox& Box() const { return Part; }
  [[nodiscard]] int Variables() const { return Face ? 2 : 3; }

  /// A polynomial over the node, over the part.
  [[nodiscard]] BoxPolynomial Over(const BoxPolynomial& polynomial) const;
  /// In eta, rounded outwards.
  [[nodiscard]] std::array<Interval, 3> Outer(const ParameterIntervals& box) const;
  [[nodiscard]] EtaBox Outer(const ParameterBox& box) const;
  /// In eta, rounded inwards.
  [[nodiscard]] std::array<Interval, 3> Inner(const ParameterIntervals& box) const;
  /// Whether a box of eta lies inside of the cube: of a face, off its edges.
  [[nodiscard]] bool IsInside(const std::array<Interval, 3>& eta) const;

private:
  /// The direction of eta that a parameter stands for.
  [[nodiscard]] std::size_t DirectionOf(std::size_t parameter) const;
  /// Those of the part's own, for the direction of the face.
  [[nodiscard]] std::array<Interval, 3> Ends() const;
  [[nodiscard]] Interval At(std::size_t direction, double parameter) const;

  EtaBox Part;
  const ShapeFace* Face;
  bool Empty;
};

/// The values over a box of the unit cube, which may reach a little beyond: the mean value form.
Interval ValueOver(const BoxPolynomial& polynomial, const ParameterIntervals& box);
/// The values over a box of the unit cube: the hull.
Interval HullOver(BoxPolynomial polynomial, const ParameterBox& box);
} // namespace pixelexact
