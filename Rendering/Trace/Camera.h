// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

#include <array>
#include <variant>

namespace pixelexact
{
/// x(t) = origin + t direction, direction of unit length (paper, equation 1).
struct Ray
{
  Vec3 origin;
  Vec3 direction;
};

/// A camera; all members have the meaning of vtkCamera's.
struct CameraView
{
  Vec3 position{ 0.0, 0.0, 1.0 };
  Vec3 focalPoint{ 0.0 };
  Vec3 viewUp{ 0.0, 1.0, 0.0 };
  bool parallel = false;
  double viewAngle = 30.0; ///< degrees; vertical, or horizontal if so asked
  bool horizontalViewAngle = false;
  double parallelScale = 1.0; ///< half the height of the view in world units
  std::array<double, 2> windowCenter{ 0.0, 0.0 };

  bool operator==(const CameraView&) const = default; // false where a number is NaN
};

/// Origin and direction of rays, linear in the normalised device coordinates (u, v) in [-1,1]^2.
/// The direction is not normalised.
struct CameraRays
{
  struct Linear
  {
    Vec3 constant{ 0.0 };
    Vec3 u{ 0.0 };
    Vec3 v{ 0.0 };
  };
  Linear origin;
  Linear direction;
};

/// The rays of an image of width x height pixels. Pixel (i, j) covers [i, i+1] x [j, j+1], its
/// centre is (i + 0.5, j + 0.5), and (0, 0) is the lower left corner of the image.
class Camera
{
public:
  /// Depends on the view alone, not on a clipping range, so that equal views have equal rays, bit
  /// for bit. Throws Error if position and focal point coincide, view-up is parallel to the view
  /// direction, an angle or scale is out of range, or a number is not finite.
  Camera(const CameraView& view, int width, int height);

  /// From the inverse of a composite projection matrix (row-major, normalised device coordinates
  /// with z in [-1,1] to world), for cameras that no CameraView describes: sheared, oblique, or
  /// with explicit matrices. Throws Error if the matrix describes no camera.
  Camera(const std::array<double, 16>& inverseProjection, int width, int height);

  /// The ray through image position (px, py), in pixels.
  [[nodiscard]] Ray At(double px, double py) const;

  [[nodiscard]] int Width() const { return ImageWidth; }
  [[nodiscard]] int Height() const { return ImageHeight; }
  /// The direction of view at the image's centre, unit length.
  [[nodiscard]] Vec3 ViewDirection() const;

  /// Normalised device coordinates of an image position.
  [[nodiscard]] double U(double px) const { return 2.0 * px / ImageWidth - 1.0; }
  [[nodiscard]] double V(double py) const { return 2.0 * py / ImageHeight - 1.0; }
  [[nodiscard]] const CameraRays& Rays() const { return rays_; }

private:
  CameraRays rays_;
  int ImageWidth;
  int ImageHeight;
};

/// Determines the rays of an image.
struct CameraSetup
{
  /// A view, or a row-major matrix from normalised device coordinates (z in [-1,1]) to the space
  /// that rays are traced in.
  std::variant<CameraView, std::array<double, 16>> rays;
  int width = 0;  ///< pixels
  int height = 0; ///< pixels

  /// Throws Error as Camera's constructors do.
  [[nodiscard]] Camera Make() const
  {
    return std::visit([this](const auto& form) { return Camera(form, width, height); }, rays);
  }
  bool operator==(const CameraSetup&) const = default; // equal setups give equal rays, bit for bit
};
} // namespace pixelexact
