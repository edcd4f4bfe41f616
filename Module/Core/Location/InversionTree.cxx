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

constexpr Vec3 kApex{ -1.0, -1.0, 1.0 };

/// Beside the faces and next to its apex, a pyramid's map is continued as a constant
/// (CollapsedQuotient): what the iteration finds there need not be a root.
bool IsSmoothAt(Shape shape, const Vec3& xi)
{
  return shape != Shape::Pyramid || 1.0 - xi.z > 1e-7;
}

/// Halves functions along a direction: `lower` becomes the lower half, the upper one is returned.
BoxCoefficients HalveAll(const std::array<int, 3>& degree, int direction, BoxCoefficients& lower)
{
  BoxCoefficients upper;
  upper.values.resize(lower.values.size());
  const std::size_t functions = lower.error.size();
  const std::size_t size = lower.values.size() / functions;
  for (std::size_t f = 0; f < functions; ++f)
  {
    const auto part = std::span(lower.values).subspan(f * size, size);
    double largest = 0.0;
    for (const double b : part)
    {
      largest = std::max(largest, std::fabs(b));
    }
    // The coefficients shrink with the box, and with them what each halving rounds.
    lower.error[f] =
      NextUp(lower.error[f] + Gamma(degree[static_cast<std::size_t>(direction)] + 1) * largest);
    Halve(degree, direction, part, std::span(upper.values).subspan(f * size, size));
  }
  upper.error = lower.error;
  return upper;
}
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
    if (std::isfinite(known.x + known.y + known.z) && IsSmoothAt(Tree.Problem.space.shape, known))
    {
      Roots.push_back({ known, 0.0, false, false });
    }
    AddApex();
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
    if (!searched && node.known.IsNearlyAffine())
    {
      if (IsSettled(node))
      {
        return;
      }
      if (const auto root = Tree.FindRoot(X, node.known.Guess(Y)))
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

  /// A pyramid's map is not smooth at its apex: the iteration may miss it. Frames and hulls, which
  /// hold the uncertainty twice over and the rounding of the coefficients, cannot exclude points
  /// that are nearer to it than some uncertainties.
  void AddApex()
  {
    const auto& problem = Tree.Problem;
    if (problem.space.shape != Shape::Pyramid)
    {
      return;
    }
    const std::array<double, 3> apex = EvaluateMap(problem.space, Tree.Modes, kApex);
    bool within = true;
    for (std::size_t c = 0; c < 3; ++c)
    {
      within = within && std::fabs(apex[c] - Y[c]) <= 8.0 * problem.uncertainty[c];
    }
    if (within)
    {
      Roots.push_back({ kApex, 0.0, true, true });
    }
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
    return std::ranges::any_of(Roots,
      [&](const InverseRoot& root) { return Reaches(shape, box, Reach, root.xi, kSameRoot); });
  }

  /// Whether the box can hold no root but a known one.
  bool IsSettled(Node& node)
  {
    return IsAtRoot(node.known.box) || (HoldsRoot(node.known.box) && Tree.IsRegular(node));
  }

  /// Two runs of the iteration to one root differ by rounding.
  void Add(const InverseRoot& root)
  {
    const auto isSame = [&](const InverseRoot& known)
    {
      const Vec3 apart = glm::abs(known.xi - root.xi);
      const Vec3 tolerance = 4.0 * FaceTolerance(Tree.Problem, root.xi) + Vec3(kSameRoot);
      return apart.x <= tolerance.x && apart.y <= tolerance.y && apart.z <= tolerance.z &&
        known.inside == root.inside;
    };
    if (std::ranges::none_of(Roots, isSame))
    {
      Roots.push_back(root);
    }
  }

  InversionTree& Tree;
  Vec3 X;
  std::array<double, 3> Y{};
  double Reach;
  bool All;
  std::vector<InverseRoot> Roots; ///< inside or not
  int Budget = kBudget;
  bool Undecided = false;
};

InversionTree::InversionTree(const Mesh& mesh, int element, const ElementBounds& bounds)
  : Modes(mesh.map.Coefficients(element))
  , Bounds(bounds)
  , Problem(MakeInverseProblem(mesh, element, bounds))
  , Kernels(KernelsFor(Problem.space))
  , Form(PieceForm::Of(Problem.space))
  , HasSlopes(true)
{
  // A frame of zero slope lets the kernel's iteration begin where we want it.
  std::fill_n(Problem.inverse, 9, 0.0);
  Problem.affine = false;
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
  const std::size_t functions = slopes ? 9 : 3;
  BoxCoefficients result;
  result.values.resize(functions * Form.Size());
  for (std::size_t f = 0; f < functions; ++f)
  {
    const Part part = slopes ? kParts[f % 3] : Part::Value;
    const double* component = Modes + (slopes ? f / 3 : f) * modes;
    Form.Convert(
      part, piece, component, std::span(result.values).subspan(f * Form.Size(), Form.Size()));
    result.error.push_back(Form.ErrorBound(part, piece, component));
  }
  return result;
}

std::unique_ptr<InversionTree::Node> InversionTree::MakeNode(const EtaBox& box, BoxCoefficients phi)
{
  auto node = std::make_unique<Node>();
  node->known.box = box;
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
  BoxCoefficients above = HalveAll(Form.Degree(), direction, phi);
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
      BoxCoefficients above = HalveAll(Form.Degree(), node.parent->direction, node.slopes);
      if (node.isUpper)
      {
        node.slopes = std::move(above);
      }
    }
    Account(node.slopes, 1);
  }
  return node.slopes;
}

std::optional<InverseRoot> InversionTree::FindRoot(const Vec3& x, const Vec3& start) const
{
  InverseProblem problem = Problem;
  double lanes[9][kLanePadding];
  for (int d = 0; d < 3; ++d)
  {
    problem.start[d] = start[d];
    std::fill_n(lanes[d], kLanePadding, x[d]);
  }
  const InverseResult result{ { lanes[3], lanes[4], lanes[5] }, lanes[6], lanes[7], lanes[8] };
  Kernels.invert(problem, { { lanes[0], lanes[1], lanes[2] }, 1 }, result);
  if (lanes[6][0] == static_cast<double>(NewtonStatus::NotConverged))
  {
    return std::nullopt;
  }
  InverseRoot root{ { lanes[3][0], lanes[4][0], lanes[5][0] }, lanes[8][0], false, false };
  root.inside = lanes[6][0] == static_cast<double>(NewtonStatus::RootInside);
  if (!root.inside && !IsSmoothAt(Problem.space.shape, root.xi))
  {
    return std::nullopt;
  }
  root.onFace = root.inside && IsOnFace(Problem, root.xi);
  return root;
}

Vec3 FaceTolerance(const InverseProblem& problem, const Vec3& xi)
{
  const auto inverse = InverseJacobian(problem.space, problem.coefficients, xi);
  Vec3 tolerance(0.0);
  for (int d = 0; inverse && d < 3; ++d)
  {
    for (int c = 0; c < 3; ++c)
    {
      tolerance[d] +=
        std::fabs((*inverse)[static_cast<std::size_t>(d)][static_cast<std::size_t>(c)]) *
        problem.uncertainty[c];
    }
  }
  return tolerance;
}

bool IsOnFace(const InverseProblem& problem, const Vec3& xi)
{
  const Vec3 tolerance = FaceTolerance(problem, xi);
  return !(Margin(problem.space.shape, xi) > tolerance.x + tolerance.y + tolerance.z);
}
} // namespace pixelexact
