// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Ranges.h"
#include "Core/Index/ElementIndex.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace pixelexact
{
/// A face of a shape: an end of the cube of eta that is not collapsed.
struct ShapeFace
{
  int direction = 0;  ///< of eta
  bool upper = false; ///< eta_direction = 1, not -1
};

/// All faces of a shape.
std::span<const ShapeFace> FacesOf(Shape shape);

enum class CrossingStatus : std::uint8_t
{
  /// In the element (on the face that was asked for, off its edges) and on the segment.
  Certain,
  /// As certain, but within its enclosure of the element's boundary (of the face's edges): it may
  /// lie just beyond, and a neighbour may report it too.
  OnBoundary,
  /// Neither, but within its enclosure of an end of the segment: it may lie just beyond.
  AtEnd
};

/// One crossing, proven: there is exactly one in these enclosures.
struct Crossing
{
  CrossingStatus status = CrossingStatus::Certain;
  int element = 0;
  Interval t;                  ///< the point is from + t (to - from)
  std::array<Interval, 3> eta; ///< may reach beyond the cube by its own width
  double middle = 0.0;         ///< a t of the enclosure
  Vec3 xi{ 0.0 };              ///< of a point of the enclosure
};

/// Where there may be crossings that are not listed.
struct UndecidedCrossing
{
  Interval t;
  EtaBox box;
};

struct Crossings
{
  std::vector<Crossing> found; ///< in ascending order of t's middle
  std::vector<UndecidedCrossing> undecided;
  std::int64_t nodes = 0; ///< of the tree, looked at
  std::int64_t boxes = 0; ///< of the referee

  /// Whether those found are all there are.
  [[nodiscard]] bool IsComplete() const { return undecided.empty(); }
};

struct QuestionEffort
{
  int nodes = 2000; ///< of the tree
  int boxes = 4000; ///< of the referee
};

/// Questions about the segments that cross an element: with its faces, and with the values of a
/// component of a field. See Documentation/questions.md for the method and what is proven.
///
/// Everything holds for the stored map moved by any vector within the mesh's uncertainty, so that
/// every crossing of the map that the source meant is found or undecided, for the segment's ends
/// moved by its slack, and for the field exactly as stored. An answer depends on the question and
/// the element alone. What exceeds the effort is undecided; so is a segment without length, or with
/// an end that is not finite, unless it misses the element.
///
/// Keeps the element's tree, and the polynomials over the nodes that were asked. Not safe to use
/// from several threads: each makes its own; they share the tree.
class ElementQuestions
{
public:
  /// The index must outlive the object, and so must the field's arrays.
  ElementQuestions(const ElementIndex& index, int element);
  /// Throws Unsupported for a mapped field (H(curl), H(div), density).
  ElementQuestions(const ElementIndex& index, int element, const Field& field, int component);
  ~ElementQuestions();
  ElementQuestions(const ElementQuestions&) = delete;
  ElementQuestions& operator=(const ElementQuestions&) = delete;

  /// All crossings of a segment with a face of the element.
  Crossings WithFace(
    const Segment& segment, const ShapeFace& face, const QuestionEffort& effort = {});
  /// All points of a segment in the element where the component has this value.
  Crossings WithValue(const Segment& segment, double value, const QuestionEffort& effort = {});

private:
  class Search;
  struct Internals;
  std::unique_ptr<Internals> Data;
};

/// A node's box, as the part of an element that RangeOf and HessianRange take.
inline Box3 PartOf(const ElementTree::Node& node)
{
  return { node.Frame().box.lower, node.Frame().box.upper };
}
} // namespace pixelexact
