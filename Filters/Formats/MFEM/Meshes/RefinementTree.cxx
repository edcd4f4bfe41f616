// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Meshes/RefinementTree.h"

#include "Formats/MFEM/Meshes/HilbertCurve.h"

#include <bit>
#include <string>
#include <utility>

namespace pixelexact::mfem
{
namespace
{
constexpr int kDeepestTree = 64;

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
  if (depth > kDeepestTree)
  {
    Scanner.Fail("the refinement tree is deeper than " + std::to_string(kDeepestTree) +
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
