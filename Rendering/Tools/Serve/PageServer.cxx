// SPDX-License-Identifier: BSD-3-Clause
#include "Serve/PageServer.h"

#include "Serve/Access.h"
#include "Serve/SocketOutbox.h"

#include "Core/Base/Error.h"

#include <libwebsockets.h>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

namespace pixelexact
{
namespace
{
using ServerClock = std::chrono::steady_clock;

/// Bytes of one write, after which other connections are served.
constexpr std::size_t kWriteBytes = 65536;
/// Messages that a browser may send at once after a pause.
constexpr double kBurst = 600.0;

/// The headers of the page. Its script and style are inside it, and it loads nothing.
constexpr std::array kPageHeaders{ std::pair{ "content-security-policy:",
                                     "default-src 'none'; script-src 'unsafe-inline'; style-src "
                                     "'unsafe-inline'; img-src blob: data:; connect-src 'self'; "
                                     "base-uri 'none'; form-action 'none'" },
  std::pair{ "x-content-type-options:", "nosniff" }, std::pair{ "referrer-policy:", "no-referrer" },
  std::pair{ "cache-control:", "no-store" } };

/// A WebSocket.
struct Connection
{
  std::shared_ptr<SocketOutbox> outbox;
  std::unique_ptr<PageClient> client;
  std::string received; ///< the parts of an unfinished message
  OutgoingMessage sending;
  std::size_t sent = 0; ///< bytes of `sending`
  bool isSending = false;
  bool isTimed = false; ///< the browser must take what was sent within kPatience
  bool isClosing = false;
  double credit = kBurst;
  ServerClock::time_point credited = ServerClock::now();

  /// Whether one more message keeps within the rate.
  bool Admit()
  {
    const auto now = ServerClock::now();
    const std::chrono::duration<double> passed = now - credited;
    credited = now;
    credit = std::min(kBurst, credit + passed.count() * PageServer::kMaxRate) - 1.0;
    return credit >= 0.0;
  }
};

/// libwebsockets allocates and clears one for each connection.
struct Socket
{
  Connection* connection; ///< null: no WebSocket, or none that was accepted
  std::size_t sentOfPage;
};

/// Whether this machine has the numeric address. libwebsockets would wait until it has.
bool HasAddress(const std::string& address)
{
  addrinfo hints{};
  hints.ai_flags = AI_NUMERICHOST;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (getaddrinfo(address.c_str(), nullptr, &hints, &found) != 0)
  {
    return false;
  }
  const int probe = socket(found->ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const bool isBound = probe >= 0 && bind(probe, found->ai_addr, found->ai_addrlen) == 0;
  if (probe >= 0)
  {
    close(probe);
  }
  freeaddrinfo(found);
  return isBound;
}

std::string HeaderOf(lws* socket, lws_token_indexes header)
{
  constexpr int kMaxHeader = 1024;
  const int length = lws_hdr_total_length(socket, header);
  if (length <= 0 || length >= kMaxHeader)
  {
    return {};
  }
  std::array<char, kMaxHeader> text{};
  const int copied = lws_hdr_copy(socket, text.data(), kMaxHeader, header);
  return copied > 0 ? std::string(text.data(), static_cast<std::size_t>(copied)) : std::string();
}

/// The argument token of the address.
std::string TokenOf(lws* socket)
{
  constexpr std::string_view kName = "token=";
  std::array<char, 256> text{};
  for (int k = 0; k < 8; ++k)
  {
    const int length = lws_hdr_copy_fragment(
      socket, text.data(), static_cast<int>(text.size()), WSI_TOKEN_HTTP_URI_ARGS, k);
    if (length < 0)
    {
      return {};
    }
    const std::string_view argument(text.data(), static_cast<std::size_t>(length));
    if (argument.starts_with(kName))
    {
      return std::string(argument.substr(kName.size()));
    }
  }
  return {};
}

/// Writes headers of a response with `length` bytes of content. Returns whether that succeeded.
bool WriteHeaders(lws* socket, unsigned status, std::size_t length)
{
  std::array<unsigned char, LWS_PRE + 2048> buffer{};
  unsigned char* const start = &buffer[LWS_PRE];
  unsigned char* at = start;
  unsigned char* const end = buffer.data() + buffer.size() - 1;
  const bool isPage = status == HTTP_STATUS_OK;
  if (lws_add_http_common_headers(
        socket, status, isPage ? "text/html; charset=utf-8" : nullptr, length, &at, end) != 0)
  {
    return false;
  }
  for (const auto& [name, value] : kPageHeaders)
  {
    if (lws_add_http_header_by_name(socket, reinterpret_cast<const unsigned char*>(name),
          reinterpret_cast<const unsigned char*>(value), static_cast<int>(std::strlen(value)), &at,
          end) != 0)
    {
      return false;
    }
  }
  return lws_finalize_write_http_header(socket, start, &at, end) == 0;
}

/// Ends the request with a status and no content. Returns the result of a callback.
int Refuse(lws* socket, unsigned status)
{
  (void)WriteHeaders(socket, status, 0);
  return -1;
}

/// Ends a WebSocket with a reason, without what is not yet sent. Returns the result of a callback.
int Disconnect(lws* socket, const Socket& state, lws_close_status status)
{
  if (state.connection != nullptr)
  {
    state.connection->isClosing = true;
  }
  lws_close_reason(socket, status, nullptr, 0);
  return -1;
}
} // namespace

class PageServer::Internals
{
public:
  explicit Internals(Settings settings)
    : Given(std::move(settings))
    , Loopback(IsLoopback(Given.address))
  {
    if (!HasAddress(Given.address))
    {
      throw Error("serve: '" + Given.address +
        "' is no numeric address of this machine; choose another --address, as 127.0.0.1 or "
        "0.0.0.0");
    }
    lws_set_log_level(0, nullptr);
    Protocols[0].name = "pixelexact";
    Protocols[0].callback = &Internals::Callback;
    Protocols[0].per_session_data_size = sizeof(Socket);
    Protocols[0].rx_buffer_size = kMaxMessage;
    Protocols[0].user = this;
    // Pings find browsers that are gone.
    Idle.secs_since_valid_ping = kPatience;
    Idle.secs_since_valid_hangup = 2 * kPatience;
    lws_context_creation_info info{};
    info.options = LWS_SERVER_OPTION_EXPLICIT_VHOSTS;
    info.gid = -1;
    info.uid = -1;
    info.timeout_secs = 10;
    info.timeout_secs_ah_idle = 10;
    info.max_http_header_data2 = 8192;
    info.max_http_header_pool2 = kMaxConnections;
    info.pt_serv_buf_size = kMaxMessage;
    info.user = this;
    Context = lws_create_context(&info);
    if (Context == nullptr)
    {
      throw Error("serve: libwebsockets cannot be initialised");
    }
    info.protocols = Protocols.data();
    info.port = Given.port;
    info.iface = Given.address.c_str();
    info.keepalive_timeout = 10;
    info.retry_and_idle_policy = &Idle;
    info.vhost_name = "pixelexact";
    Host = lws_create_vhost(Context, &info);
    if (Host == nullptr || lws_get_vhost_listen_port(Host) <= 0)
    {
      lws_context_destroy(Context);
      throw Error("serve: cannot listen at " + Given.address + ", port " +
        std::to_string(Given.port) + "; choose another --port or --address");
    }
  }
  ~Internals() { lws_context_destroy(Context); }
  Internals(const Internals&) = delete;
  Internals& operator=(const Internals&) = delete;

  [[nodiscard]] int Port() const { return lws_get_vhost_listen_port(Host); }
  void Run()
  {
    while (!Stopped && lws_service(Context, 0) >= 0)
    {
    }
  }
  void Stop()
  {
    Stopped = true;
    lws_cancel_service(Context);
  }

private:
  static int Callback(
    lws* socket, lws_callback_reasons reason, void* user, void* in, std::size_t length)
  {
    const lws_protocols* protocol = lws_get_protocol(socket);
    if (protocol == nullptr || protocol->user == nullptr)
    {
      return 0;
    }
    try
    {
      return static_cast<Internals*>(protocol->user)
        ->Handle(socket, reason, static_cast<Socket*>(user), in, length);
    }
    catch (...)
    {
      return -1; // ends the connection, as where memory is exhausted
    }
  }

  int Handle(
    lws* socket, lws_callback_reasons reason, Socket* state, const void* in, std::size_t length)
  {
    switch (reason)
    {
      case LWS_CALLBACK_FILTER_NETWORK_CONNECTION:
        return Connections >= kMaxConnections ? -1 : 0;
      case LWS_CALLBACK_WSI_CREATE:
        ++Connections;
        return 0;
      case LWS_CALLBACK_WSI_DESTROY:
        --Connections;
        return 0;
      case LWS_CALLBACK_HTTP:
        return AnswerRequest(socket, *state);
      case LWS_CALLBACK_HTTP_WRITEABLE:
        return WritePage(socket, *state);
      case LWS_CALLBACK_HTTP_BODY:
      case LWS_CALLBACK_HTTP_BODY_COMPLETION:
        return -1;
      case LWS_CALLBACK_FILTER_PROTOCOL_CONNECTION:
        return AnswerUpgrade(socket);
      case LWS_CALLBACK_ESTABLISHED:
        return Establish(socket, *state);
      case LWS_CALLBACK_RECEIVE:
        return Receive(socket, *state, { static_cast<const char*>(in), length });
      case LWS_CALLBACK_SERVER_WRITEABLE:
        return Write(socket, *state);
      case LWS_CALLBACK_CLOSED:
        Close(*state);
        return 0;
      case LWS_CALLBACK_EVENT_WAIT_CANCELLED:
        lws_callback_on_writable_all_protocol(Context, Protocols.data());
        return 0;
      default:
        return lws_callback_http_dummy(
          socket, reason, state, const_cast<void*>(in), length); // its interface is C's
    }
  }

  [[nodiscard]] bool IsAdmitted(lws* socket) const
  {
    return IsSameToken(Given.token, TokenOf(socket)) &&
      IsOwnHost(HeaderOf(socket, WSI_TOKEN_HOST), Loopback);
  }

  int AnswerRequest(lws* socket, Socket& state)
  {
    if (!IsAdmitted(socket) || HeaderOf(socket, WSI_TOKEN_GET_URI) != "/")
    {
      return Refuse(socket, HTTP_STATUS_FORBIDDEN);
    }
    state.sentOfPage = 0;
    if (!WriteHeaders(socket, HTTP_STATUS_OK, Given.page.size()))
    {
      return -1;
    }
    lws_callback_on_writable(socket);
    return 0;
  }

  int WritePage(lws* socket, Socket& state)
  {
    const std::size_t count =
      std::min(kWriteBytes, Given.page.size() - std::min(state.sentOfPage, Given.page.size()));
    std::vector<unsigned char> buffer(LWS_PRE + count);
    std::copy_n(Given.page.data() + state.sentOfPage, count, &buffer[LWS_PRE]);
    state.sentOfPage += count;
    const bool isLast = state.sentOfPage >= Given.page.size();
    if (lws_write(socket, &buffer[LWS_PRE], count, isLast ? LWS_WRITE_HTTP_FINAL : LWS_WRITE_HTTP) <
      0)
    {
      return -1;
    }
    if (isLast)
    {
      return lws_http_transaction_completed(socket) != 0 ? -1 : 0;
    }
    lws_callback_on_writable(socket);
    return 0;
  }

  int AnswerUpgrade(lws* socket) const
  {
    const std::string host = HeaderOf(socket, WSI_TOKEN_HOST);
    const bool hasOrigin = lws_hdr_total_length(socket, WSI_TOKEN_ORIGIN) > 0;
    const std::string origin = HeaderOf(socket, WSI_TOKEN_ORIGIN);
    // An origin that is too long to be copied is not empty, but foreign.
    if (!IsAdmitted(socket) || (hasOrigin && (origin.empty() || !IsOwnOrigin(origin, host))))
    {
      return Refuse(socket, HTTP_STATUS_FORBIDDEN);
    }
    return Clients >= Given.clients ? Refuse(socket, HTTP_STATUS_SERVICE_UNAVAILABLE) : 0;
  }

  int Establish(lws* socket, Socket& state)
  {
    auto connection = std::make_unique<Connection>();
    connection->outbox = std::make_shared<SocketOutbox>(Context);
    connection->client = Given.connect(connection->outbox);
    if (!connection->client)
    {
      return Disconnect(socket, state, LWS_CLOSE_STATUS_POLICY_VIOLATION);
    }
    ++Clients;
    state.connection = connection.release();
    return 0;
  }

  int Receive(lws* socket, Socket& state, std::string_view part) const
  {
    Connection* connection = state.connection;
    if (connection == nullptr || lws_frame_is_binary(socket) != 0)
    {
      return Disconnect(socket, state, LWS_CLOSE_STATUS_UNACCEPTABLE_OPCODE);
    }
    if (connection->received.size() + part.size() > kMaxMessage)
    {
      return Disconnect(socket, state, LWS_CLOSE_STATUS_MESSAGE_TOO_LARGE);
    }
    connection->received += part;
    if (lws_is_final_fragment(socket) == 0 || lws_remaining_packet_payload(socket) != 0)
    {
      return 0;
    }
    const std::string text = std::exchange(connection->received, {});
    return connection->Admit() && connection->client->Receive(text)
      ? 0
      : Disconnect(socket, state, LWS_CLOSE_STATUS_POLICY_VIOLATION);
  }

  static int Write(lws* socket, Socket& state)
  {
    Connection* connection = state.connection;
    if (connection == nullptr || connection->isClosing)
    {
      return 0;
    }
    if (connection->outbox->IsOverfull())
    {
      return Disconnect(socket, state, LWS_CLOSE_STATUS_POLICY_VIOLATION);
    }
    if (!connection->isSending)
    {
      std::optional<OutgoingMessage> next = connection->outbox->Take();
      if (!next)
      {
        // The handshake of closing has a time limit of its own.
        if (std::exchange(connection->isTimed, false))
        {
          lws_set_timeout(socket, NO_PENDING_TIMEOUT, 0);
        }
        return 0;
      }
      connection->sending = std::move(*next);
      connection->sent = 0;
      connection->isSending = true;
    }
    OutgoingMessage& message = connection->sending;
    const std::size_t count = std::min(kWriteBytes, message.bytes.size() - connection->sent);
    const bool isLast = connection->sent + count == message.bytes.size();
    std::vector<unsigned char> buffer(LWS_PRE + count);
    std::copy_n(message.bytes.data() + connection->sent, count, &buffer[LWS_PRE]);
    const int flags = lws_write_ws_flags(message.binary ? LWS_WRITE_BINARY : LWS_WRITE_TEXT,
      connection->sent == 0 ? 1 : 0, isLast ? 1 : 0);
    if (lws_write(socket, &buffer[LWS_PRE], count, static_cast<lws_write_protocol>(flags)) < 0)
    {
      return -1;
    }
    connection->sent += count;
    if (isLast)
    {
      connection->isSending = false;
      message.bytes = {};
    }
    connection->isTimed = true;
    lws_set_timeout(socket, PENDING_TIMEOUT_USER_REASON_BASE, kPatience);
    lws_callback_on_writable(socket);
    return 0;
  }

  void Close(Socket& state)
  {
    const std::unique_ptr<Connection> connection(std::exchange(state.connection, nullptr));
    if (connection)
    {
      connection->outbox->Detach();
      --Clients;
    }
  }

  Settings Given;
  bool Loopback;
  std::array<lws_protocols, 2> Protocols{};
  lws_retry_bo_t Idle{};
  lws_context* Context = nullptr;
  lws_vhost* Host = nullptr;
  std::atomic<bool> Stopped = false;
  int Connections = 0; ///< of all kinds, with the listening socket
  int Clients = 0;     ///< WebSockets
};

PageServer::PageServer(Settings settings)
  : Data(std::make_unique<Internals>(std::move(settings)))
{
}

PageServer::~PageServer() = default;

int PageServer::Port() const
{
  return Data->Port();
}

void PageServer::Run()
{
  Data->Run();
}

void PageServer::Stop()
{
  Data->Stop();
}
} // namespace pixelexact
