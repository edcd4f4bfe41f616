// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Meshes/RefinementTree.h"

#include <algorithm>
#include <bit>
#include <string>
#include <utility>

namespace pixelexact::mfem
{
namespace
{
using Path = std::array<int, 8>;

/// A cube's vertices, and children, in MFEM's order, as bits of x, y and z.
constexpr Path kBits{ 0, 1, 3, 2, 4, 5, 7, 6 };

/// The curve through a cube and through each of its children on the way.
constexpr Path kCurve{ 0, 1, 2, 3, 7, 6, 5, 4 };
constexpr std::array<Path, 8> kCurveOfChild{ Path{ 0, 3, 7, 4, 5, 6, 2, 1 },
  { 0, 4, 5, 1, 2, 6, 7, 3 }, { 0, 4, 5, 1, 2, 6, 7, 3 }, { 2, 3, 0, 1, 5, 4, 7, 6 },
  { 2, 3, 0, 1, 5, 4, 7, 6 }, { 7, 3, 2, 6, 5, 1, 0, 4 }, { 7, 3, 2, 6, 5, 1, 0, 4 },
  { 5, 6, 2, 1, 0, 3, 7, 4 } };

/// A symmetry of the cube: the axes in turn, then some of them mirrored.
int Move(int vertex, int turns, int mirrored)
{
  int bits = kBits[vertex];
  for (int k = 0; k < turns; ++k)
  {
    bits = (bits << 1U | bits >> 2U) & 7;
  }
  return static_cast<int>(std::ranges::find(kBits, bits ^ mirrored) - kBits.begin());
}

Path Move(const Path& path, int turns, int mirrored)
{
  Path moved{};
  std::ranges::transform(
    path, moved.begin(), [&](int vertex) { return Move(vertex, turns, mirrored); });
  return moved;
}

/// The states are the images of the curve under the 24 symmetries, in lexicographic order.
std::vector<HilbertState> MakeStates()
{
  std::vector<Path> paths;
  for (int turns = 0; turns < 3; ++turns)
  {
    for (int mirrored = 0; mirrored < 8; ++mirrored)
    {
      paths.push_back(Move(kCurve, turns, mirrored));
    }
  }
  std::ranges::sort(paths);
  const auto number = [&](const Path& path)
  { return static_cast<int>(std::ranges::lower_bound(paths, path) - paths.begin()); };
  std::vector<HilbertState> states(paths.size());
  for (int turns = 0; turns < 3; ++turns)
  {
    for (int mirrored = 0; mirrored < 8; ++mirrored)
    {
      HilbertState& state = states[number(Move(kCurve, turns, mirrored))];
      state.child = Move(kCurve, turns, mirrored);
      std::ranges::transform(kCurveOfChild, state.state.begin(),
        [&](const Path& path) { return number(Move(path, turns, mirrored)); });
    }
  }
  return states;
}

constexpr int kMaxTreeDepth = 64;

class LeafWalk
{
public:
  LeafWalk(const TextScanner& scanner, std::span<const TreeElement> elements, int rank)
    : Scanner(scanner)
    , Elements(elements)
    , Rank(rank)
  {
  }

  void Visit(int element, int state, int depth);

  Leaves Found;

private:
  const TextScanner& Scanner;
  std::span<const TreeElement> Elements;
  int Rank;
};

void LeafWalk::Visit(int element, int state, int depth)
{
  const TreeElement& e = Elements[element];
  if (depth > kMaxTreeDepth)
  {
    Scanner.Fail("the refinement tree is deeper than " + std::to_string(kMaxTreeDepth) +
      " levels; it is damaged.");
  }
  if (e.refinement == 0)
  {
    // Around a piece are those of its neighbours; what is beyond has no rank.
    if (e.rank >= 0)
    {
      Found.all.push_back(element);
    }
    if (e.rank == Rank)
    {
      Found.own.push_back(element);
    }
    return;
  }
  if (e.cell.geometry == Geometry::Cube && e.refinement == kAllDirections)
  {
    const HilbertState& curve = HilbertCurve(state);
    for (int i = 0; i < 8; ++i)
    {
      Visit(e.children[curve.child[i]], curve.state[i], depth + 1);
    }
    return;
  }
  if (e.cell.geometry == Geometry::Square && e.refinement == kPlaneDirections)
  {
    const PlaneHilbertState curve = PlaneHilbertCurve(state);
    for (int i = 0; i < 4; ++i)
    {
      Visit(e.children[curve.child[i]], curve.state[i], depth + 1);
    }
    return;
  }
  for (const int child : std::span(e.children).first(ChildrenOf(e.refinement)))
  {
    Visit(child, state, depth + 1);
  }
}
} // namespace

const HilbertState& HilbertCurve(int state)
{
  static const std::vector<HilbertState> states = MakeStates();
  return states.at(state);
}

/// State 2 c goes around from corner c, state 2 c + 1 the other way. The first child is run through
/// the other way, the last one from the opposite corner.
PlaneHilbertState PlaneHilbertCurve(int state)
{
  const int first = state / 2;
  const int step = state % 2 == 0 ? 1 : 3;
  PlaneHilbertState curve{};
  for (int i = 0; i < 4; ++i)
  {
    curve.child[i] = (first + i * step) % 4;
  }
  curve.state = { state ^ 1, state, state, ((state + 4) % 8) ^ 1 };
  return curve;
}

int ChildrenOf(int refinement)
{
  return refinement == 0 ? 0 : 1 << std::popcount(static_cast<unsigned>(refinement));
}

void LinkChildren(const TextScanner& scanner, std::span<TreeElement> elements)
{
  for (const TreeElement& element : elements)
  {
    for (const int child : std::span(element.children).first(ChildrenOf(element.refinement)))
    {
      if (elements[child].isChild || !elements[child].used)
      {
        scanner.Fail("element " + std::to_string(child) +
          (elements[child].used ? " has two parents" : " is a child but not there") +
          "; the refinement tree is damaged.");
      }
      elements[child].isChild = true;
    }
  }
}

Leaves LeavesInOrder(const TextScanner& scanner, std::span<const TreeElement> elements,
  std::span<const int> rootStates, int rank)
{
  LeafWalk walk(scanner, elements, rank);
  std::size_t root = 0;
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    if (elements[i].used && !elements[i].isChild)
    {
      walk.Visit(static_cast<int>(i), root < rootStates.size() ? rootStates[root] : 0, 0);
      ++root;
    }
  }
  return std::move(walk.Found);
}
} // namespace pixelexact::mfem
