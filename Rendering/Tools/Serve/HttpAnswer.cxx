// SPDX-License-Identifier: BSD-3-Clause
#include "Serve/HttpAnswer.h"

#include "Serve/PageServer.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

namespace pixelexact
{
namespace
{
/// The headers of the page. Its script and style are inside it, and it loads nothing.
constexpr std::array kPageHeaders{ std::pair{ "content-security-policy:",
                                     "default-src 'none'; script-src 'unsafe-inline'; style-src "
                                     "'unsafe-inline'; img-src blob: data:; connect-src 'self'; "
                                     "base-uri 'none'; form-action 'none'" },
  std::pair{ "x-content-type-options:", "nosniff" }, std::pair{ "referrer-policy:", "no-referrer" },
  std::pair{ "cache-control:", "no-store" } };
} // namespace

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

int Refuse(lws* socket, unsigned status)
{
  (void)WriteHeaders(socket, status, 0);
  return -1;
}

int WritePage(lws* socket, const std::string& page, std::size_t& sent)
{
  const std::size_t begin = std::min(sent, page.size());
  const std::size_t count = std::min(PageServer::kWriteBytes, page.size() - begin);
  std::vector<unsigned char> buffer(LWS_PRE + count);
  std::copy_n(page.data() + begin, count, &buffer[LWS_PRE]);
  sent = begin + count;
  const bool isLast = sent >= page.size();
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
} // namespace pixelexact
