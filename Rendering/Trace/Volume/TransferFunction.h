// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace pixelexact
{
/// Colours and opacities of a volume by the field's value u, both piecewise linear. Opacity is that
/// of a path of the unit distance through matter of this value, as in VTK and ParaView:
/// tau = -log(1 - alpha) / unit. Values outside the points have the colour and opacity of the
/// nearest point. Equal places of two points are a jump.
class TransferFunction
{
public:
  /// Opacities above this value are lowered to it, because tau is infinite at 1.
  static constexpr double kMaxOpacity = 1.0 - 1.0 / 1024.0;

  struct ColorPoint
  {
    double u;
    std::array<double, 3> rgb; ///< 0 to 1
    bool operator==(const ColorPoint&) const = default;
  };
  struct OpacityPoint
  {
    double u;
    double alpha; ///< 0 to 1
    bool operator==(const OpacityPoint&) const = default;
  };

  /// Between two neighbouring points of either list. tau and colour are smooth in u.
  struct Part
  {
    double from; ///< -infinity for the first part
    double to;   ///< infinity for the last part
    std::array<double, 2> alpha;
    std::array<std::array<double, 3>, 2> rgb;
  };

  /// Bounds over all values of a range, and its chords: the linear functions with the same values
  /// at its ends.
  struct Bounds
  {
    bool isSmooth = true;    ///< the range is in one part
    std::size_t part = 0;    ///< the first one
    double tau = 0.0;        ///< of tau
    double tauSlope = 0.0;   ///< of |d tau / du|; of a smooth range, else of the chord
    double tauBend = 0.0;    ///< of |d^2 tau / du^2|; of a smooth range
    double colorSlope = 0.0; ///< of |dc / du|, of any channel; else of the chord
    double lower = 0.0;      ///< the end of the range at which the chords begin
    double tauAt = 0.0;      ///< of the chord at `lower`
    double tauChord = 0.0;   ///< its slope
    double tauOff = 0.0;     ///< the largest distance of tau from its chord
    std::array<double, 3> colorAt{};
    std::array<double, 3> colorChord{};
    double colorOff = 0.0;

    [[nodiscard]] double ChordOfTau(double u) const { return tauAt + tauChord * (u - lower); }
    [[nodiscard]] std::array<double, 3> ChordOfColor(double u) const;
  };

  /// `unit`: distance in world units, positive. Points in ascending order of u. Throws Error
  /// (`name`: of its source, for messages) for fewer than one point of each, places that are not
  /// finite or not ascending, and colours or opacities outside 0 to 1.
  TransferFunction(std::vector<ColorPoint> colors, std::vector<OpacityPoint> opacities, double unit,
    const char* name = "transfer function");

  [[nodiscard]] double Unit() const { return unit_; }
  /// Whether some opacity was lowered to kMaxOpacity.
  [[nodiscard]] bool IsLimited() const { return isLimited_; }
  /// The largest slopes of opacity and colour by u: estimates of how exactly u must be known.
  [[nodiscard]] double Steepness() const { return steepness_; }
  /// The largest tau of any value.
  [[nodiscard]] double LargestTau() const { return largestTau_; }

  /// The part that holds u; at a place between two parts, the upper one.
  [[nodiscard]] std::size_t PartOf(double u) const;
  /// Values in the part, and limits at its ends.
  [[nodiscard]] double TauOf(std::size_t part, double u) const;
  [[nodiscard]] std::array<double, 3> ColorOf(std::size_t part, double u) const;
  /// `chords`: also of a smooth range.
  [[nodiscard]] Bounds BoundsOver(double lower, double upper, bool chords) const;

  [[nodiscard]] const std::vector<Part>& Parts() const { return parts_; }

  bool operator==(const TransferFunction& other) const
  {
    return colors_ == other.colors_ && opacities_ == other.opacities_ && unit_ == other.unit_;
  }

private:
  void MakeParts();
  void SetChords(double lower, double upper, std::size_t last, Bounds& bounds) const;
  /// The largest difference of a channel.
  [[nodiscard]] static double ChangeOf(
    const std::array<double, 3>& a, const std::array<double, 3>& b);

  std::vector<ColorPoint> colors_;
  std::vector<OpacityPoint> opacities_;
  double unit_;
  bool isLimited_ = false;
  double steepness_ = 0.0;
  double largestTau_ = 0.0;
  std::vector<Part> parts_;
};
} // namespace pixelexact
