// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

// HTTP and WebSocket of the command serve, by libwebsockets.
namespace pixelexact
{
/// Sends messages to one browser. Functions may be called from any thread, also after the browser
/// has left; then they have no effect.
class Outbox
{
public:
  Outbox() = default;
  virtual ~Outbox() = default;
  Outbox(const Outbox&) = delete;
  Outbox& operator=(const Outbox&) = delete;

  /// Appends a text message. Closes the connection where more than kMaxTexts are not yet sent.
  virtual void SendText(std::string text) = 0;
  /// Sends a binary message. A frame that is not yet sent is replaced, so that a slow browser gets
  /// the newest one.
  virtual void SendFrame(std::string bytes) = 0;
  /// Sends a binary message that no later one replaces. Closes the connection where another one is
  /// not yet sent.
  virtual void SendFile(std::string bytes) = 0;
  /// Whether a file is not yet being sent.
  [[nodiscard]] virtual bool HoldsFile() = 0;

  static constexpr std::size_t kMaxTexts = 256;
};

/// Receives one browser's messages, on the server's thread.
class PageClient
{
public:
  PageClient() = default;
  virtual ~PageClient() = default;
  PageClient(const PageClient&) = delete;
  PageClient& operator=(const PageClient&) = delete;

  /// Handles a message of at most PageServer::kMaxMessage bytes. Returns false where the browser
  /// must be disconnected. Must return soon and must not throw.
  virtual bool Receive(const std::string& text) = 0;
};

/// Serves one page, at /?token=TOKEN, and WebSockets at the same address. A request without the
/// token, with another host or of another page's script gets status 403 and no content.
class PageServer
{
public:
  /// Largest message of a browser in bytes. A longer one ends the connection.
  static constexpr std::size_t kMaxMessage = 16384;
  /// Messages of one browser in a second, on average. More end the connection.
  static constexpr double kMaxRate = 300.0;
  /// Connections in all, with those that have not yet sent a request.
  static constexpr int kMaxConnections = 128;
  /// Seconds in which a browser must take a part of what is sent to it.
  static constexpr int kPatience = 30;
  /// Bytes of one write, after which other connections are served.
  static constexpr std::size_t kWriteBytes = 65536;

  struct Settings
  {
    std::string address; ///< to listen at, as 127.0.0.1
    int port = 0;        ///< 0: any free one
    int clients = 0;     ///< largest number of WebSockets; more get status 503
    std::string token;
    std::string page; ///< HTML
    /// Called, on the server's thread, for each browser that connects; null: it is refused.
    std::function<std::unique_ptr<PageClient>(std::shared_ptr<Outbox>)> connect;
  };

  /// Listens. Throws Error where the port is taken or the address does not exist.
  explicit PageServer(Settings settings);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  [[nodiscard]] int Port() const;
  /// Serves until Stop was called.
  void Run();
  /// May be called from any thread and from a signal handler.
  void Stop();

  class Internals;

private:
  std::unique_ptr<Internals> Data;
};
} // namespace pixelexact
