// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/BezierPatch.h"
#include "Trace/Surfaces/Chord.h"

#include <vector>

namespace pixelexact
{
/// Derivatives of a Bezier patch at any (u, v), and bounds of its second and third derivatives over
/// the patch and a margin around it.
class BezierBend
{
public:
  explicit BezierBend(const BezierPatch& patch);

  /// A point of the patch and its parameters.
  struct Place
  {
    Vec3 position;
    double u;
    double v;
  };

  /// Largest distance of the patch from a chord between two of its points, along the rays between.
  /// All these rays meet the patch within it, on one continuous path. Infinite if this is not
  /// proven.
  [[nodiscard]] double Sagitta(const Chord& chord, const Place& from, const Place& to) const;

  /// The patch and its derivatives.
  struct View
  {
    Vec3 y;
    Vec3 yu;
    Vec3 yv;
    Vec3 yuu;
    Vec3 yuv;
    Vec3 yvv;
  };
  [[nodiscard]] View At(double u, double v) const;

private:
  [[nodiscard]] bool HoldsPaths(const Place& from, const Place& to, double offU, double offV) const;

  int Degree[2];
  Vec3 Centre;
  std::vector<Vec3> Points; ///< minus the centre
  double Rounding;          ///< of At's y; each derivative multiplies it by twice the degree
  double Second[3];         ///< uu, uv, vv
  double Third[4];          ///< uuu, uuv, uvv, vvv
};
} // namespace pixelexact
