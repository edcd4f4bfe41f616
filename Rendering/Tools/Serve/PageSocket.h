// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Serve/PageServer.h"
#include "Serve/SocketOutbox.h"

#include <libwebsockets.h>

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace pixelexact
{
/// A WebSocket: joins the parts of messages, limits their size and rate, and sends those of an
/// outbox part by part. For the server's thread. Functions return the result of a callback of
/// libwebsockets, -1 to end the connection.
class PageSocket
{
public:
  /// Sends what `outbox` gets, and gives messages to `client`.
  PageSocket(std::shared_ptr<SocketOutbox> outbox, std::unique_ptr<PageClient> client);
  /// The browser has left.
  ~PageSocket();
  PageSocket(const PageSocket&) = delete;
  PageSocket& operator=(const PageSocket&) = delete;

  /// Takes a part of a message.
  int Receive(lws* socket, std::string_view part);
  /// Sends a part of a message, if there is one.
  int Write(lws* socket);

private:
  using Clock = std::chrono::steady_clock;
  /// Messages that a browser may send at once after a pause.
  static constexpr double kBurst = 600.0;

  /// Whether one more message keeps within the rate.
  bool Admit();
  /// Takes the next message of the outbox. Returns whether there is one.
  bool Begin(lws* socket);
  int End(lws* socket, lws_close_status status);

  std::shared_ptr<SocketOutbox> From;
  std::unique_ptr<PageClient> Client;
  std::string Received; ///< the parts of an unfinished message
  OutgoingMessage Sending;
  std::size_t Sent = 0; ///< bytes of Sending
  bool IsSending = false;
  bool IsTimed = false; ///< the browser must take what was sent within PageServer::kPatience
  bool IsClosing = false;
  double Credit = kBurst; ///< messages
  Clock::time_point Credited = Clock::now();
};

/// Ends a WebSocket with a reason. Returns the result of a callback.
int Disconnect(lws* socket, lws_close_status status);
} // namespace pixelexact
