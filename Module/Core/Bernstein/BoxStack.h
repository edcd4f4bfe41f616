// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/RootFinder.h"
#include "Core/Bernstein/SystemClipping.h"

namespace pixelexact
{
/// The open boxes of a search, each with the system's coefficients over it and the errors that
/// restriction has added to them.
class BoxStack
{
public:
  /// One box: the whole cube. `smallest`: boxes are not made narrower.
  BoxStack(const PolynomialSystem& system, double smallest);

  [[nodiscard]] bool IsEmpty() const { return Boxes.empty(); }
  void Pop() { Boxes.pop_back(); }

  /// The box on top: its coefficients, until the stack is changed; its widths; itself.
  [[nodiscard]] LocalSystem Local() const;
  [[nodiscard]] const Parameters& Width() const { return Boxes.back().width; }
  [[nodiscard]] ParameterBox Part() const { return PartOf(Boxes.back()); }
  /// All boxes.
  [[nodiscard]] std::vector<ParameterBox> Parts() const;

  /// Restricts the box on top to the sections, in directions where that takes a quarter of its
  /// width or more. False where in none.
  bool Shrink(const Sections& sections);
  /// Children the box on top in its widest direction; false where it is too narrow.
  bool Split();
  /// A root found in the box's own coordinates, in those of the cube. False where rounding leaves
  /// nothing of the region in which it is alone.
  bool PlaceRoot(const ParameterIntervals& image, double reach, IsolatedRoot& root) const;

private:
  struct Box
  {
    Parameters lower{};
    Parameters width{};
    std::array<double, 3> error{}; ///< of each polynomial's coefficients
  };
  [[nodiscard]] static ParameterBox PartOf(const Box& box);
  [[nodiscard]] std::span<double> Slot(std::size_t box, std::size_t k);

  std::size_t N; ///< variables
  std::size_t M; ///< equations
  Degrees Degree;
  std::size_t Size; ///< coefficients of a polynomial
  double Smallest;
  std::vector<Box> Boxes;
  std::vector<double> Coefficients; ///< M Size for each box
};
} // namespace pixelexact
