// SPDX-License-Identifier: BSD-3-Clause
#include "Serve/PageSocket.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace pixelexact
{
int Disconnect(lws* socket, lws_close_status status)
{
  lws_close_reason(socket, status, nullptr, 0);
  return -1;
}

PageSocket::PageSocket(std::shared_ptr<SocketOutbox> outbox, std::unique_ptr<PageClient> client)
  : From(std::move(outbox))
  , Client(std::move(client))
{
}

PageSocket::~PageSocket()
{
  From->Detach();
}

bool PageSocket::Admit()
{
  const auto now = Clock::now();
  const std::chrono::duration<double> passed = now - Credited;
  Credited = now;
  Credit = std::min(kBurst, Credit + passed.count() * PageServer::kMaxRate) - 1.0;
  return Credit >= 0.0;
}

int PageSocket::End(lws* socket, lws_close_status status)
{
  IsClosing = true; // what is not yet sent stays
  return Disconnect(socket, status);
}

int PageSocket::Receive(lws* socket, std::string_view part)
{
  if (lws_frame_is_binary(socket) != 0)
  {
    return End(socket, LWS_CLOSE_STATUS_UNACCEPTABLE_OPCODE);
  }
  if (Received.size() + part.size() > PageServer::kMaxMessage)
  {
    return End(socket, LWS_CLOSE_STATUS_MESSAGE_TOO_LARGE);
  }
  Received += part;
  if (lws_is_final_fragment(socket) == 0 || lws_remaining_packet_payload(socket) != 0)
  {
    return 0;
  }
  const std::string text = std::exchange(Received, {});
  return Admit() && Client->Receive(text) ? 0 : End(socket, LWS_CLOSE_STATUS_POLICY_VIOLATION);
}

bool PageSocket::Begin(lws* socket)
{
  std::optional<OutgoingMessage> next = From->Take();
  if (!next)
  {
    // The handshake of closing has a time limit of its own.
    if (std::exchange(IsTimed, false))
    {
      lws_set_timeout(socket, NO_PENDING_TIMEOUT, 0);
    }
    return false;
  }
  Sending = std::move(*next);
  Sent = 0;
  IsSending = true;
  return true;
}

int PageSocket::Write(lws* socket)
{
  if (IsClosing)
  {
    return 0;
  }
  if (From->IsOverfull())
  {
    return End(socket, LWS_CLOSE_STATUS_POLICY_VIOLATION);
  }
  if (!IsSending && !Begin(socket))
  {
    return 0;
  }
  const std::size_t count = std::min(PageServer::kWriteBytes, Sending.bytes.size() - Sent);
  const bool isLast = Sent + count == Sending.bytes.size();
  std::vector<unsigned char> buffer(LWS_PRE + count);
  std::copy_n(Sending.bytes.data() + Sent, count, &buffer[LWS_PRE]);
  const int flags = lws_write_ws_flags(
    Sending.binary ? LWS_WRITE_BINARY : LWS_WRITE_TEXT, Sent == 0 ? 1 : 0, isLast ? 1 : 0);
  if (lws_write(socket, &buffer[LWS_PRE], count, static_cast<lws_write_protocol>(flags)) < 0)
  {
    return -1;
  }
  Sent += count;
  if (isLast)
  {
    IsSending = false;
    Sending.bytes = {};
  }
  IsTimed = true;
  lws_set_timeout(socket, PENDING_TIMEOUT_USER_REASON_BASE, PageServer::kPatience);
  lws_callback_on_writable(socket);
  return 0;
}
} // namespace pixelexact
