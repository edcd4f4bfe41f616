// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Serve/FileDrawer.h"
#include "Serve/PageServer.h"
#include "Serve/ServedView.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace pixelexact
{
class ServedInput;

/// Draws the pictures of all pages, on a thread of its own that uses all processors. Changes
/// precede exact pictures, and pages take turns. Files that pages save are drawn beside them.
class Drawer
{
public:
  /// The input must outlive it.
  explicit Drawer(ServedInput& input);
  ~Drawer();
  Drawer(const Drawer&) = delete;
  Drawer& operator=(const Drawer&) = delete;

  /// A page that begins with these words (WordsOfPicture). Any thread.
  std::unique_ptr<PageClient> Open(
    const std::vector<std::string>& words, std::shared_ptr<Outbox> outbox);

private:
  void Run();
  /// There may be work. Any thread.
  void Wake();
  /// Removes the views of browsers that left, and returns the next one that has work, or null after
  /// waiting for some.
  std::shared_ptr<ServedView> Next();
  /// Whether a message waits of another view than this one.
  bool AreOthersChanged(const ServedView* view);

  ServedInput& Input;
  std::mutex Mutex; ///< of the members up to Turn
  std::condition_variable Condition;
  bool Ends = false;
  bool Woken = false;
  std::vector<std::shared_ptr<ServedView>> Views;
  std::size_t Turn = 0; ///< the view that is first among equally urgent ones
  FileDrawer Files;
  std::thread Thread;
};
} // namespace pixelexact
