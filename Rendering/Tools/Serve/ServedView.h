// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Picture/ShownWords.h"
#include "Serve/PageServer.h"
#include "Serve/ServedScene.h"

#include "Trace/Renderer.h"

#include <nlohmann/json.hpp>

#include <array>
#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pixelexact
{
class ServedInput;

/// What an open page shows. The server's thread posts its messages, the drawing thread handles them
/// and draws: a coarse picture after each change, and the exact one once nothing has changed for
/// kPause. The exact picture is the one that render makes from Command().
///
/// A message is a JSON object with members of these names:
///   set: {"--option": "value", true or null}   options of render, those of PageWords.h
///   turn: [right, up]     radians; move: [right, up]  parts of the image's height
///   zoom: factor          view: "+x", ..., "iso", "fit"
///   size: [width, height] pixels
///   hover: [x, y]         pixels from the upper left; the reply has the value there
///   save: "png", "tif", "jpg", "svg", "pdf" or "vti"; the reply has the file
///   still: true           the exact picture is wanted at once
class ServedView
{
public:
  using Clock = std::chrono::steady_clock;
  /// Time without a change after which the exact picture is drawn.
  static constexpr std::chrono::milliseconds kPause{ 60 };
  /// Time after which an exact picture gives way to changes of other pages.
  static constexpr std::chrono::seconds kLongTrace{ 5 };
  /// Messages that may wait.
  static constexpr std::size_t kMaxWaiting = 1000;
  /// Sides and area of a picture in pixels.
  static constexpr int kMinSide = 16;
  static constexpr int kMaxSide = 4096;
  static constexpr int kMaxPixels = 1 << 22;

  /// `words`: those of the picture (WordsOfPicture). `changed` is called, on any thread, when there
  /// is work.
  ServedView(
    std::vector<std::string> words, std::shared_ptr<Outbox> outbox, std::function<void()> changed);
  ~ServedView();
  ServedView(const ServedView&) = delete;
  ServedView& operator=(const ServedView&) = delete;

  /// Takes a message. Returns false where it is no JSON object or too many wait. Any thread.
  bool Post(const std::string& text);
  /// The browser has left. Any thread.
  void Leave() { Left = true; }
  [[nodiscard]] bool HasLeft() const { return Left; }

  /// The kind of the work that waits; the lowest is the most urgent.
  enum class Work
  {
    Change,
    Exact,
    Nothing
  };
  /// The next work, and when it is due. Any thread.
  [[nodiscard]] std::pair<Work, Clock::time_point> Next();
  /// Does the work that is due. An exact picture of more than kLongTrace ends, to begin once more
  /// later, where `othersWait` says that another page was changed. Only on the drawing thread.
  void Perform(ServedInput& input, const std::function<bool()>& othersWait);

private:
  void Handle(const nlohmann::json& message, ServedInput& input);
  void HandleMove(const nlohmann::json& message);
  void SetOptions(const nlohmann::json& options);
  void SetView(const std::string& name);
  void SetSize(const nlohmann::json& size);
  void Hover(const std::array<int, 2>& pixel);
  void Save(const std::string& suffix, ServedInput& input);
  void Update(ServedInput& input);
  void DrawCoarse();
  void DrawExact(const std::function<bool()>& othersWait);
  void SendFailure(const std::string& text);
  void Changed(bool atOnce);
  [[nodiscard]] bool IsInterrupted();
  /// The words of render for what is shown; `output`: its file.
  [[nodiscard]] std::vector<std::string> Command(const std::string& output) const;
  [[nodiscard]] nlohmann::ordered_json State() const;

  std::shared_ptr<Outbox> Browser;
  std::function<void()> Wake;
  std::atomic<bool> Left = false;

  std::mutex Mutex; ///< of Waiting and ExactDue
  std::deque<nlohmann::json> Waiting;
  std::optional<Clock::time_point> ExactDue;

  // The drawing thread alone uses the following members.
  std::vector<std::string> Words;
  std::vector<std::string> Given; ///< the words at the beginning
  std::vector<std::string> Good;  ///< those of the last exact picture
  CameraView Eye;
  bool Fits = true; ///< the camera is that of Words, which may be fitted to the cut
  /// The ends of the colour map that the last exact picture had, which stay while the view moves.
  std::optional<std::array<double, 2>> Range;
  bool Stale = true; ///< Shown is not that of Words and Eye
  std::optional<std::array<int, 2>> HoverAt;
  std::vector<std::string> Saves;
  std::unique_ptr<ServedScene> Shown;
  RenderCounters Counters;
  std::unique_ptr<Renderer> Coarse;
  std::unique_ptr<Renderer> Probe;
};
} // namespace pixelexact
