// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Tree/NodeFrame.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

namespace pixelexact
{
class PieceForm;

/// A tree of boxes in eta for an element's map, each box with a frame of certified deviation. The
/// tree grows on demand. The frame of a box does not depend on the query, so that a query in an
/// existing tree costs a few products per box.
///
/// Safe to use from several threads: nodes are read without a lock, and grow one at a time.
class ElementTree
{
public:
  class Node;

  /// `total`: a counter to which the tree adds the bytes that it holds.
  ElementTree(
    const Mesh& mesh, int element, const ElementBounds& bounds, std::atomic<std::int64_t>& total);
  ~ElementTree();
  ElementTree(const ElementTree&) = delete;
  ElementTree& operator=(const ElementTree&) = delete;

  /// The element's map. Newton's iteration begins as the element's bounds state.
  [[nodiscard]] const InverseProblem& Problem() const { return problem_; }
  /// The degree of Phi in each eta.
  [[nodiscard]] const std::array<int, 3>& Degree() const;
  /// The initial boxes of the tree; together they cover the whole element. For high orders they are
  /// converted with a rounding error that is far below the map's deviation but above the map's
  /// uncertainty. The smaller pieces with an error below that (PieceForm.h) are converted where
  /// subdivision reaches them.
  const std::vector<std::unique_ptr<Node>>& Pieces();
  /// The number of subdivisions of a coarse box before its children are converted.
  [[nodiscard]] int CoarseSubdivisions() const;
  /// Creates a node's children. Returns false where the node is too small.
  bool Split(Node& node);
  /// Whether the map is injective on a node's box and its reach (IsRegular).
  bool IsRegular(Node& node);
  /// Whether the map has no thickness, within rounding, at points all over a node's box. Then no
  /// part of the box is proven to be regular, however small.
  bool IsFlat(Node& node);

  /// The estimated costs of converting the pieces, of the children of a node, of the children of
  /// this node, and of the test whether a node is regular. In nanoseconds, whether the results
  /// exist already or not.
  [[nodiscard]] std::int64_t BeginCost() const;
  [[nodiscard]] std::int64_t SplitCost() const;
  [[nodiscard]] std::int64_t SplitCost(const Node& node) const;
  [[nodiscard]] std::int64_t RegularCost(const Node& node) const;

  /// An estimate of the bytes held.
  [[nodiscard]] std::int64_t MemoryUsage() const { return Bytes.load(std::memory_order_relaxed); }

private:
  std::unique_ptr<Node> MakeNode(const EtaBox& box, BoxCoefficients phi);
  std::unique_ptr<Node> MakePiece(const PieceForm& form, const std::array<int, 3>& piece);
  std::unique_ptr<Node> MakeHalf(
    const Node& node, const EtaBox& box, int direction, BoxCoefficients phi);
  [[nodiscard]] std::array<int, 3> PieceOf(const EtaBox& box) const;
  [[nodiscard]] bool IsCoarse(const Node& node) const;
  [[nodiscard]] bool LeadsToPieces(const Node& node) const;
  [[nodiscard]] int DirectionOf(const Node& node) const;
  [[nodiscard]] bool IsClassifiedByFrames() const;
  [[nodiscard]] int HighestDegree() const;
  const BoxCoefficients& SlopesOf(Node& node);
  [[nodiscard]] BoxCoefficients ConvertPiece(
    const PieceForm& form, const std::array<int, 3>& piece, bool slopes) const;
  void Account(std::int64_t bytes);

  const double* Modes;
  ElementBounds Bounds;
  InverseProblem problem_;
  const PieceForm& Form;
  const PieceForm& Coarse; ///< of the boxes to begin with; the same where they are as good
  bool HasSlopes;          ///< the derivatives by xi are polynomials
  std::vector<std::unique_ptr<Node>> Roots;
  std::atomic<bool> HasRoots{ false };
  std::atomic<std::int64_t> Bytes{ 0 };
  std::atomic<std::int64_t>& Total;
  std::mutex Growing;
};

/// A box of a tree.
class ElementTree::Node
{
public:
  /// The frame of the box; it does not change.
  [[nodiscard]] const NodeFrame& Frame() const { return frame_; }
  /// Whether every xi of the box is within 2e-12 of every other.
  [[nodiscard]] bool IsPoint() const { return Point; }
  /// The node must have been split.
  [[nodiscard]] Node& Child(std::size_t half) const { return *Children[half]; }

private:
  friend class ElementTree;
  enum class Answer : std::uint8_t
  {
    Unknown,
    No,
    Yes
  };

  NodeFrame frame_;
  bool Point = false;
  std::array<int, 3> Subdivisions{}; ///< of the piece; of what is coarse, of the element
  Node* Parent = nullptr;
  bool IsUpper = false;            ///< of its parent's children
  const PieceForm* Form = nullptr; ///< of its coefficients, over this piece of it
  std::array<int, 3> Piece{};
  BoxCoefficients Phi;    ///< until it is split
  BoxCoefficients Slopes; ///< made when first asked for
  std::atomic<Answer> IsRegular{ Answer::Unknown };
  std::atomic<Answer> IsFlat{ Answer::Unknown };
  std::atomic<int> Direction{ -1 }; ///< of the split
  std::array<std::unique_ptr<Node>, 2> Children;
};
} // namespace pixelexact
