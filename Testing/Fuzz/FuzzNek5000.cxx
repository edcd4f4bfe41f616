// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as a list of Nek5000's steps, as the file of a step and, where lines separate them, as
// the parts of one.
#include "Core/Base/Error.h"
#include "Formats/Nek5000/Reader.h"
#include "Formats/Nek5000/Series.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  constexpr std::string_view kSeparator = "\n---- part ----\n";
  std::string_view text(reinterpret_cast<const char*>(data), size);
  try
  {
    const auto series = pixelexact::nek5000::ParseSeriesFile({ "x.nek5000", text });
    static_cast<void>(series.NamesOf("x.nek5000", series.first).Of(1));
  }
  catch (const pixelexact::Error&)
  {
    // The answer that a bad file should get; anything else ends the process.
  }
  std::vector<pixelexact::NamedText> parts;
  for (auto at = text.find(kSeparator); at != std::string_view::npos; at = text.find(kSeparator))
  {
    parts.push_back({ "x.f00000", text.substr(0, at) });
    text.remove_prefix(at + kSeparator.size());
  }
  parts.push_back({ "x.f00000", text });
  try
  {
    pixelexact::nek5000::Read(parts, {});
    pixelexact::nek5000::Read(parts, parts);
  }
  catch (const pixelexact::Error&)
  {
    // As above.
  }
  return 0;
}
