// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/BufferOptions.h"

#include "Base/Command.h"
#include "Base/Options.h"
#include "Base/Report.h"

#include "Core/Base/Error.h"
#include "Trace/BufferTable.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
constexpr const char* kColor = "Color";
constexpr const char* kContour = "Contour";

std::vector<std::string> ArrayNames()
{
  std::vector<std::string> names;
  ForEachBuffer([&names](const auto& row) { names.emplace_back(row.name); });
  names.emplace_back(kContour);
  names.emplace_back(kColor);
  return names;
}

/// None for what no ray brings: the picture itself, which is always there, and contours.
Buffer BufferNamed(const std::string& name)
{
  Buffer found = Buffer::None;
  ForEachBuffer([&](const auto& row) { found = row.name == name ? row.buffer : found; });
  return found;
}
} // namespace

void BufferOptions::AddTo(CLI::App& added)
{
  Command = &added;
  Bind(added, "--buffers", file_);
  Bind(added, "--arrays", [this](const std::string& text) { Names = SplitAt(text, ','); });
  FillHelp(added, "--arrays", "arrays", Listed(ArrayNames()));
}

void BufferOptions::Check() const
{
  const std::vector<std::string> known = ArrayNames();
  for (const std::string& name : Names)
  {
    if (std::ranges::find(known, name) == known.end())
    {
      throw UsageError("--arrays: there is no '" + name + "'; there are " + Listed(known));
    }
    if (name == kContour && !IsGiven(*Command, "--contours"))
    {
      throw UsageError("--arrays: 'Contour' needs --contours");
    }
    const Buffer buffer = BufferNamed(name);
    const bool bounded = IsGiven(*Command, "--enclosures") || IsGiven(*Command, "--show-undecided");
    if ((Has(buffer, Buffer::Coverage) && !IsGiven(*Command, "--owners")) ||
      (Has(buffer, Buffer::Enclosure) && !bounded))
    {
      throw UsageError("--arrays: '" + name + "' needs " +
        (Has(buffer, Buffer::Coverage) ? "--owners" : "--enclosures"));
    }
    if (Has(buffer, Buffer::Volume) && !IsGiven(*Command, "--volume"))
    {
      throw UsageError("--arrays: '" + name + "' needs --volume");
    }
  }
}

Buffer BufferOptions::Needs(bool hasField) const
{
  Buffer wanted = Buffer::None;
  for (const std::string& name : Names)
  {
    wanted = wanted | BufferNamed(name);
  }
  if (!hasField && Has(wanted, Buffer::Value))
  {
    throw Error("--arrays: the input has no field, so there is no 'Value'; leave it out");
  }
  if (!file_.empty() && Names.empty())
  {
    ForEachBuffer(
      [&](const auto& row)
      {
        const bool there = row.usual && (hasField || row.buffer != Buffer::Value);
        wanted = there ? wanted | row.buffer : wanted;
      });
  }
  return wanted;
}
} // namespace pixelexact
