// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Integral/GraphIntegral.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace pixelexact
{
/// The integrals over what of a cut-surface is in one element: boxes, each with what is known of
/// it, of which the worst are halved.
class ElementIntegral
{
public:
  ElementIntegral(const IntegralQuestion& question, int element);
  ~ElementIntegral();
  ElementIntegral(ElementIntegral&&) noexcept;

  /// The integrals by quantity, and about those of the magnitudes.
  [[nodiscard]] Sums Total() const;
  [[nodiscard]] std::vector<double> Magnitudes() const;
  /// At most so much area is in boxes in which nothing is known of the surface.
  [[nodiscard]] double Unresolved() const;
  [[nodiscard]] std::int64_t Boxes() const { return Looked; }
  /// Boxes that are not subdivided any further: rounding is what is left of their widths.
  [[nodiscard]] std::int64_t Rounded() const;
  [[nodiscard]] bool IsEmpty() const { return Parts.empty(); }

  /// Children boxes until all quantities' widths are within what is allowed, `boxes` more have been
  /// looked at, or `stop` says so; it is asked after each box. False where it could not be met.
  bool Refine(
    const std::vector<double>& allowed, std::int64_t boxes, const std::function<bool()>& stop);

private:
  struct Part
  {
    PieceBox box;
    Sums sums;
    std::vector<double> magnitudes; ///< about the integrals of the magnitudes; 0 where unknown
    int direction = -1;             ///< to be halved along; -1: too small
    bool resolved = false;
    int stalled = 0; ///< subdivisions in a row that gained nothing
  };
  void Look(ElementFunctions& functions, const PieceBox& box);
  /// `direction`: as Part's.
  void AddUnresolved(ElementFunctions& functions, const PieceBox& box, int direction);
  /// Ends the subdivision of the parts from `first` on, the children of a part of this width, where
  /// it gains nothing.
  void NoteGain(std::size_t first, int stalled, double before, double after);

  IntegralQuestion Question;
  int Element;
  double Tolerance = 0.0; ///< of the cut's polynomial
  std::vector<Part> Parts;
  std::int64_t Looked = 0;
};

/// Why there is no integral over an element.
enum class ElementProblem : std::uint8_t
{
  None,
  NotFinite, ///< a coefficient is NaN or infinite
  TooHigh,   ///< the order
  Flat       ///< all of the element is on the surface
};

/// Whether the surface may be in an element, and which of its faces lie in it, within the mesh's
/// uncertainty and rounding: bit k, face k of FacesOf. An element on one side of the surface, up to
/// that, is met in its faces alone.
struct ElementMeeting
{
  ElementProblem problem = ElementProblem::None;
  bool inside = false;
  bool above = false; ///< on the surface's positive side
  unsigned faces = 0;
};
ElementMeeting MeetingOf(ElementFunctions& functions);

/// Of the cut's polynomial, scaled as it is: what the map's uncertainty and rounding make of zero.
double CutTolerance(ElementFunctions& functions, const PieceBox& box);
} // namespace pixelexact
