// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <libwebsockets.h>

#include <cstddef>
#include <string>

// HTTP requests and answers of the server of pages, by libwebsockets. For the server's thread.
namespace pixelexact
{
/// The request's header; empty: there is none, or one of 1024 bytes or more.
[[nodiscard]] std::string HeaderOf(lws* socket, lws_token_indexes header);

/// The argument token of the request's address, of at most 255 bytes with its name; empty: none
/// among the first 8 arguments.
[[nodiscard]] std::string TokenOf(lws* socket);

/// Writes the headers of an answer with `length` bytes of content. Returns whether that succeeded.
[[nodiscard]] bool WriteHeaders(lws* socket, unsigned status, std::size_t length);

/// Ends the request with a status and no content. Returns the result of a callback.
int Refuse(lws* socket, unsigned status);

/// Writes the next part of the page's content after `sent` bytes, which it increases. Returns the
/// result of a callback.
int WritePage(lws* socket, const std::string& page, std::size_t& sent);
} // namespace pixelexact
