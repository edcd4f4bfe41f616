// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/DebugOptions.h"

#include "Base/Command.h"
#include "Base/Options.h"
#include "Base/Report.h"
#include "Core/Base/Counted.h"
#include "Core/Location/Owners.h"
#include "Scene/Effects.h"
#include "Scene/LayerOptions.h"
#include "Scene/Shot.h"

#include <nlohmann/json.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace pixelexact
{
FoundJumps::FoundJumps(const Shot& shot, Frame& frame)
  : Jumps(FindCutJumps(shot.scene, frame.centres))
  , Layers(shot.scene.layers.size())
  , SourceCells(shot.input.model->SourceCells())
{
}

std::array<std::int64_t, 2> FoundJumps::Cells() const
{
  std::array<std::int64_t, 2> cells{};
  std::ranges::transform(Jumps.largest->elements, cells.begin(),
    [this](std::int32_t element) { return SourceCells[static_cast<std::size_t>(element)]; });
  return cells;
}

void FoundJumps::AddTo(Table& table) const
{
  table.Row("jumps",
    "{} of neighbouring pixels jump, {} continuous, {} not finite, {} without a "
    "common face",
    Counted(Jumps.jumping, "pair"), Jumps.continuous, Jumps.notFinite, Jumps.notFound);
  if (!Jumps.largest)
  {
    return;
  }
  const CutJump& largest = *Jumps.largest;
  const auto [here, there] = Cells();
  const Vec3& at = largest.position;
  table.Row("", "largest {} at {}, {}, {}, between elements {} and {}{}", Short(largest.jump),
    Short(at.x), Short(at.y), Short(at.z), here, there,
    Layers > 1 ? fmt::format("; layer {}", largest.layer + 1) : std::string());
  table.Row("", "colours: yellow 0 to dark purple {}; light blue: continuous", Short(largest.jump));
}

void FoundJumps::AddTo(nlohmann::ordered_json& summary) const
{
  nlohmann::ordered_json& jumps = summary["jumps"];
  jumps = { { "jumping", Jumps.jumping }, { "continuous", Jumps.continuous },
    { "not_finite", Jumps.notFinite }, { "not_found", Jumps.notFound }, { "largest", nullptr } };
  if (Jumps.largest)
  {
    const Vec3& at = Jumps.largest->position;
    jumps["largest"] = { { "value", Jumps.largest->jump }, { "position", { at.x, at.y, at.z } },
      { "elements", Cells() }, { "layer", Jumps.largest->layer + 1 } };
  }
}

namespace
{
constexpr std::size_t kCoverages = 4;
constexpr std::size_t kValidities = 3;

std::string TextOf(std::span<const ColorMeaning> legend)
{
  std::vector<std::string> entries;
  for (const ColorMeaning& entry : legend)
  {
    entries.push_back(fmt::format("{}: {}", entry.name, entry.meaning));
  }
  return Listed(entries);
}

/// The validity of visible elements; that of others is left undecided.
std::vector<Validity> VerdictsSeen(const Frame& frame, const Mesh& mesh)
{
  std::vector<Validity> verdicts(static_cast<std::size_t>(mesh.Elements()), Validity::Undecided);
  std::vector<std::int64_t> seen(frame.centres.element);
  for (const SampleBuffers& sheet : frame.centres.behind)
  {
    seen.insert(seen.end(), sheet.element.begin(), sheet.element.end());
  }
  std::ranges::sort(seen);
  seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
  tbb::parallel_for(std::size_t(0), seen.size(),
    [&](std::size_t i)
    {
      if (seen[i] >= 0)
      {
        const auto element = static_cast<int>(seen[i]);
        verdicts[static_cast<std::size_t>(element)] = ValidityOf(mesh, element).validity;
      }
    });
  return verdicts;
}

} // namespace

void DebugOptions::AddTo(CLI::App& added)
{
  Command = &added;
  Bind(added, "--owners", Owners);
  FillHelp(added, "--owners", "legend", TextOf(CoverageColors::Legend()));
  Bind(added, "--show", [this](const std::string& text) { Show = text; });
  FillHelp(added, "--show", "validity", TextOf(ValidityColors::Legend()));
  FillHelp(added, "--show", "jumps", TextOf(JumpColors::Legend()));
  Bind(added, "--enclosures", Enclosures);
}

void DebugOptions::Check(int samples, const std::vector<LayerSettings>& layers) const
{
  if (samples > 1 && NeedsPureColors())
  {
    throw UsageError(
      "--samples mixes colours, and those of --owners, --show and --show-undecided are a legend's; "
      "leave it out");
  }
  if (Owners && Show != "field")
  {
    throw UsageError("--owners and --show " + Show + " paint the same pixels; choose one");
  }
  if (MarksUndecided() && IsInPlace())
  {
    throw UsageError("--show-undecided needs the field's colours; leave out --owners and --show");
  }
  if (IsInPlace())
  {
    CheckEffectsBeside(Owners ? "--owners" : "--show " + Show, *Command, layers);
  }
}

Buffer DebugOptions::Needs() const
{
  return (Owners ? Buffer::Coverage : Buffer::None) |
    (Show == "validity" ? Buffer::Element : Buffer::None) |
    (Show == "jumps" ? NeedsOfCutJumps() : Buffer::None) |
    (Enclosures || MarksUndecided() ? Buffer::Enclosure : Buffer::None);
}

bool DebugOptions::MarksUndecided() const
{
  return IsGiven(*Command, "--show-undecided");
}

void DebugOptions::AddTo(Pipeline& pipeline, const Shot& shot, Frame& frame)
{
  if (Owners)
  {
    InPlace = std::make_shared<CoverageColors>();
  }
  else if (Show == "validity")
  {
    Verdicts = VerdictsSeen(frame, shot.input.model->GetMesh());
    InPlace = std::make_shared<ValidityColors>(Verdicts);
  }
  else if (Show == "jumps")
  {
    Jumps.emplace(shot, frame);
    InPlace = std::make_shared<JumpColors>(Jumps->Largest());
  }
  if (InPlace)
  {
    pipeline.colors = { InPlace.get() };
  }
}

void DebugOptions::Count(const Frame& frame, const UndecidedColors* undecided)
{
  if (Owners)
  {
    CountCoverage(frame);
  }
  if (!Verdicts.empty())
  {
    CountValidity(frame);
  }
  if (undecided != nullptr)
  {
    ColorUndecided = undecided->Count(frame.centres);
  }
  if (Enclosures || MarksUndecided())
  {
    CountEnclosures(frame);
  }
}

std::vector<ColorMeaning> DebugOptions::SeenLegend(const Frame& frame) const
{
  // The last two colours of jumps are the ends of a bar.
  const std::span<const ColorMeaning> legend = Owners ? CoverageColors::Legend()
    : Show == "validity"                              ? ValidityColors::Legend()
    : Show == "jumps"                                 ? JumpColors::Legend().first(2)
                                                      : std::span<const ColorMeaning>();
  std::vector<ColorMeaning> seen;
  const std::vector<std::uint8_t>& image = frame.Image();
  std::ranges::copy_if(legend, std::back_inserter(seen),
    [&image](const ColorMeaning& entry)
    {
      for (std::size_t i = 0; i < image.size(); i += 4)
      {
        if (std::equal(entry.color.begin(), entry.color.end(),
              image.begin() + static_cast<std::ptrdiff_t>(i)))
        {
          return true;
        }
      }
      return false;
    });
  return seen;
}

void DebugOptions::CountValidity(const Frame& frame)
{
  Validities.assign(kValidities, 0);
  for (std::size_t i = 0; i < frame.centres.element.size(); ++i)
  {
    if (frame.centres.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact))
    {
      const auto element = static_cast<std::size_t>(frame.centres.element[i]);
      ++Validities[static_cast<std::size_t>(Verdicts[element])];
    }
  }
}

void DebugOptions::CountCoverage(const Frame& frame)
{
  Coverages.assign(kCoverages, 0);
  for (const std::uint8_t coverage : frame.centres.coverage)
  {
    if (coverage != kNotCovered)
    {
      ++Coverages[coverage];
    }
  }
}

void DebugOptions::CountEnclosures(const Frame& frame)
{
  const SampleBuffers& samples = frame.centres;
  for (std::size_t i = 0; i < samples.valueLower.size(); ++i)
  {
    const double width = samples.valueUpper[i] - samples.valueLower[i];
    if (std::isfinite(width))
    {
      Widest = std::max(Widest, width);
    }
    else if (samples.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact))
    {
      ++Unbounded;
    }
  }
}

void DebugOptions::AddTo(Table& table) const
{
  const auto row = [&table](const char* name, const Counts& counts, const auto& nameOf)
  {
    std::vector<std::string> entries;
    for (std::size_t i = 0; i < counts.size(); ++i)
    {
      entries.push_back(fmt::format("{} {}", counts[i], nameOf(i)));
    }
    if (!counts.empty())
    {
      table.Row(name, Listed(entries));
    }
  };
  row("coverage", Coverages, [](std::size_t i) { return Name(static_cast<Coverage>(i)); });
  row("validity", Validities, [](std::size_t i) { return Name(static_cast<Validity>(i)); });
  if (Jumps)
  {
    Jumps->AddTo(table);
  }
  if (Enclosures || MarksUndecided())
  {
    table.Row("enclosures", "widest {}, {} without bounds", Short(Widest), Unbounded);
  }
  if (MarksUndecided())
  {
    table.Row("colours", "{} undecided", ColorUndecided);
  }
}

void DebugOptions::AddTo(nlohmann::ordered_json& summary) const
{
  const auto add = [&summary](const char* name, const Counts& counts, const auto& nameOf)
  {
    for (std::size_t i = 0; i < counts.size(); ++i)
    {
      summary[name][nameOf(i)] = counts[i];
    }
  };
  add("coverage", Coverages, [](std::size_t i) { return Name(static_cast<Coverage>(i)); });
  add("validity", Validities, [](std::size_t i) { return Name(static_cast<Validity>(i)); });
  if (Jumps)
  {
    Jumps->AddTo(summary);
  }
  if (Enclosures || MarksUndecided())
  {
    summary["enclosures"] = { { "widest", Widest }, { "unbounded", Unbounded } };
  }
  if (MarksUndecided())
  {
    summary["color_undecided"] = ColorUndecided;
  }
}
} // namespace pixelexact
