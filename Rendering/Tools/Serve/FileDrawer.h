// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Serve/ServedScene.h"

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace pixelexact
{
class Outbox;

/// A file that a page saves.
struct FileRequest
{
  std::string suffix;             ///< "png", "tif", "jpg", "svg", "pdf" or "vti"
  std::string stem;               ///< the file's name without its suffix
  std::vector<std::string> words; ///< of render

  /// The file that `stem` and `suffix` name is the picture, or else the buffers beside it.
  [[nodiscard]] bool IsBuffers() const { return suffix == "vti"; }
  [[nodiscard]] std::string Picture() const { return stem + (IsBuffers() ? "png" : suffix); }
};

/// Whether pages may save files with the suffix.
[[nodiscard]] bool IsSavedSuffix(const std::string& suffix);

/// Draws the files that pages save, one at a time, on a thread whose work gives way to that of
/// pictures.
class FileDrawer
{
public:
  /// `done`: called, on its thread, when it can draw another file.
  explicit FileDrawer(std::function<void()> done);
  /// Waits for the end of the step in progress, and draws no other.
  ~FileDrawer();
  FileDrawer(const FileDrawer&) = delete;
  FileDrawer& operator=(const FileDrawer&) = delete;

  /// Whether it can draw a file.
  [[nodiscard]] bool IsIdle();
  /// Draws the file, while it is idle. `browser` gets the file, or a message of its failure.
  /// `hasLeft`: whether nobody waits for it; called on any thread.
  void Begin(FileRequest file, std::unique_ptr<ServedScene> scene, std::shared_ptr<Outbox> browser,
    std::function<bool()> hasLeft);

private:
  struct Job
  {
    FileRequest file;
    std::unique_ptr<ServedScene> scene;
    std::shared_ptr<Outbox> browser;
    std::function<bool()> hasLeft;
  };
  void Run();
  void Draw(const Job& job);

  std::function<void()> OnDone;
  std::mutex Mutex; ///< of the members up to Current
  std::condition_variable Condition;
  bool Ends = false;
  std::unique_ptr<Job> Current; ///< null: idle
  std::thread Thread;
};
} // namespace pixelexact
