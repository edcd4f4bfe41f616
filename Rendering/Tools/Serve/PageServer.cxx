// SPDX-License-Identifier: BSD-3-Clause
#include "Serve/PageServer.h"

#include "Serve/Access.h"
#include "Serve/HttpAnswer.h"
#include "Serve/PageSocket.h"
#include "Serve/SocketOutbox.h"

#include "Core/Base/Error.h"

#include <libwebsockets.h>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <utility>

namespace pixelexact
{
namespace
{
/// libwebsockets allocates and clears one for each connection.
struct Socket
{
  PageSocket* page; ///< null: no WebSocket, or none that was accepted
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
        return WritePage(socket, Given.page, state->sentOfPage);
      case LWS_CALLBACK_HTTP_BODY:
      case LWS_CALLBACK_HTTP_BODY_COMPLETION:
        return -1;
      case LWS_CALLBACK_FILTER_PROTOCOL_CONNECTION:
        return AnswerUpgrade(socket);
      case LWS_CALLBACK_ESTABLISHED:
        return Establish(socket, *state);
      case LWS_CALLBACK_RECEIVE:
        return state->page != nullptr
          ? state->page->Receive(socket, { static_cast<const char*>(in), length })
          : Disconnect(socket, LWS_CLOSE_STATUS_UNACCEPTABLE_OPCODE);
      case LWS_CALLBACK_SERVER_WRITEABLE:
        return state->page != nullptr ? state->page->Write(socket) : 0;
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
    auto outbox = std::make_shared<SocketOutbox>(Context);
    std::unique_ptr<PageClient> client = Given.connect(outbox);
    if (!client)
    {
      return Disconnect(socket, LWS_CLOSE_STATUS_POLICY_VIOLATION);
    }
    state.page = std::make_unique<PageSocket>(std::move(outbox), std::move(client)).release();
    ++Clients;
    return 0;
  }

  void Close(Socket& state)
  {
    const std::unique_ptr<PageSocket> page(std::exchange(state.page, nullptr));
    Clients -= page ? 1 : 0;
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
