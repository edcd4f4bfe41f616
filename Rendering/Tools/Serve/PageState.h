// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Camera.h"

#include <nlohmann/json.hpp>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
/// Stores what a page shows: a command line of render, with a camera that is fitted and then moved.
/// Messages change it; a change that cannot be drawn is withdrawn. For one thread.
///
/// A message is a JSON object. These members change the state:
///   set: {"--option": "value", true or null}   options of render, those of PageWords.h
///   turn: [right, up]     radians; move: [right, up]  parts of the image's height
///   zoom: factor          view: "+x", ..., "iso", "fit"
///   size: [width, height] pixels
class PageState
{
public:
  /// Sides and area of a picture in pixels.
  static constexpr int kMinSide = 16;
  static constexpr int kMaxSide = 4096;
  static constexpr int kMaxPixels = 1 << 22;

  /// Called after a change; `atOnce`: no further changes are expected soon.
  using Changed = std::function<void(bool atOnce)>;

  /// `words`: those of the picture (WordsOfPicture).
  PageState(std::vector<std::string> words, Changed changed);

  /// Changes the state by a message. Throws UsageError for an invalid member and for an option that
  /// pages cannot change, and Error for a camera that is none. Members before it may be applied.
  void Apply(const nlohmann::json& message);

  /// The words of the current command line. Where IsFitted() is false they have the camera.
  [[nodiscard]] const std::vector<std::string>& Words() const { return words_; }
  /// The words of render for what is shown. `output`: its file.
  [[nodiscard]] std::vector<std::string> Command(const std::string& output) const;

  /// Whether the camera is known. Until then it cannot be moved.
  [[nodiscard]] bool IsFitted() const { return !Fits; }
  /// Replaces the words of cameras by the view that the program found for them.
  void Fit(const CameraView& view);

  /// Keeps the ends of the colour map while the view moves.
  void KeepRange(const std::optional<std::array<double, 2>>& range) { Range = range; }
  /// The state was drawn: it is the one that Withdraw returns to.
  void Confirm() { Good = words_; }
  /// Returns to the options of the last exact picture, with the size and, once there was a
  /// picture, the camera as they are. Returns whether that changed the words.
  bool Withdraw();

private:
  void Move(const nlohmann::json& message);
  void SetOptions(const nlohmann::json& options);
  void SetView(const std::string& name);
  void SetSize(const nlohmann::json& size);

  Changed OnChange;
  std::vector<std::string> words_;
  std::vector<std::string> Given; ///< the words at the beginning
  std::vector<std::string> Good;  ///< those of the last exact picture
  CameraView Eye;
  bool HasEye = false; ///< a picture was drawn with Eye
  bool Fits = true;    ///< the camera is that of the words, which may be fitted to the cut
  std::optional<std::array<double, 2>> Range;
};

/// Two finite numbers of at most `limit` in absolute value; none: the value is no such array.
[[nodiscard]] std::optional<std::array<double, 2>> TwoNumbers(
  const nlohmann::json& value, double limit);

/// Throws UsageError for a message's member with an invalid value.
[[noreturn]] void RefuseMember(const std::string& name);
} // namespace pixelexact
