// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/ElementTree.h"

#include "Core/Bernstein/PieceForm.h"
#include "Core/Location/Regularity.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace pixelexact
{
namespace
{
/// A box halved this often in a direction is smaller than what rounding leaves to decide.
constexpr int kMaxHalvings = 50;
constexpr double kPoint = 2e-12;

constexpr Part kParts[3] = { Part::ByXi1, Part::ByXi2, Part::ByXi3 };

/// Measured, in nanoseconds per coefficient: a sweep of de Casteljau costs half a degree, a frame
/// or a product of slopes a dozen.
constexpr std::int64_t kSweep = 12;

std::int64_t BytesOf(const BoxCoefficients& coefficients)
{
  return static_cast<std::int64_t>(coefficients.values.size() * sizeof(double));
}

/// Pieces of which there are no more take 0.1 s at most.
constexpr int kMostLevel = 2;

/// Of very high orders one piece where the rounding of its coefficients is no more than what is not
/// known of the map anyway, as of smooth maps.
const PieceForm& FormFor(const InverseProblem& problem)
{
  if (PieceForm::LevelOf(problem.space.MaxOrder()) <= kMostLevel)
  {
    return PieceForm::Of(problem.space);
  }
  const PieceForm& whole = PieceForm::Of(problem.space, 0);
  bool small = true;
  for (std::size_t c = 0; small && c < 3; ++c)
  {
    const double* component =
      problem.coefficients + c * static_cast<std::size_t>(problem.space.Modes());
    small = whole.ErrorBound(Part::Value, { 0, 0, 0 }, component) <= problem.uncertainty[c];
  }
  return small ? whole : PieceForm::Of(problem.space);
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
  , TheProblem(MakeInverseProblem(mesh, element, Bounds))
  , Form(FormFor(TheProblem))
  , HasSlopes(true)
  , Total(total)
{
  for (std::size_t c = 0; c < 3; ++c)
  {
    HasSlopes = HasSlopes &&
      PieceForm::IsClosed(
        TheProblem.space, Modes + c * static_cast<std::size_t>(TheProblem.space.Modes()));
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

std::int64_t ElementTree::BeginCost() const
{
  return Form.Level() <= kMostLevel ? 0
                                    : 2 * SplitCost() << 3U * static_cast<unsigned>(Form.Level());
}

std::int64_t ElementTree::SplitCost() const
{
  return 3000 + static_cast<std::int64_t>(3 * Form.Size()) * (HighestDegree() / 2 + kSweep);
}

std::int64_t ElementTree::RegularCost(const Node& node) const
{
  return IsPlainlyRegular(node)
    ? 0
    : 1000 + static_cast<std::int64_t>(9 * Form.Size()) * (HighestDegree() / 2 + kSweep) / 2;
}

int ElementTree::HighestDegree() const
{
  return *std::ranges::max_element(Form.Degree());
}

bool ElementTree::IsPlainlyRegular(const Node& node)
{
  // As IsRegular, with the same room for a root that lies beyond the box's reach by 1e-12.
  constexpr double kRegular = 1.0 - 1e-4;
  return node.TheFrame.slope < kRegular;
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
        Roots.push_back(MakeNode(box, ConvertPiece(piece, false)));
        Roots.back()->Piece = piece;
      }
    }
  }
  HasRoots.store(true, std::memory_order_release);
  return Roots;
}

BoxCoefficients ElementTree::ConvertPiece(const std::array<int, 3>& piece, bool slopes) const
{
  const auto modes = static_cast<std::size_t>(TheProblem.space.Modes());
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

std::unique_ptr<ElementTree::Node> ElementTree::MakeNode(const EtaBox& box, BoxCoefficients phi)
{
  auto node = std::make_unique<Node>();
  node->TheFrame.box = box;
  node->Point = IsPointBox(TheProblem.space.shape, box);
  phi.Recentre();
  MakeFrame(TheProblem.space, Modes, Bounds, phi, node->TheFrame);
  node->Phi = std::move(phi);
  Account(BytesOf(node->Phi) + static_cast<std::int64_t>(sizeof(Node)));
  return node;
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
  const EtaBox& box = node.TheFrame.box;
  const Vec3 width = box.upper - box.lower;
  int direction = node.TheFrame.widest;
  if (node.Halvings[static_cast<std::size_t>(direction)] >= kMaxHalvings)
  {
    direction = width.x >= width.y && width.x >= width.z ? 0 : (width.y >= width.z ? 1 : 2);
  }
  if (node.Halvings[static_cast<std::size_t>(direction)] >= kMaxHalvings)
  {
    return false;
  }
  EtaBox lower = box;
  EtaBox upper = box;
  const double middle = 0.5 * (lower.lower[direction] + lower.upper[direction]);
  lower.upper[direction] = middle;
  upper.lower[direction] = middle;
  Account(-BytesOf(node.Phi));
  BoxCoefficients phi = std::move(node.Phi);
  BoxCoefficients above = phi.Halve(Form.Degree(), direction);
  node.Children = { MakeNode(lower, std::move(phi)), MakeNode(upper, std::move(above)) };
  for (const auto& child : node.Children)
  {
    child->Parent = &node;
    child->Piece = node.Piece;
    child->Halvings = node.Halvings;
    ++child->Halvings[static_cast<std::size_t>(direction)];
  }
  node.Children[1]->IsUpper = true;
  node.Direction.store(direction, std::memory_order_release);
  return true;
}

bool ElementTree::IsRegular(Node& node)
{
  using Regular = Node::Regular;
  if (IsPlainlyRegular(node))
  {
    return true;
  }
  if (!HasSlopes)
  {
    return false;
  }
  Regular regular = node.IsRegular.load(std::memory_order_acquire);
  if (regular == Regular::Unknown)
  {
    const std::scoped_lock lock(Growing);
    regular = pixelexact::IsRegular(Form.Degree(), SlopesOf(node)) ? Regular::Yes : Regular::No;
    node.IsRegular.store(regular, std::memory_order_release);
  }
  return regular == Regular::Yes;
}

/// The Jacobian's coefficients over a node, from those of its parent.
const BoxCoefficients& ElementTree::SlopesOf(Node& node)
{
  if (node.Slopes.values.empty())
  {
    if (node.Parent == nullptr)
    {
      node.Slopes = ConvertPiece(node.Piece, true);
    }
    else
    {
      node.Slopes = SlopesOf(*node.Parent);
      BoxCoefficients above =
        node.Slopes.Halve(Form.Degree(), node.Parent->Direction.load(std::memory_order_relaxed));
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
