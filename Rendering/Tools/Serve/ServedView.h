// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Serve/FileDrawer.h"
#include "Serve/PageServer.h"
#include "Serve/PageState.h"
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

/// An open page. The server's thread posts its messages, the drawing thread handles them and draws:
/// a coarse picture after each change, and the exact one once nothing has changed for kPause. The
/// exact picture is the one that render makes from the command of the page's state.
///
/// A message is a JSON object with the members of PageState, and these:
///   hover: [x, y]         pixels from the upper left; the reply has the value there
///   save: "png", "tif", "jpg", "svg", "pdf" or "vti"; the reply has the file
///   still: true           the exact picture is wanted at once
class ServedView
{
public:
  using Clock = std::chrono::steady_clock;
  /// Time without a change after which the exact picture is drawn.
  static constexpr std::chrono::milliseconds kPause{ 60 };
  /// Time after which an exact picture gives way to changes of other pages. Each time it does, the
  /// time doubles, so that it is finished some day.
  static constexpr std::chrono::seconds kLongTrace{ 5 };
  /// Time until it begins once more, in which the exact pictures of the other pages are due.
  static constexpr std::chrono::milliseconds kLater{ 500 };
  /// Messages that may wait.
  static constexpr std::size_t kMaxWaiting = 1000;
  /// Files of a page that may wait to be drawn.
  static constexpr std::size_t kMaxFiles = 4;

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
  void Leave() { *Left = true; }
  [[nodiscard]] bool HasLeft() const { return *Left; }

  /// The kind of the work that waits; the lowest is the most urgent.
  enum class Work
  {
    Change,
    File, ///< to be handed to the FileDrawer
    Exact,
    Nothing
  };
  /// The next work, and when it is due. Only on the drawing thread, and on others while that one
  /// waits for them.
  [[nodiscard]] std::pair<Work, Clock::time_point> Next(FileDrawer& files);
  /// Does the work that is due. An exact picture of more than Patience ends, to begin once more
  /// later, where `othersWait` says that another page was changed. Only on the drawing thread.
  void Perform(ServedInput& input, FileDrawer& files, const std::function<bool()>& othersWait);

private:
  void Handle(const nlohmann::json& message);
  void Hover(const std::array<int, 2>& pixel);
  void RequestFile(const std::string& suffix);
  void BeginFile(ServedInput& input, FileDrawer& files);
  void Update(ServedInput& input);
  void DrawCoarse();
  void DrawExact(const std::function<bool()>& othersWait);
  /// Withdraws the state that cannot be drawn.
  void SendFailure(const std::string& text);
  void SendRefusal(const std::string& text);
  void Changed(bool atOnce);
  [[nodiscard]] bool IsInterrupted();
  [[nodiscard]] nlohmann::ordered_json Header() const;

  std::shared_ptr<Outbox> Browser;
  std::function<void()> Wake;
  /// Shared with files that outlive the view.
  std::shared_ptr<std::atomic<bool>> Left = std::make_shared<std::atomic<bool>>(false);

  std::mutex Mutex; ///< of Waiting and ExactDue
  std::deque<nlohmann::json> Waiting;
  std::optional<Clock::time_point> ExactDue;

  // The drawing thread alone uses the following members.
  PageState State;
  std::chrono::seconds Patience = kLongTrace; ///< of the exact picture that is due
  bool Stale = true;                          ///< Shown is not that of State
  std::optional<std::array<int, 2>> HoverAt;
  std::vector<std::string> Saves; ///< suffixes of messages that are being handled
  std::deque<FileRequest> Files;  ///< that wait to be drawn
  std::unique_ptr<ServedScene> Shown;
  RenderCounters Counters;
  std::unique_ptr<Renderer> Coarse;
  std::unique_ptr<Renderer> Probe;
};
} // namespace pixelexact
