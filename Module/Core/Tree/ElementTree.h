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

/// What is kept of an element's map: a tree of boxes in eta, each with a frame of certified
/// deviation, grown where somebody looks. What is known of a box does not depend on what is asked,
/// so that a question in a tree that is grown costs a few products a box.
///
/// Safe to use from several threads: nodes are read without a lock, and grow one at a time.
class ElementTree
{
public:
  class Node;

  /// `total`: what it holds is added to it as well.
  ElementTree(
    const Mesh& mesh, int element, const ElementBounds& bounds, std::atomic<std::int64_t>& total);
  ~ElementTree();
  ElementTree(const ElementTree&) = delete;
  ElementTree& operator=(const ElementTree&) = delete;

  /// The element's map; Newton's iteration begins as the element's bounds say.
  [[nodiscard]] const InverseProblem& Problem() const { return problem_; }
  /// The degree of Phi in each eta.
  [[nodiscard]] const std::array<int, 3>& Degree() const;
  /// The boxes that the tree begins with: together the whole element. Of high orders, they are
  /// converted with rounding that is far below what bends but above the uncertainty of the map; the
  /// smaller pieces on which it is not (PieceForm.h) are converted where halving leads to them.
  const std::vector<std::unique_ptr<Node>>& Pieces();
  /// How often a coarse one is halved before its halves are converted.
  [[nodiscard]] int CoarseSubdivisions() const;
  /// Makes a node's halves; false where it is too small.
  bool Split(Node& node);
  /// Whether the map is injective on a node's box and its reach (IsRegular).
  bool IsRegular(Node& node);
  /// Whether the map has no thickness, within rounding, at points all over a node's box: no part of
  /// it is found to be regular then, however small.
  bool IsFlat(Node& node);

  /// About how much it costs to make the pieces, a node's halves, those of this node, and to test
  /// whether a node is regular. In nanoseconds, whether they have been made or not.
  [[nodiscard]] std::int64_t BeginCost() const;
  [[nodiscard]] std::int64_t SplitCost() const;
  [[nodiscard]] std::int64_t SplitCost(const Node& node) const;
  [[nodiscard]] std::int64_t RegularCost(const Node& node) const;

  /// About the bytes held.
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
  /// Of the box; does not change.
  [[nodiscard]] const NodeFrame& Frame() const { return frame_; }
  /// Every xi of the box is within 2e-12 of every other.
  [[nodiscard]] bool IsPoint() const { return Point; }
  /// After Split.
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
  bool IsUpper = false;            ///< of its parent's halves
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
