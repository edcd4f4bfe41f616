// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/Animation.h"

#include "Base/Command.h"
#include "Base/Output.h"
#include "Base/Report.h"
#include "Drawing/ImageFile.h"
#include "Drawing/Video.h"
#include "Picture/AnimationFrames.h"
#include "Picture/DrawnShot.h"
#include "Picture/PictureFile.h"
#include "Picture/Pictures.h"
#include "Picture/RenderOptions.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <utility>

namespace pixelexact
{
namespace
{
using Range = std::array<double, 2>;

constexpr const char* kPictureNames =
  "cut_%04d.png, cut_{frame}.png or cut_{step}.png, or name a video, .mp4 or .webm";
constexpr const char* kBufferNames = "cut_%04d.vti or cut_{frame}.vti";

/// The pictures that were written.
struct Done
{
  std::vector<std::string> files;
  int written = 0;
  int kept = 0;
  int withUnknown = 0;
  std::int64_t unknown = 0;
  std::optional<Range> colors; ///< of the first layer, of all pictures
};

void Count(const DrawnShot& drawn, Done& done)
{
  const std::int64_t unknown = drawn.GetFrame().counters.unknown;
  done.unknown += unknown;
  done.withUnknown += unknown > 0 ? 1 : 0;
  if (const auto& range = drawn.GetAppearance().Ranges().front())
  {
    done.colors = done.colors
      ? Range{ std::min((*done.colors)[0], (*range)[0]), std::max((*done.colors)[1], (*range)[1]) }
      : *range;
  }
}

void RequireDifferent(
  const char* option, const std::string& pattern, const std::vector<std::string>& files)
{
  if (std::set<std::string>(files.begin(), files.end()).size() != files.size())
  {
    throw UsageError(std::string(option) + ": '" + pattern +
      "' gives several pictures one name; number them by {frame}, as cut_{frame}" +
      std::filesystem::path(pattern).extension().string());
  }
}

/// The files of --buffers; none where the option is not given.
class BufferFiles
{
public:
  BufferFiles(const RenderOptions& options, const Pictures& pictures)
    : Options(options)
  {
    if (options.buffers.File().empty())
    {
      return;
    }
    const FrameNames names("--buffers", options.buffers.File(), kBufferNames);
    for (int frame = 0; frame < pictures.Frames(); ++frame)
    {
      Names.push_back(names.Of(frame, pictures.StepOf(frame), pictures.Frames(), pictures.Steps()));
    }
    RequireDifferent("--buffers", options.buffers.File(), Names);
  }

  [[nodiscard]] bool IsThere(int frame) const
  {
    std::error_code ignored;
    return Names.empty() ||
      std::filesystem::is_regular_file(Names[static_cast<std::size_t>(frame)], ignored);
  }

  void Write(int frame, const Shot& shot, const DrawnShot& drawn, Stopwatch& watch) const
  {
    if (!Names.empty())
    {
      const std::string& file = Names[static_cast<std::size_t>(frame)];
      CheckOutput("--buffers", file, Options.shot.input.files);
      WriteAtOnce(file, EncodeBuffersOf(Options, shot, drawn, file));
      watch.Stage("buffers");
    }
  }

private:
  const RenderOptions& Options;
  std::vector<std::string> Names;
};

void WriteFrames(const RenderOptions& options, const CommonOptions& common, Pictures& pictures,
  Stopwatch& watch, Done& done)
{
  const FrameNames names("--output", options.output, kPictureNames);
  const BufferFiles buffers(options, pictures);
  const int frames = pictures.Frames();
  const std::string provenance = ProvenanceOf(options, common);
  const std::string source = DescribeFiles(options.shot.input.files);
  std::vector<bool> there;
  for (int frame = 0; frame < frames; ++frame)
  {
    done.files.push_back(names.Of(frame, pictures.StepOf(frame), frames, pictures.Steps()));
    there.push_back(options.animation.Resumes() && buffers.IsThere(frame) &&
      IsThere(done.files.back(), HashOf(provenance, frame, frames)));
  }
  RequireDifferent("--output", options.output, done.files);
  done.kept = static_cast<int>(std::ranges::count(there, true));
  if (done.kept < frames && options.shot.SpansAllPictures())
  {
    pictures.FindValues();
  }
  const FrameProgress progress("picture", frames);
  for (int frame = 0; frame < frames; ++frame)
  {
    progress.Tell(frame, done.written);
    const std::string& file = done.files[static_cast<std::size_t>(frame)];
    if (there[static_cast<std::size_t>(frame)])
    {
      continue;
    }
    CheckOutput("--output", file, options.shot.input.files);
    const Shot& shot = pictures.At(frame);
    Frame traced = TraceShot(options, shot, {});
    watch.Stage("rays");
    const DrawnShot drawn(options, shot, std::move(traced), IsVector(FormatOf("--output", file)));
    watch.Stage("colours");
    // Buffers are written first, so that a complete picture shows --resume that both exist.
    buffers.Write(frame, shot, drawn, watch);
    WriteAtOnce(file,
      EncodePicture(options, drawn, file, { common.words, shot.chosen }, watch,
        { { "Provenance", HashOf(provenance, frame, frames) },
          { "Frame", fmt::format("{} of {}", frame, frames) }, { kSourceText, source } }));
    watch.Stage("write");
    Count(drawn, done);
    ++done.written;
  }
}

void WriteVideo(const RenderOptions& options, Pictures& pictures, Stopwatch& watch, Done& done)
{
  if (options.shot.SpansAllPictures())
  {
    pictures.FindValues();
  }
  const auto& layout = pictures.Current().layout;
  const ImageSize size = layout ? layout->size : options.shot.size;
  const BufferFiles buffers(options, pictures);
  Video video(options.output, size.width, size.height, options.animation.FramesPerSecond());
  const FrameProgress progress("picture", pictures.Frames());
  for (int frame = 0; frame < pictures.Frames(); ++frame)
  {
    progress.Tell(frame, frame);
    const Shot& shot = pictures.At(frame);
    Frame traced = TraceShot(options, shot, {});
    watch.Stage("rays");
    const DrawnShot drawn(options, shot, std::move(traced));
    watch.Stage("colours");
    buffers.Write(frame, shot, drawn, watch);
    const Image picture = drawn.Picture();
    watch.Stage("figure");
    video.Add(picture);
    watch.Stage("video");
    Count(drawn, done);
    ++done.written;
  }
  video.Close();
  done.files.push_back(options.output);
  watch.Stage("video");
}

void Tell(const Pictures& pictures, const Done& done, const RepeatedCommand& command,
  const CommonOptions& common, const Stopwatch& watch)
{
  if (common.json)
  {
    nlohmann::ordered_json summary{ { "elements",
                                      pictures.Current().input.model->GetMesh().Elements() },
      { "frames", pictures.Frames() }, { "written", done.written }, { "kept", done.kept },
      { "read", pictures.TimesRead() }, { "locators", pictures.Located() },
      { "unknown", done.unknown },
      { "color_range", done.colors ? nlohmann::ordered_json(*done.colors) : nullptr },
      { "files", done.files }, { "command", command.Words() }, { "seconds", ToJson(watch) } };
    Print(summary);
    return;
  }
  Table table;
  table.Row("elements", "{}", pictures.Current().input.model->GetMesh().Elements());
  table.Row("pictures", "{} written, {} kept of {}", done.written, done.kept, pictures.Frames());
  table.Row("input", "read {}, {}", Counted(pictures.TimesRead(), "time"),
    Counted(pictures.Located(), "locator"));
  if (done.colors)
  {
    table.Row("range", "{} to {}", Short((*done.colors)[0]), Short((*done.colors)[1]));
  }
  AddStages(table, watch);
  table.Row("repeat", command.Text());
  table.Print();
}
} // namespace

void RenderAnimation(RenderOptions options, const CommonOptions& common)
{
  const bool video = IsVideo(options.output);
  if (!options.lines.file.empty())
  {
    throw UsageError("--contours-output: an animation writes no lines; leave it out");
  }
  if (options.output.empty() || IsStandardStream(options.output))
  {
    throw UsageError("--output: an animation needs names, such as cut_%04d.png, cut_{step}.png or "
                     "cut.mp4");
  }
  if (video)
  {
    if (options.animation.Resumes())
    {
      throw UsageError("--resume: a video is made as a whole; number pictures, as cut_%04d.png");
    }
    if (options.shot.colors.BackgroundColor()[3] == 0)
    {
      throw UsageError("--background none: a video is not transparent; number pictures, as "
                       "cut_%04d.png");
    }
    Video::RequireProgram();
    CheckOutput("--output", options.output, options.shot.input.files);
  }
  if (const std::string& buffers = options.buffers.File(); !buffers.empty())
  {
    FrameNames("--buffers", buffers, kBufferNames);
  }
  if (options.animation.Sweeps())
  {
    options.shot.surfaces.AddFirst(options.animation.PlaneAt(0));
  }
  options.Check(
    video ? "picture.png" : FrameNames("--output", options.output, kPictureNames).Of(0, 0, 1, 1));
  Stopwatch watch;
  Pictures pictures(options, watch);
  Done done;
  if (video)
  {
    WriteVideo(options, pictures, watch, done);
  }
  else
  {
    WriteFrames(options, common, pictures, watch, done);
  }
  if (done.unknown > 0)
  {
    Warn(Counted(done.unknown, "pixel") + " in " + Counted(done.withUnknown, "picture") +
      " could not be decided; shown as unknown");
  }
  Tell(pictures, done, { common.words, pictures.Current().chosen }, common, watch);
}
} // namespace pixelexact
