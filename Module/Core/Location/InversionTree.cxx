// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/InversionTree.h"

#include "Core/Bernstein/BernsteinForm.h"
#include "Core/Bernstein/PieceForm.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace pixelexact
{
namespace
{
/// Boxes looked at before a point is called unknown.
constexpr int kBudget = 20000;
/// A box halved this often in a direction is smaller than what rounding leaves to decide.
constexpr int kMaxHalvings = 50;
/// A tree above this is not grown further; what it cannot decide then is unknown.
constexpr std::size_t kMaxBytes = std::size_t{ 512 } << 20U;
/// Roots nearer to each other than this, in a region where there can be but one, are one.
constexpr double kSameRoot = 1e-12;

constexpr Part kParts[3] = { Part::ByXi1, Part::ByXi2, Part::ByXi3 };

} // namespace

struct InversionTree::Node
{
  InversionNode known;
  std::array<int, 3> halvings{};
  Node* parent = nullptr;
  bool isUpper = false; ///< of its parent's halves
  std::array<int, 3> piece{};
  BoxCoefficients phi;    ///< until it is split
  BoxCoefficients slopes; ///< made when first asked for
  std::optional<bool> regular;
  int direction = -1; ///< of the split
  std::array<std::unique_ptr<Node>, 2> children;
};

/// The search for one point.
class InversionTree::Search
{
public:
  Search(InversionTree& tree, const Vec3& x, Wanted wanted)
    : Tree(tree)
    , X(x)
    , Reach(ReachOf(tree.Form.Degree()))
    , All(wanted == Wanted::All)
  {
    for (int c = 0; c < 3; ++c)
    {
      Y[static_cast<std::size_t>(c)] = (x[c] - tree.Problem.centre[c]) * tree.Problem.inverseSize;
    }
  }

  Preimages Run(const Vec3& known)
  {
    if (std::isfinite(known.x + known.y + known.z))
    {
      Roots.push_back({ known, 0.0, false, false });
      Errors.push_back(FaceTolerance(Tree.Problem, known));
      // It is hardly ever that there is another root.
      NearlyAffine = 0.125;
    }
    for (const auto& piece : Tree.Pieces)
    {
      Visit(*piece, false);
    }
    Preimages result;
    for (const InverseRoot& root : Roots)
    {
      if (root.inside)
      {
        result.roots.push_back(root);
      }
    }
    result.complete = !Undecided;
    result.boxes = kBudget - std::max(Budget, 0);
    result.verdict = !result.roots.empty() ? Verdict::Inside
      : Undecided                          ? Verdict::Unknown
                                           : Verdict::Outside;
    return result;
  }

private:
  [[nodiscard]] bool IsDone() const
  {
    return !All && std::ranges::any_of(Roots, [](const InverseRoot& root) { return root.inside; });
  }

  /// `searched`: the map is regular on a box around this one, and Newton's iteration has found a
  /// root elsewhere.
  void Visit(Node& node, bool searched)
  {
    if (IsDone() || !node.known.MightHold(Tree.Problem.space.shape, Y))
    {
      return;
    }
    if (Budget-- <= 0)
    {
      Undecided = true;
      return;
    }
    if (IsAtApex(node.known))
    {
      Add(AtApex(node.known));
      return;
    }
    if (searched ? node.known.IsAffine() : node.known.IsNearlyAffine(NearlyAffine))
    {
      if (IsSettled(node))
      {
        return;
      }
      if (const auto root = FindInverseRoot(Tree.Problem, X, node.known.Guess(Y)))
      {
        Add(*root);
        if (IsDone() || IsSettled(node))
        {
          return;
        }
        searched = Tree.IsRegular(node);
      }
    }
    if (!Tree.Split(node))
    {
      Undecided = true;
      return;
    }
    for (const auto& child : node.children)
    {
      Visit(*child, searched);
    }
  }

  /// Next to a pyramid's apex there is no root beyond the faces to be held against the tolerance.
  /// Where it is all that keeps a box from excluding the point, the point is within it.
  [[nodiscard]] bool IsAtApex(const InversionNode& node) const
  {
    const double rounding = std::max({ node.slack[0], node.slack[1], node.slack[2] });
    return Tree.Problem.space.shape == Shape::Pyramid &&
      1.0 - node.box.lower.z <= std::max(kApexRegion, 4.0 * rounding) && node.IsAffine();
  }

  /// The root, or the xi of the pyramid next to it.
  [[nodiscard]] InverseRoot AtApex(const InversionNode& node) const
  {
    const auto& problem = Tree.Problem;
    Vec3 root = node.Root(Y);
    Vec3 xi(0.0);
    constexpr int kSteps = 4;
    for (int step = 0; step < kSteps; ++step)
    {
      const double z = std::clamp(root.z, -1.0, 1.0);
      xi = { std::clamp(root.x, -1.0, -z), std::clamp(root.y, -1.0, -z), z };
      const std::array<double, 3> image = EvaluateMap(problem.space, Tree.Modes, xi);
      root = xi + node.Step({ Y[0] - image[0], Y[1] - image[1], Y[2] - image[2] });
    }
    const Vec3 correction = glm::abs(root - xi);
    return { xi, std::max({ correction.x, correction.y, correction.z }), true,
      IsOnFace(problem, xi) };
  }

  /// Whether every xi of the box is so near to a known root that no other could be told from it.
  [[nodiscard]] bool IsAtRoot(const EtaBox& box) const
  {
    const Shape shape = Tree.Problem.space.shape;
    return std::ranges::any_of(Roots,
      [&](const InverseRoot& root)
      {
        bool near = true;
        for (unsigned corner = 0; near && corner < 8; ++corner)
        {
          const Vec3 eta((corner & 1U) != 0U ? box.upper.x : box.lower.x,
            (corner & 2U) != 0U ? box.upper.y : box.lower.y,
            (corner & 4U) != 0U ? box.upper.z : box.lower.z);
          const Vec3 apart = glm::abs(TensorToReference(shape, eta) - root.xi);
          near = std::max({ apart.x, apart.y, apart.z }) <= kSameRoot;
        }
        return near;
      });
  }

  /// Whether a known root lies in the box or in its reach.
  [[nodiscard]] bool HoldsRoot(const EtaBox& box) const
  {
    const Shape shape = Tree.Problem.space.shape;
    for (std::size_t i = 0; i < Roots.size(); ++i)
    {
      // Where the root really is, it must be in the reach; nobody knows where that is if its
      // Jacobian is singular.
      const double error = std::max({ Errors[i].x, Errors[i].y, Errors[i].z });
      if (error > 0.0 &&
        Reaches(shape, box, Reach, Roots[i].xi, kSameRoot - std::max(error - kSameRoot, 0.0)))
      {
        return true;
      }
    }
    return false;
  }

  /// Whether the box can hold no root but a known one.
  bool IsSettled(Node& node)
  {
    return IsAtRoot(node.known.box) || (HoldsRoot(node.known.box) && Tree.IsRegular(node));
  }

  /// Two runs of the iteration to one root differ by rounding.
  void Add(const InverseRoot& root)
  {
    const Vec3 error = FaceTolerance(Tree.Problem, root.xi);
    const auto isSame = [&](const InverseRoot& known)
    {
      const Vec3 apart = glm::abs(known.xi - root.xi);
      const Vec3 tolerance = 4.0 * error + Vec3(kSameRoot);
      return apart.x <= tolerance.x && apart.y <= tolerance.y && apart.z <= tolerance.z &&
        known.inside == root.inside;
    };
    if (std::ranges::none_of(Roots, isSame))
    {
      Roots.push_back(root);
      Errors.push_back(error);
    }
  }

  InversionTree& Tree;
  Vec3 X;
  std::array<double, 3> Y{};
  double Reach;
  bool All;
  std::vector<InverseRoot> Roots; ///< inside or not
  std::vector<Vec3> Errors;       ///< how far rounding may have moved each
  int Budget = kBudget;
  bool Undecided = false;
  double NearlyAffine = 1.0; ///< boxes from which Newton's iteration is begun
};

InversionTree::InversionTree(const Mesh& mesh, int element, const ElementBounds& bounds)
  : Modes(mesh.map.Coefficients(element))
  , Bounds(bounds)
  , Problem(MakeInverseProblem(mesh, element, bounds))
  , Form(PieceForm::Of(Problem.space))
  , HasSlopes(true)
{
  for (std::size_t c = 0; c < 3; ++c)
  {
    HasSlopes = HasSlopes &&
      PieceForm::IsClosed(
        Problem.space, Modes + c * static_cast<std::size_t>(Problem.space.Modes()));
  }
}

InversionTree::~InversionTree() = default;

Preimages InversionTree::Find(const Vec3& x, const Vec3& known, Wanted wanted)
{
  const std::scoped_lock lock(Mutex);
  if (Pieces.empty())
  {
    Begin();
  }
  return Search(*this, x, wanted).Run(known);
}

void InversionTree::Begin()
{
  const int count = 1 << Form.Level();
  for (int i = 0; i < count; ++i)
  {
    for (int j = 0; j < count; ++j)
    {
      for (int k = 0; k < count; ++k)
      {
        const std::array<int, 3> piece{ i, j, k };
        EtaBox box;
        for (int d = 0; d < 3; ++d)
        {
          box.lower[d] = 2.0 * piece[static_cast<std::size_t>(d)] / count - 1.0;
          box.upper[d] = 2.0 * (piece[static_cast<std::size_t>(d)] + 1) / count - 1.0;
        }
        Pieces.push_back(MakeNode(box, ConvertPiece(piece, false)));
        Pieces.back()->piece = piece;
      }
    }
  }
}

BoxCoefficients InversionTree::ConvertPiece(const std::array<int, 3>& piece, bool slopes) const
{
  const auto modes = static_cast<std::size_t>(Problem.space.Modes());
  BoxCoefficients result;
  std::vector<double> converted(Form.Size());
  for (std::size_t f = 0; f < (slopes ? 9U : 3U); ++f)
  {
    const Part part = slopes ? kParts[f % 3] : Part::Value;
    const double* component = Modes + (slopes ? f / 3 : f) * modes;
    Form.Convert(part, piece, component, converted);
    result.Add(converted, Form.ErrorBound(part, piece, component));
  }
  return result;
}

std::unique_ptr<InversionTree::Node> InversionTree::MakeNode(const EtaBox& box, BoxCoefficients phi)
{
  auto node = std::make_unique<Node>();
  node->known.box = box;
  phi.Recentre();
  MakeFrame(Problem.space, Modes, Bounds, phi, node->known);
  node->phi = std::move(phi);
  Account(node->phi, 1);
  Bytes += sizeof(Node);
  return node;
}

void InversionTree::Account(const BoxCoefficients& coefficients, int sign)
{
  const std::size_t bytes = coefficients.values.size() * sizeof(double);
  Bytes += sign > 0 ? bytes : -bytes;
}

/// Makes a node's halves; false where it is too small, or the tree too large.
bool InversionTree::Split(Node& node)
{
  if (node.direction >= 0)
  {
    return true;
  }
  const Vec3 width = node.known.box.upper - node.known.box.lower;
  int direction = node.known.widest;
  if (node.halvings[static_cast<std::size_t>(direction)] >= kMaxHalvings)
  {
    direction = width.x >= width.y && width.x >= width.z ? 0 : (width.y >= width.z ? 1 : 2);
  }
  if (node.halvings[static_cast<std::size_t>(direction)] >= kMaxHalvings || Bytes > kMaxBytes)
  {
    return false;
  }
  EtaBox lower = node.known.box;
  EtaBox upper = lower;
  const double middle = 0.5 * (lower.lower[direction] + lower.upper[direction]);
  lower.upper[direction] = middle;
  upper.lower[direction] = middle;
  Account(node.phi, -1);
  BoxCoefficients phi = std::move(node.phi);
  BoxCoefficients above = phi.Halve(Form.Degree(), direction);
  node.children = { MakeNode(lower, std::move(phi)), MakeNode(upper, std::move(above)) };
  for (const auto& child : node.children)
  {
    child->parent = &node;
    child->piece = node.piece;
    child->halvings = node.halvings;
    ++child->halvings[static_cast<std::size_t>(direction)];
    if (node.regular == true)
    {
      child->regular = true;
    }
  }
  node.children[1]->isUpper = true;
  node.direction = direction;
  return true;
}

bool InversionTree::IsRegular(Node& node)
{
  if (!HasSlopes)
  {
    return false;
  }
  if (!node.regular)
  {
    node.regular = pixelexact::IsRegular(Form.Degree(), SlopesOf(node));
  }
  return *node.regular;
}

/// The Jacobian's coefficients over a node, from those of its parent.
const BoxCoefficients& InversionTree::SlopesOf(Node& node)
{
  if (node.slopes.values.empty())
  {
    if (node.parent == nullptr)
    {
      node.slopes = ConvertPiece(node.piece, true);
    }
    else
    {
      node.slopes = SlopesOf(*node.parent);
      BoxCoefficients above = node.slopes.Halve(Form.Degree(), node.parent->direction);
      if (node.isUpper)
      {
        node.slopes = std::move(above);
      }
    }
    Account(node.slopes, 1);
  }
  return node.slopes;
}

} // namespace pixelexact
