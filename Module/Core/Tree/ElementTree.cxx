// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tree/ElementTree.h"

#include "Core/Bernstein/PieceForm.h"
#include "Core/Tree/Regularity.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace pixelexact
{
namespace
{
/// A box subdivided this often in a direction is smaller than rounding can resolve.
constexpr int kMaxSubdivisions = 50;
constexpr double kPoint = 2e-12;

constexpr Part kParts[3] = { Part::ByXi1, Part::ByXi2, Part::ByXi3 };

/// The measured cost in nanoseconds of `size` coefficients of this degree, for subdivision and the
/// frame of a box, or for the products that prove a box regular. Large sizes use whole packs.
std::int64_t CostOf(std::size_t size, int degree)
{
  const auto count = static_cast<std::int64_t>(size);
  return size > 3 * kMaxWithSlopes ? count * (34 + 3 * degree) / 10 : count * (12 + degree / 2);
}

std::int64_t BytesOf(const BoxCoefficients& coefficients)
{
  return static_cast<std::int64_t>(coefficients.values.size() * sizeof(double));
}

/// Pieces of a higher level than this are converted on demand.
constexpr int kMaxLevel = 1;

/// The largest error of coefficients, in the element's units, of a useful box.
constexpr double kCoarseError = 1e-6;

/// The coarsest form in which the rounding of every coefficient is at most `most`, or else the form
/// for arbitrary modes.
const PieceForm& FormWithin(const InverseProblem& problem, std::span<const double, 3> most)
{
  const Space& space = problem.space;
  const int last = PieceForm::LevelOf(space.MaxOrder());
  for (int level = last > kMaxLevel ? 0 : last; level < last; ++level)
  {
    const PieceForm& form = PieceForm::Of(space, level);
    bool small = true;
    for (std::size_t c = 0; small && c < 3; ++c)
    {
      const double* component = problem.coefficients + c * static_cast<std::size_t>(space.Modes());
      // Pieces in corners have the largest errors, and these are similar.
      small = form.ErrorBound(Part::Value, { 0, 0, 0 }, component) <= most[c];
    }
    if (small)
    {
      return form;
    }
  }
  return PieceForm::Of(space);
}

const PieceForm& CoarseForm(const InverseProblem& problem, const PieceForm& form)
{
  constexpr std::array<double, 3> kMax{ kCoarseError, kCoarseError, kCoarseError };
  const PieceForm& coarse = FormWithin(problem, kMax);
  return coarse.Level() < form.Level() ? coarse : form;
}

bool IsPointBox(Shape shape, const EtaBox& box)
{
  const Box3 hull = HullInXi(shape, box);
  const Vec3 width = hull.upper - hull.lower;
  return std::max({ width.x, width.y, width.z }) <= kPoint;
}
} // namespace

ElementTree::ElementTree(
  const Mesh& mesh, int element, const ElementBounds& bounds, std::atomic<std::int64_t>& total)
  : Modes(mesh.map.Coefficients(element))
  , Bounds(bounds)
  , problem_(MakeInverseProblem(mesh, element, Bounds))
  , Form(FormWithin(problem_, problem_.uncertainty))
  , Coarse(CoarseForm(problem_, Form))
  , HasSlopes(true)
  , Total(total)
{
  for (std::size_t c = 0; c < 3; ++c)
  {
    HasSlopes = HasSlopes &&
      PieceForm::IsClosed(
        problem_.space, Modes + c * static_cast<std::size_t>(problem_.space.Modes()));
  }
}

ElementTree::~ElementTree()
{
  Account(-MemoryUsage());
}

const std::array<int, 3>& ElementTree::Degree() const
{
  return Form.Degree();
}

int ElementTree::CoarseSubdivisions() const
{
  return 3 * (Form.Level() - Coarse.Level());
}

std::int64_t ElementTree::BeginCost() const
{
  return SplitCost() << 3U * static_cast<unsigned>(Coarse.Level());
}

std::int64_t ElementTree::SplitCost() const
{
  return 3000 + CostOf(3 * Form.Size(), HighestDegree());
}

std::int64_t ElementTree::SplitCost(const Node& node) const
{
  return LeadsToPieces(node) ? 3 * SplitCost() : SplitCost();
}

std::int64_t ElementTree::RegularCost(const Node& node) const
{
  return node.frame_.injective || IsClassifiedByFrames()
    ? 0
    : 2000 + 3 * CostOf(3 * Form.Size(), HighestDegree());
}

int ElementTree::HighestDegree() const
{
  return *std::ranges::max_element(Form.Degree());
}

bool ElementTree::IsClassifiedByFrames() const
{
  return problem_.space.shape == Shape::Hexahedron && Form.Size() > kMaxWithSlopes;
}

const std::vector<std::unique_ptr<ElementTree::Node>>& ElementTree::Pieces()
{
  if (HasRoots.load(std::memory_order_acquire))
  {
    return Roots;
  }
  const std::scoped_lock lock(Growing);
  if (HasRoots.load(std::memory_order_relaxed))
  {
    return Roots;
  }
  const int count = 1 << Coarse.Level();
  for (int i = 0; i < count; ++i)
  {
    for (int j = 0; j < count; ++j)
    {
      for (int k = 0; k < count; ++k)
      {
        Roots.push_back(MakePiece(Coarse, { i, j, k }));
      }
    }
  }
  HasRoots.store(true, std::memory_order_release);
  return Roots;
}

BoxCoefficients ElementTree::ConvertPiece(
  const PieceForm& form, const std::array<int, 3>& piece, bool slopes) const
{
  const auto modes = static_cast<std::size_t>(problem_.space.Modes());
  BoxCoefficients result;
  std::vector<double> converted(form.Size());
  for (std::size_t f = 0; f < (slopes ? 9U : 3U); ++f)
  {
    const Part part = slopes ? kParts[f % 3] : Part::Value;
    const double* component = Modes + (slopes ? f / 3 : f) * modes;
    form.Convert(part, piece, component, converted);
    result.Add(converted, form.ErrorBound(part, piece, component));
  }
  return result;
}

std::unique_ptr<ElementTree::Node> ElementTree::MakePiece(
  const PieceForm& form, const std::array<int, 3>& piece)
{
  EtaBox box;
  for (int d = 0; d < 3; ++d)
  {
    const int k = piece[static_cast<std::size_t>(d)];
    box.lower[d] = std::ldexp(k, 1 - form.Level()) - 1.0;
    box.upper[d] = std::ldexp(k + 1, 1 - form.Level()) - 1.0;
  }
  auto node = MakeNode(box, ConvertPiece(form, piece, false));
  node->Form = &form;
  node->Piece = piece;
  if (IsCoarse(*node))
  {
    node->Subdivisions.fill(form.Level());
  }
  return node;
}

std::unique_ptr<ElementTree::Node> ElementTree::MakeNode(const EtaBox& box, BoxCoefficients phi)
{
  auto node = std::make_unique<Node>();
  node->frame_.box = box;
  node->Point = IsPointBox(problem_.space.shape, box);
  phi.Recentre();
  MakeFrame(problem_.space, Modes, Bounds, phi, node->frame_);
  node->Phi = std::move(phi);
  Account(BytesOf(node->Phi) + static_cast<std::int64_t>(sizeof(Node)));
  return node;
}

std::unique_ptr<ElementTree::Node> ElementTree::MakeHalf(
  const Node& node, const EtaBox& box, int direction, BoxCoefficients phi)
{
  auto half = MakeNode(box, std::move(phi));
  half->Form = node.Form;
  half->Piece = node.Piece;
  half->Subdivisions = node.Subdivisions;
  ++half->Subdivisions[static_cast<std::size_t>(direction)];
  return half;
}

/// The piece of the conversion that equals a box.
std::array<int, 3> ElementTree::PieceOf(const EtaBox& box) const
{
  std::array<int, 3> piece{};
  for (int d = 0; d < 3; ++d)
  {
    piece[static_cast<std::size_t>(d)] =
      static_cast<int>(std::ldexp(box.lower[d] + 1.0, Form.Level() - 1));
  }
  return piece;
}

void ElementTree::Account(std::int64_t bytes)
{
  Bytes.fetch_add(bytes, std::memory_order_relaxed);
  Total.fetch_add(bytes, std::memory_order_relaxed);
}

bool ElementTree::Split(Node& node)
{
  if (node.Direction.load(std::memory_order_acquire) >= 0)
  {
    return true;
  }
  const std::scoped_lock lock(Growing);
  if (node.Direction.load(std::memory_order_relaxed) >= 0)
  {
    return true;
  }
  const int direction = DirectionOf(node);
  if (direction < 0)
  {
    return false;
  }
  EtaBox lower = node.frame_.box;
  EtaBox upper = node.frame_.box;
  const double middle = 0.5 * (lower.lower[direction] + lower.upper[direction]);
  lower.upper[direction] = middle;
  upper.lower[direction] = middle;
  Account(-BytesOf(node.Phi));
  BoxCoefficients phi = std::move(node.Phi);
  if (LeadsToPieces(node))
  {
    node.Children = { MakePiece(Form, PieceOf(lower)), MakePiece(Form, PieceOf(upper)) };
  }
  else
  {
    BoxCoefficients above = phi.Subdivide(Form.Degree(), direction);
    node.Children = { MakeHalf(node, lower, direction, std::move(phi)),
      MakeHalf(node, upper, direction, std::move(above)) };
  }
  for (const auto& child : node.Children)
  {
    child->Parent = &node;
  }
  node.Children[1]->IsUpper = true;
  node.Direction.store(direction, std::memory_order_release);
  return true;
}

bool ElementTree::IsCoarse(const Node& node) const
{
  return node.Form != &Form;
}

/// Whether the node's children are converted instead of subdivided.
bool ElementTree::LeadsToPieces(const Node& node) const
{
  return IsCoarse(node) &&
    node.Subdivisions[0] + node.Subdivisions[1] + node.Subdivisions[2] == 3 * Form.Level() - 1;
}

/// The direction in which a node is subdivided; -1 where it is too small. Coarse nodes do not
/// become narrower than a piece.
int ElementTree::DirectionOf(const Node& node) const
{
  const int most = IsCoarse(node) ? Form.Level() : kMaxSubdivisions;
  const auto mayBe = [&](int d) { return node.Subdivisions[static_cast<std::size_t>(d)] < most; };
  if (mayBe(node.frame_.widest))
  {
    return node.frame_.widest;
  }
  const Vec3 width = node.frame_.box.upper - node.frame_.box.lower;
  int direction = -1;
  for (int d = 0; d < 3; ++d)
  {
    if (mayBe(d) && (direction < 0 || width[d] > width[direction]))
    {
      direction = d;
    }
  }
  return direction;
}

bool ElementTree::IsRegular(Node& node)
{
  using Answer = Node::Answer;
  if (node.frame_.injective)
  {
    return true;
  }
  if (!HasSlopes || IsClassifiedByFrames())
  {
    return false;
  }
  Answer regular = node.IsRegular.load(std::memory_order_acquire);
  if (regular == Answer::Unknown)
  {
    const std::scoped_lock lock(Growing);
    regular = pixelexact::IsRegular(Form.Degree(), SlopesOf(node)) ? Answer::Yes : Answer::No;
    node.IsRegular.store(regular, std::memory_order_release);
  }
  return regular == Answer::Yes;
}

bool ElementTree::IsFlat(Node& node)
{
  using Answer = Node::Answer;
  Answer flat = node.IsFlat.load(std::memory_order_relaxed);
  if (flat == Answer::Unknown)
  {
    // Two threads may compute the same result.
    flat =
      IsFlatOver(problem_.space, problem_.coefficients, node.frame_.box) ? Answer::Yes : Answer::No;
    node.IsFlat.store(flat, std::memory_order_relaxed);
  }
  return flat == Answer::Yes;
}

/// The Jacobian's coefficients over a node, from those of its parent.
const BoxCoefficients& ElementTree::SlopesOf(Node& node)
{
  if (node.Slopes.values.empty())
  {
    if (node.Parent == nullptr || node.Parent->Form != node.Form)
    {
      node.Slopes = ConvertPiece(*node.Form, node.Piece, true);
    }
    else
    {
      node.Slopes = SlopesOf(*node.Parent);
      BoxCoefficients above = node.Slopes.Subdivide(
        Form.Degree(), node.Parent->Direction.load(std::memory_order_relaxed));
      if (node.IsUpper)
      {
        node.Slopes = std::move(above);
      }
    }
    Account(BytesOf(node.Slopes));
  }
  return node.Slopes;
}
} // namespace pixelexact
