// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Meshes/MeshFile.h"
#include "Formats/MFEM/Text/TextScanner.h"

#include <array>
#include <span>
#include <vector>

namespace pixelexact::mfem
{
/// Refinement types have one bit for each of x, y, z.
inline constexpr int kAllDirections = 7;
inline constexpr int kPlaneDirections = 3;

/// The number of children that a refinement type makes.
int ChildrenOf(int refinement);

/// An element of any level; leaves have vertices ("nodes" in the file), others have children.
struct TreeElement
{
  Cell cell;
  int refinement = 0;
  int rank = 0;
  std::array<int, 8> children{};
  bool used = false;
  bool isChild = false;
};

/// Marks the children. Fails by `scanner` where one is missing or has two parents.
void LinkChildren(const TextScanner& scanner, std::span<TreeElement> elements);

/// Elements without children, in MFEM's order.
struct Leaves
{
  std::vector<int> all; ///< of this process and its neighbours
  std::vector<int> own;
};

/// The leaves along space-filling curves where cubes and squares are refined in all directions.
/// `rootStates`: the curves' states at the roots; missing ones are 0. Fails through `scanner` where
/// the trees are too deep.
Leaves LeavesInOrder(const TextScanner& scanner, std::span<const TreeElement> elements,
  std::span<const int> rootStates, int rank);

/// The order in which MFEM's non-conforming meshes visit the eight children of a refined cube.
struct HilbertState
{
  std::array<int, 8> child; ///< the children, in the order of the visit
  std::array<int, 8> state; ///< the state in which each of them is entered
};

/// One of the 24 states of the curve, numbered as in the files' root_state.
const HilbertState& HilbertCurve(int state);

/// The same of the four children of a refined square; one of 8 states.
struct PlaneHilbertState
{
  std::array<int, 4> child;
  std::array<int, 4> state;
};
PlaneHilbertState PlaneHilbertCurve(int state);
} // namespace pixelexact::mfem
