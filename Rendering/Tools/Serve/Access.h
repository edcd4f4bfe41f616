// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

// Rules by which the server of pages accepts a request.
namespace pixelexact
{
/// Returns 32 hexadecimal digits, 128 bits of the operating system's random source. Throws Error
/// where it fails.
[[nodiscard]] std::string MakeToken();

/// Whether the texts are equal. The time depends on the length of `given` alone.
[[nodiscard]] bool IsSameToken(std::string_view token, std::string_view given);

/// Whether the header Host names the server. A server of a loopback address accepts localhost,
/// 127.0.0.1 and [::1] with any port, so that pages whose names lead to it (DNS rebinding) have no
/// access and ports may be forwarded. Another server accepts any host.
[[nodiscard]] bool IsOwnHost(std::string_view host, bool isLoopback);

/// Whether the header Origin of a WebSocket is absent (no browser) or that of the page that `host`,
/// the header Host, serves by http or https.
[[nodiscard]] bool IsOwnOrigin(std::string_view origin, std::string_view host);

/// Whether only this machine reaches the address: localhost, 127.x.x.x or ::1.
[[nodiscard]] bool IsLoopback(std::string_view address);
} // namespace pixelexact
