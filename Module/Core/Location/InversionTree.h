// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/Verdict.h"
#include "Core/Location/InverseRoot.h"
#include "Core/Location/InversionNode.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace pixelexact
{
class PieceForm;

/// What an element holds of a point.
struct Preimages
{
  /// Inside: `roots` holds one inside; Outside: proven to hold none. Unknown: neither.
  Verdict verdict = Verdict::Unknown;
  /// In the shape. All of them, where all were asked for and `complete` is set.
  std::vector<InverseRoot> roots;
  bool complete = false;
  int boxes = 0; ///< looked at
};

/// The certified inverse of an element's map: a tree of boxes in eta, each with a frame of
/// certified deviation, grown where points are looked for. What is known of a box does not depend
/// on the point, so that a point in a tree that is grown costs a few products a box.
///
/// A box is left behind where its frame excludes the point, or where the map is regular
/// (injective) on it and the one root that it can hold is known. Newton's iteration finds the
/// roots. See Module/Documentation/location.md.
///
/// The answer depends on the point and the element alone, not on what the tree was asked before.
/// Safe to call from several threads, which take turns.
class InversionTree
{
public:
  InversionTree(const Mesh& mesh, int element, const ElementBounds& bounds);
  ~InversionTree();
  InversionTree(const InversionTree&) = delete;
  InversionTree& operator=(const InversionTree&) = delete;

  enum class Wanted : std::uint8_t
  {
    First, ///< one preimage is enough
    All
  };
  /// `known`: where Newton's iteration converged to, outside of the shape; NaN where it did not.
  Preimages Find(const Vec3& x, const Vec3& known, Wanted wanted);

  /// About the bytes held.
  [[nodiscard]] std::size_t MemoryUsage() const { return Bytes.load(std::memory_order_relaxed); }

private:
  struct Node;
  class Search;

  void Begin();
  std::unique_ptr<Node> MakeNode(const EtaBox& box, BoxCoefficients phi);
  bool Split(Node& node);
  bool IsRegular(Node& node);
  const BoxCoefficients& SlopesOf(Node& node);
  [[nodiscard]] BoxCoefficients ConvertPiece(const std::array<int, 3>& piece, bool slopes) const;
  void Account(const BoxCoefficients& coefficients, int sign);

  const double* Modes;
  ElementBounds Bounds;
  InverseProblem Problem;
  const PieceForm& Form;
  bool HasSlopes; ///< the derivatives by xi are polynomials
  std::vector<std::unique_ptr<Node>> Pieces;
  std::atomic<std::size_t> Bytes{ 0 };
  std::mutex Mutex;
};
} // namespace pixelexact
