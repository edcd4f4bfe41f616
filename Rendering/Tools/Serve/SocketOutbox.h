// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Serve/PageServer.h"

#include <deque>
#include <mutex>
#include <optional>
#include <string>

struct lws_context;

namespace pixelexact
{
/// A message to a browser.
struct OutgoingMessage
{
  std::string bytes;
  bool binary = false;
};

/// The messages to one browser that are not yet sent.
class SocketOutbox final : public Outbox
{
public:
  /// Wakes the context's thread when there is a message.
  explicit SocketOutbox(lws_context* context);

  void SendText(std::string text) override;
  void SendFrame(std::string bytes) override;
  void SendFile(std::string bytes) override;
  [[nodiscard]] bool HoldsFile() override;

  /// Removes and returns the next message, or none: texts precede files, and these frames.
  [[nodiscard]] std::optional<OutgoingMessage> Take();
  /// Whether the browser takes its messages too slowly, so that some were dropped.
  [[nodiscard]] bool IsOverfull();
  /// Drops all messages, now and later: the connection has ended.
  void Detach();

private:
  void Append(std::deque<std::string>& queue, std::string bytes);

  std::mutex Mutex;     ///< of all members
  lws_context* Context; ///< null: the connection has ended
  std::deque<std::string> Texts;
  std::deque<std::string> Files;
  std::deque<std::string> Frames;
  bool Overfull = false;
};
} // namespace pixelexact
