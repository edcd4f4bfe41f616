// SPDX-License-Identifier: BSD-3-Clause
#include "Animation.h"

#include "Command.h"
#include "DrawnShot.h"
#include "FrameNames.h"
#include "ImageFile.h"
#include "Output.h"
#include "Picture.h"
#include "PictureFile.h"
#include "Projection.h"
#include "RenderOptions.h"
#include "Report.h"
#include "Video.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Trace/Surfaces/Plane.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <sstream>

namespace pixelexact
{
namespace
{
/// Of a sweep, for the view that sees all of it: so many places.
constexpr int kPlaces = 12;

using Range = std::array<double, 2>;

/// How many pictures are done, and how long the rest will take, on stderr where that is a terminal.
class FrameProgress
{
public:
  FrameProgress(std::string what, int frames)
    : What(std::move(what))
    , Frames(frames)
  {
  }
  ~FrameProgress()
  {
    if (Terminal)
    {
      std::cerr << "\r\033[K" << std::flush;
    }
  }
  FrameProgress(const FrameProgress&) = delete;
  FrameProgress& operator=(const FrameProgress&) = delete;

  /// `made`: of those done, the ones that took time.
  void Tell(int done, int made) const
  {
    if (!Terminal)
    {
      return;
    }
    std::cerr << fmt::format("\r\033[K{} {} of {}", What, done + 1, Frames);
    if (made > 0)
    {
      const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - Begin;
      const double left = passed.count() / made * (Frames - done);
      std::cerr << (left < 90.0 ? fmt::format(", {:.0f} s left", left)
                                : fmt::format(", {:.0f} min left", left / 60.0));
    }
    std::cerr << std::flush;
  }

private:
  std::string What;
  int Frames;
  bool Terminal = isatty(STDERR_FILENO) != 0;
  std::chrono::steady_clock::time_point Begin = std::chrono::steady_clock::now();
};

/// The pictures, one after the other.
class Pictures
{
public:
  Pictures(const RenderOptions& options, Stopwatch& watch)
    : Options(options)
    , Watch(watch)
    , Asked(options.OfPicture())
  {
    const AnimationOptions& animation = Options.animation;
    Asked.alsoSeen = [&animation, outlined = Asked.alsoSeen](const Shot& shot)
    { return SeenOfAll(animation, shot, outlined); };
    Now.emplace(Prepare(Asked, Watch));
    ++Reads;
    First = Now->view;
    Pivot = Pivoted();
    const auto steps = static_cast<int>(Now->input.times.size());
    const bool all = Options.shot.input.allSteps;
    Count = animation.Frames().value_or(steps);
    if (all && (steps == 0 || Count != steps))
    {
      throw Error(steps == 0
          ? "--time-step all: '" + Options.shot.input.files[0] + "' has no time steps"
          : fmt::format("--time-step all: there are {} time steps, and {} pictures of --sweep or "
                        "--turn; give as many",
              steps, Count));
    }
  }

  [[nodiscard]] int Frames() const { return Count; }
  [[nodiscard]] int StepOf(int frame) const
  {
    return Options.shot.input.allSteps ? frame : Now->input.step;
  }
  [[nodiscard]] int Steps() const { return static_cast<int>(Now->input.times.size()); }
  [[nodiscard]] std::int64_t TimesRead() const { return Reads; }
  [[nodiscard]] std::int64_t Located() const { return Locators; }
  [[nodiscard]] const Shot& Current() const { return *Now; }

  /// Where everything is at a picture.
  const Shot& At(int frame)
  {
    if (StepOf(frame) != Now->input.step)
    {
      const Shot before = std::move(*Now);
      Now.emplace(PrepareStep(Asked, StepOf(frame), before, Watch));
      ++Reads;
    }
    Shot& shot = *Now;
    // The one before is held while another is made: they differ in their addresses.
    Locators += shot.scene.locator != Latest ? 1 : 0;
    Latest = shot.scene.locator;
    shot.valuesOfAll = Values;
    if (Options.animation.Sweeps())
    {
      shot.scene.layers.front().surface =
        std::make_shared<Plane>(Options.animation.PlaneAt(frame).Make(BoxOf(*shot.input.model)));
    }
    shot.view = Options.animation.ViewAt(frame, First, Pivot);
    return shot;
  }

  /// Finds what --range all spans.
  void FindValues()
  {
    const FrameProgress progress("values of picture", Count);
    const double lowest =
      Options.shot.colors.Logarithm() ? 0.0 : -std::numeric_limits<double>::infinity();
    std::vector<std::optional<Range>> found(Now->scene.layers.size());
    for (int frame = 0; frame < Count; ++frame)
    {
      progress.Tell(frame, frame);
      const Shot& shot = At(frame);
      const Frame traced = TraceShot(Options, shot, {});
      Watch.Stage("values of all");
      for (std::size_t k = 0; k < found.size(); ++k)
      {
        if (const auto here = ValueRange(traced, lowest, LayersAlike(shot, k)))
        {
          found[k] = found[k]
            ? Range{ std::min((*found[k])[0], (*here)[0]), std::max((*found[k])[1], (*here)[1]) }
            : *here;
        }
      }
    }
    Values = found;
  }

private:
  static std::vector<bool> LayersAlike(const Shot& shot, std::size_t layer)
  {
    const std::vector<Layer>& layers = shot.scene.layers;
    std::vector<bool> alike;
    alike.reserve(layers.size());
    for (const Layer& other : layers)
    {
      alike.push_back(
        other.field == layers[layer].field && other.component == layers[layer].component);
    }
    return alike;
  }

  [[nodiscard]] Vec3 Pivoted() const
  {
    const Box3 box = BoxOf(*Now->input.model);
    return Options.shot.camera.IsPlaced() ? First.focalPoint : 0.5 * (box.lower + box.upper);
  }

  /// What is seen of places along the sweep, as if the camera stood still and all else turned.
  static std::vector<Vec3> SeenOfAll(const AnimationOptions& animation, const Shot& shot,
    const std::function<std::vector<Vec3>(const Shot&)>& outlined)
  {
    std::vector<Vec3> points = SeenPoints(shot.scene, shot.view, shot.size);
    if (outlined)
    {
      std::ranges::copy(outlined(shot), std::back_inserter(points));
    }
    const int frames = animation.Frames().value_or(1);
    const Box3 box = BoxOf(*shot.input.model);
    const int places = animation.Sweeps() ? std::min(frames, kPlaces) : 0;
    for (int k = 0; k < places; ++k)
    {
      const int frame =
        static_cast<int>(std::int64_t{ k } * (frames - 1) / std::max(1, places - 1));
      Scene scene = shot.scene;
      scene.layers.front().surface = std::make_shared<Plane>(animation.PlaneAt(frame).Make(box));
      std::ranges::copy(SeenPoints(scene, shot.view, shot.size), std::back_inserter(points));
    }
    if (!animation.Turns())
    {
      return points;
    }
    const Vec3 pivot = 0.5 * (box.lower + box.upper);
    std::vector<Vec3> turned;
    for (int k = 0; k < std::min(frames, 8 * kPlaces); ++k)
    {
      const int frame =
        static_cast<int>(std::int64_t{ k } * frames / std::min(frames, 8 * kPlaces));
      const CameraView view = animation.ViewAt(frame, shot.view, pivot);
      const Projection from(view, shot.size.width, shot.size.height);
      for (const Vec3& point : points)
      {
        turned.push_back(from.AsSeenFrom(shot.view, point));
      }
    }
    return turned;
  }

  const RenderOptions& Options;
  Stopwatch& Watch;
  ShotOptions Asked;
  std::optional<Shot> Now;
  CameraView First;
  Vec3 Pivot{ 0.0 };
  int Count = 0;
  std::vector<std::optional<Range>> Values;
  std::int64_t Reads = 0;
  const Locator* Latest = nullptr;
  std::int64_t Locators = 0;
};

/// What pictures are made of: the inputs, this program, and the words that change them.
std::string ProvenanceOf(const RenderOptions& options, const CommonOptions& common)
{
  std::string all = DescribeFiles(WithFilesBehind(options.shot.input.files)) + '\n' + kPictureMark;
  for (std::size_t i = 0; i < common.words.size(); ++i)
  {
    const std::string& word = common.words[i];
    const bool takesOne = word == "--threads" || word == "-o" || word == "--output";
    const bool joined = word.starts_with("--threads=") || word.starts_with("--output=");
    if (word != "--resume" && word != "--json" && word != "--quiet" && word != "-q" && !takesOne &&
      !joined)
    {
      all += '\n' + word;
      // A font, a colour map or a surface may be another one under the same name.
      const std::string value = word.substr(word.starts_with("--") ? word.find('=') + 1 : 0);
      for (const std::string& file : { value, value.substr(0, value.rfind(':')) })
      {
        std::error_code ignored;
        if (std::filesystem::is_regular_file(file, ignored))
        {
          all += '\n' + DescribeFiles({ file });
          break;
        }
      }
    }
    i += takesOne ? 1 : 0;
  }
  return all;
}

std::string HashOf(const std::string& provenance, int frame, int frames)
{
  const std::string text = fmt::format("{}\n{} of {}", provenance, frame, frames);
  return fmt::format("{:016x}", XXH3_64bits(text.data(), text.size()));
}

bool IsThere(const std::string& file, const std::string& hash)
{
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return stream && text.str().find(hash) != std::string::npos;
}

/// What was done.
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
  if (const auto& range = drawn.GetLooks().Ranges().front())
  {
    done.colors = done.colors
      ? Range{ std::min((*done.colors)[0], (*range)[0]), std::max((*done.colors)[1], (*range)[1]) }
      : *range;
  }
}

void WriteFrames(const RenderOptions& options, const CommonOptions& common, Pictures& pictures,
  Stopwatch& watch, Done& done)
{
  const FrameNames names(options.output);
  const int frames = pictures.Frames();
  const std::string provenance = ProvenanceOf(options, common);
  const std::string source = DescribeFiles(options.shot.input.files);
  std::vector<bool> there;
  for (int frame = 0; frame < frames; ++frame)
  {
    done.files.push_back(names.Of(frame, pictures.StepOf(frame), frames, pictures.Steps()));
    there.push_back(
      options.animation.Resumes() && IsThere(done.files.back(), HashOf(provenance, frame, frames)));
  }
  if (std::set<std::string>(done.files.begin(), done.files.end()).size() != done.files.size())
  {
    throw UsageError("--output: '" + options.output +
      "' gives several pictures one name; number them by {frame}, as cut_{frame}.png");
  }
  done.kept = static_cast<int>(std::ranges::count(there, true));
  if (done.kept < frames && options.shot.colors.Range().of == RangeChoice::Of::All)
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
    const DrawnShot drawn(
      options, shot, TraceShot(options, shot, {}), IsVector(FormatOf("--output", file)));
    WriteAtOnce(file,
      EncodePicture(options, drawn, file, { common.words, shot.chosen },
        { { "Provenance", HashOf(provenance, frame, frames) },
          { "Frame", fmt::format("{} of {}", frame, frames) }, { kSourceText, source } }));
    Count(drawn, done);
    ++done.written;
    watch.Stage("pictures");
  }
}

void WriteVideo(const RenderOptions& options, Pictures& pictures, Stopwatch& watch, Done& done)
{
  if (options.shot.colors.Range().of == RangeChoice::Of::All)
  {
    pictures.FindValues();
  }
  const ImageSize& size = options.shot.size;
  Video video(options.output, size.width, size.height, options.animation.FramesPerSecond());
  const FrameProgress progress("picture", pictures.Frames());
  for (int frame = 0; frame < pictures.Frames(); ++frame)
  {
    progress.Tell(frame, frame);
    const Shot& shot = pictures.At(frame);
    const DrawnShot drawn(options, shot, TraceShot(options, shot, {}));
    video.Add(drawn.Picture());
    Count(drawn, done);
    ++done.written;
    watch.Stage("pictures");
  }
  video.Close();
  done.files.push_back(options.output);
  watch.Stage("video");
}

/// Seconds of stages, all that have one name together.
nlohmann::ordered_json SumsOf(const Stopwatch& watch)
{
  auto sums = nlohmann::ordered_json::object();
  for (const auto& [stage, seconds] : watch.Stages())
  {
    sums[stage] = sums.value(stage, 0.0) + seconds;
  }
  return sums;
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
      { "files", done.files }, { "command", command.Words() }, { "seconds", SumsOf(watch) } };
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
  std::string name = "seconds";
  const nlohmann::ordered_json sums = SumsOf(watch);
  for (const auto& [stage, seconds] : sums.items())
  {
    table.Row(name, "{} {}", Short(seconds.get<double>()), stage);
    name.clear();
  }
  table.Row("repeat", command.Text());
  table.Print();
}
} // namespace

void RenderAnimation(RenderOptions options, const CommonOptions& common)
{
  const bool video = IsVideo(options.output);
  if (!options.buffers.File().empty() || !options.lines.file.empty())
  {
    throw UsageError(
      (options.buffers.File().empty() ? std::string("--contours-output") : "--buffers") +
      ": an animation writes pictures alone; leave it out");
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
  if (options.animation.Sweeps())
  {
    options.shot.surfaces.AddFirst(options.animation.PlaneAt(0));
  }
  options.Check(video ? "picture.png" : FrameNames(options.output).Of(0, 0, 1, 1));
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
