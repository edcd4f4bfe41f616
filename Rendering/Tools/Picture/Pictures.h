// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Shot.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace pixelexact
{
class Stopwatch;
struct RenderOptions;

/// The shots of an animation, one after the other: what is there of one stays for the next.
class Pictures
{
public:
  /// Throws Error as Prepare, and where numbers of pictures and time steps differ.
  Pictures(const RenderOptions& options, Stopwatch& watch);

  [[nodiscard]] int Frames() const { return Count; }
  [[nodiscard]] int StepOf(int frame) const;
  [[nodiscard]] int Steps() const { return static_cast<int>(Now->input.times.size()); }
  /// How often the input was read, and how many locators there were.
  [[nodiscard]] std::int64_t TimesRead() const { return Reads; }
  [[nodiscard]] std::int64_t Located() const { return Locators; }
  [[nodiscard]] const Shot& Current() const { return *Now; }

  /// Where everything is at a picture; until the next call.
  const Shot& At(int frame);
  /// Finds what --range all spans.
  void FindValues();

private:
  [[nodiscard]] Vec3 Pivoted() const;

  const RenderOptions& Options;
  Stopwatch& Watch;
  ShotOptions Asked;
  std::optional<Shot> Now;
  CameraView First;
  Vec3 Pivot{ 0.0 };
  int Count = 0;
  std::vector<std::optional<std::array<double, 2>>> Values;
  std::int64_t Reads = 0;
  const Locator* Latest = nullptr;
  std::int64_t Locators = 0;
};
} // namespace pixelexact
