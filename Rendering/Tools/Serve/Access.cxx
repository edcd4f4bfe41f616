// SPDX-License-Identifier: BSD-3-Clause
#include "Serve/Access.h"

#include "Core/Base/Error.h"

#include <fmt/format.h>
#include <sys/random.h>

#include <array>
#include <cstdint>

namespace pixelexact
{
std::string MakeToken()
{
  std::array<std::uint8_t, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
  {
    throw Error("serve: the operating system gives no random numbers for a token");
  }
  std::string token;
  token.reserve(2 * bytes.size());
  for (const std::uint8_t byte : bytes)
  {
    token += fmt::format("{:02x}", byte);
  }
  return token;
}

bool IsSameToken(std::string_view token, std::string_view given)
{
  unsigned differences = token.size() == given.size() ? 0U : 1U;
  for (std::size_t k = 0; k < given.size(); ++k)
  {
    const char expected = token.empty() ? '\0' : token[k % token.size()];
    differences |= static_cast<unsigned char>(expected) ^ static_cast<unsigned char>(given[k]);
  }
  return differences == 0U && !token.empty();
}

bool IsOwnHost(std::string_view host, bool isLoopback)
{
  if (!isLoopback)
  {
    return !host.empty();
  }
  const std::size_t colon = host.starts_with('[') ? host.find("]:") : host.rfind(':');
  std::string_view name = host;
  if (colon != std::string_view::npos)
  {
    name = host.substr(0, colon + (host.starts_with('[') ? 1 : 0));
  }
  return name == "localhost" || name == "127.0.0.1" || name == "[::1]";
}

bool IsOwnOrigin(std::string_view origin, std::string_view host)
{
  return origin.empty() || origin == fmt::format("http://{}", host) ||
    origin == fmt::format("https://{}", host);
}

bool IsLoopback(std::string_view address)
{
  return address == "localhost" || address == "::1" || address.starts_with("127.");
}
} // namespace pixelexact
