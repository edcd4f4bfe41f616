// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Text/TextScanner.h"

#include <array>
#include <unordered_map>
#include <vector>

namespace pixelexact::mfem
{
inline constexpr int kMostNodes = 1 << 30;

/// The vertices ("nodes") of a refined mesh: those of the coarsest level have coordinates, others
/// lie on the line between two parents.
class VertexHierarchy
{
public:
  /// `scaled`: each has its place between its parents, otherwise it is halfway.
  void ReadParents(TextScanner& scanner, bool scaled);
  void ReadCoordinates(TextScanner& scanner, int dimension);

  [[nodiscard]] bool HasParents(int node) const { return ParentsOf.contains(node); }
  /// Fails, through the scanner, for a node without coordinates and parents.
  std::array<double, 3> Position(TextScanner& scanner, int node, int generation = 0);

private:
  struct Parents
  {
    int first = 0;
    int second = 0;
    double share = 0.5; ///< of the second one
  };
  std::unordered_map<int, Parents> ParentsOf;
  std::vector<double> Coordinates; ///< by node
  std::unordered_map<int, std::array<double, 3>> Known;
};
} // namespace pixelexact::mfem
