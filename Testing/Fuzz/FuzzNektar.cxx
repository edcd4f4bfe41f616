// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as the files of a session and, behind a line that separates them, a field file.
#include "Core/Base/Error.h"
#include "Formats/Nektar/Reader.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  constexpr std::string_view kSeparator = "\n---- field file ----\n";
  constexpr std::string_view kNext = "\n---- session file ----\n";
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto at = text.find(kSeparator);
  std::vector<pixelexact::NamedText> sessions;
  for (std::string_view rest = text.substr(0, at); sessions.empty() || !rest.empty();)
  {
    const auto end = rest.find(kNext);
    sessions.push_back({ "input.xml", rest.substr(0, end) });
    rest.remove_prefix(end == rest.npos ? rest.size() : end + kNext.size());
  }
  std::vector<pixelexact::NamedText> fields;
  if (at != std::string_view::npos)
  {
    fields.push_back({ "input.fld", text.substr(at + kSeparator.size()) });
  }
  try
  {
    pixelexact::nektar::Read(sessions, fields);
  }
  catch (const pixelexact::Error&)
  {
    // The answer that a bad file should get; anything else ends the process.
  }
  return 0;
}
