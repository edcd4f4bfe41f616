// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Integral/GraphIntegral.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace pixelexact
{
/// Boxes are divided at this fraction, not in the middle, where the surfaces of generated meshes
/// lie.
inline constexpr double kBoxDivision = 0.486328125;
/// Boxes are not subdivided below this width, in the piece's units.
inline constexpr double kSmallestIntegralBox = 0x1p-40;
/// The direction along which a box's image is longest; -1: the box is too small.
int LongestSide(ElementFunctions& functions, const PieceBox& box);
/// The direction along which the cut's first derivatives vary most, the longest of several:
/// subdivided there, the cut becomes a graph soonest. -1: they vary by no more than their errors,
/// or the box is too small.
int MostBentSide(ElementFunctions& functions, const PieceBox& box);

/// The integrals over the part of a cut-surface in one element, as sums over boxes with enclosures.
/// Refine subdivides the boxes with the largest errors.
class ElementIntegral
{
public:
  ElementIntegral(const IntegralQuestion& question, int element);
  ~ElementIntegral();
  ElementIntegral(ElementIntegral&&) noexcept;

  /// The integrals by quantity, and estimates of the integrals of their magnitudes.
  [[nodiscard]] Sums Total() const;
  [[nodiscard]] std::vector<double> Magnitudes() const;
  /// Bounds the area in boxes in which the surface is unknown.
  [[nodiscard]] double Unresolved() const;
  [[nodiscard]] std::int64_t Boxes() const { return Looked; }
  /// The number of boxes that are not subdivided any further, because only rounding remains of
  /// their widths.
  [[nodiscard]] std::int64_t Rounded() const;
  [[nodiscard]] bool IsEmpty() const { return Parts.empty(); }

  /// Subdivides boxes until all quantities' widths are at most `allowed`, `boxes` more have been
  /// visited, or `stop` returns true; it is called after each box. Returns false where the widths
  /// were not reached.
  bool Refine(
    const std::vector<double>& allowed, std::int64_t boxes, const std::function<bool()>& stop);

private:
  struct Part
  {
    PieceBox box;
    Sums sums;
    std::vector<double> magnitudes; ///< about the integrals of the magnitudes; 0 where unknown
    int direction = -1;             ///< of the subdivision; -1: too small
    bool resolved = false;
    bool anyRange = false; ///< of the integrands: see IsRange
    int stalled = 0;       ///< subdivisions in a row that gained nothing
  };
  void Look(ElementFunctions& functions, const PieceBox& box);
  /// `direction`: as in Part.
  void AddUnresolved(ElementFunctions& functions, const PieceBox& box, int direction);
  /// Stops the subdivision of the parts from `first` on, the children of a part of this width,
  /// where it gains nothing.
  void NoteGain(std::size_t first, int stalled, double before, double after);

  IntegralQuestion Question;
  int Element;
  double Tolerance = 0.0; ///< of the cut's polynomial
  std::vector<Part> Parts;
  std::int64_t Looked = 0;
};

/// The reason why there is no integral over an element.
enum class ElementProblem : std::uint8_t
{
  None,
  NotFinite, ///< a coefficient is NaN or infinite
  TooHigh,   ///< the order
  Flat       ///< all of the element is on the surface
};

/// Whether the surface may be in an element, and which of its faces lie in it, within the mesh's
/// uncertainty and rounding: bit k, face k of FacesOf. An element that is on one side of the
/// surface, within the same bounds, meets it in faces alone.
struct ElementMeeting
{
  ElementProblem problem = ElementProblem::None;
  bool inside = false;
  bool above = false;   ///< on the surface's positive side
  bool isClear = false; ///< the surface is proven to have no point in the element
  unsigned faces = 0;   ///< that lie in the surface, up to the element's uncertainty

  [[nodiscard]] bool Holds(int face) const
  {
    return (faces >> static_cast<unsigned>(face) & 1U) != 0;
  }
};
ElementMeeting MeetingOf(ElementFunctions& functions);

/// The largest magnitude of the cut's polynomial, as scaled, that counts as zero: the effect of the
/// map's uncertainty and of rounding.
double CutTolerance(ElementFunctions& functions, const PieceBox& box);
} // namespace pixelexact
