// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/BezierPatch.h"
#include "Trace/Surfaces/Chord.h"

#include <vector>

namespace pixelexact
{
/// How a Bezier patch bends: its derivatives at any (u, v), and bounds of those of second and third
/// order over the whole patch and a little beyond it.
class BezierBend
{
public:
  explicit BezierBend(const BezierPatch& patch);

  /// A point of the patch and its place there.
  struct Place
  {
    Vec3 position;
    double u;
    double v;
  };

  /// How far the patch is off a chord between two of its points along the rays between, which all
  /// meet it there in one continuous path; infinite where that is not proven.
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
  std::vector<Vec3> Points; ///< less the centre
  double Rounding;          ///< of At's y; of each derivative, twice the degree times it
  double Second[3];         ///< uu, uv, vv
  double Third[4];          ///< uuu, uuv, uvv, vvv
};
} // namespace pixelexact
