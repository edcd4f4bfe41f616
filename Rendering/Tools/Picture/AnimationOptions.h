// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Options.h"
#include "Scene/PlaneOption.h"

#include "Core/Math/Vec.h"
#include "Trace/Camera.h"

#include <optional>
#include <string>

namespace pixelexact
{
struct InputRequest;

/// Pictures that follow each other: a plane that is swept or a mesh that is deformed, a camera that
/// turns, all time steps, or several of these at once, frame by frame.
class AnimationOptions
{
public:
  static constexpr int kMaxFrames = 1000000;

  void AddTo(CLI::App& command);
  /// Throws UsageError for numbers of frames that differ, and options that have no effect.
  void Check(const InputRequest& input) const;

  [[nodiscard]] bool IsAsked(const InputRequest& input) const;
  /// The number of frames; none: the number of time steps.
  [[nodiscard]] std::optional<int> Frames() const;

  /// Whether there is a plane of each frame's own; it is the first surface.
  [[nodiscard]] bool Sweeps() const { return Sweep.has_value(); }
  [[nodiscard]] PlaneChoice PlaneAt(int frame) const;
  /// Whether each frame has a scale of --warp of its own.
  [[nodiscard]] bool Deforms() const { return Deformation.has_value(); }
  /// Sets the frame's scale or phase.
  void Apply(int frame, InputRequest& input) const;
  /// The one of the two end scales that deforms more.
  [[nodiscard]] double LargestScale() const;
  /// Whether the phase of complex fields changes.
  [[nodiscard]] bool Phases() const { return Phase.has_value(); }
  [[nodiscard]] bool Turns() const { return Turn.has_value(); }
  /// A view that is turned about its view-up through `pivot`, against the clock seen from above.
  [[nodiscard]] CameraView ViewAt(int frame, const CameraView& first, const Vec3& pivot) const;

  /// Whether frames that are there already, and are the same, stay.
  [[nodiscard]] bool Resumes() const { return Resume; }
  [[nodiscard]] double FramesPerSecond() const { return Rate; }

private:
  struct Swept
  {
    char axis;
    double from;
    double to;
    bool inPercent;
    int frames;
  };
  struct Numbers
  {
    double from;
    double to;
    int frames;

    [[nodiscard]] double At(int frame) const;
  };
  struct Turned
  {
    double degrees;
    int frames;
  };
  void ReadSweep(const std::string& text);

  const CLI::App* Command = nullptr;
  std::optional<Swept> Sweep;
  std::optional<Numbers> Deformation;
  std::optional<Numbers> Phase;
  std::optional<Turned> Turn;
  bool Resume = false;
  double Rate = 0.0;
};
} // namespace pixelexact
