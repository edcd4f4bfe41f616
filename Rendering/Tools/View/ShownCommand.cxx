// SPDX-License-Identifier: BSD-3-Clause
#include "View/ShownCommand.h"

#include "Base/Command.h"
#include "Base/CommandWords.h"
#include "Base/Options.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace pixelexact
{
namespace
{
/// Smallest cosine between the normal of a flat cut and an oblique direction of view.
constexpr double kMinCosine = 0.4;

bool Has(const std::vector<std::string>& words, const char* option)
{
  return std::ranges::find(words, option, OptionOf) != words.end();
}

/// Throws UsageError for options of several pictures and of coarse ones, and notes those that only
/// saved figures have.
void CheckForWindow(const RenderOptions& options)
{
  if (options.animation.IsAsked(options.shot.input))
  {
    throw UsageError("view shows one picture; leave out --sweep, --turn and --time-step all");
  }
  if (options.quality.Stride() > 1)
  {
    throw UsageError("view draws coarse pictures while it is moved, and then all pixels; leave out "
                     "--stride");
  }
  std::vector<std::string> names;
  for (const char* name : { "--owners", "--show", "--mark-extremes", "--buffers",
         "--contours-output", "--arrows", "--lic", "--dots" })
  {
    if (IsGiven(*options.shot.command, name))
    {
      names.emplace_back(name);
    }
  }
  if (!names.empty())
  {
    Note(Listed(names) + ": in saved figures (key s), not in the window");
  }
}

/// Mirrors a view that sees a flat cut from its edge at a plane through the middle of the mesh's
/// box, so that the box is seen as before. One of the four views from above shows the cut.
CameraView ShowingFlat(const CameraView& view, const Vec3& normal, const Box3& box)
{
  const Vec3 middle = 0.5 * (box.lower + box.upper);
  for (const Vec3& sign : { Vec3(1.0), Vec3(1.0, -1.0, 1.0), Vec3(-1.0, 1.0, 1.0) })
  {
    CameraView mirrored = view;
    mirrored.position = middle + sign * (view.position - middle);
    mirrored.focalPoint = middle + sign * (view.focalPoint - middle);
    mirrored.viewUp = sign * view.viewUp;
    const Vec3 towards = glm::normalize(mirrored.position - mirrored.focalPoint);
    if (std::fabs(glm::dot(towards, normal)) >= kMinCosine)
    {
      return mirrored;
    }
  }
  return view;
}
} // namespace

void ShownState::Set(const std::string& option, const std::optional<std::string>& value)
{
  const auto first = std::ranges::find(words, option, OptionOf);
  if (!value)
  {
    std::erase_if(words, [&option](const std::string& word) { return OptionOf(word) == option; });
  }
  else if (std::string word = fmt::format("{}={}", option, *value); first != words.end())
  {
    *first = std::move(word);
  }
  else
  {
    words.insert(std::ranges::find(words, "--"), std::move(word));
  }
}

void ShownState::ForgetRange()
{
  now.range.reset();
  std::erase_if(words,
    [](const std::string& word)
    {
      return OptionOf(word) == "--range" &&
        ReadRange("--range", word.substr(word.find('=') + 1), ',').of == RangeRule::Of::Ends;
    });
}

struct ShownCommand::Parsed
{
  RenderOptions options;
  std::shared_ptr<CLI::App> program; ///< that the options refer to
};

ShownCommand::ShownCommand(std::vector<std::string> words, const ImageSize& largest)
{
  State_.words = std::move(words);
  CheckForWindow(Parse(State_.words)->options);
  const bool isViewGiven = Has(State_.words, "--view") || Has(State_.words, "--camera-position");
  if (!isViewGiven)
  {
    State_.Set("--view", "iso");
  }
  if (!Has(State_.words, "--size"))
  {
    State_.Set("--size", fmt::format("{}x{}", largest.width, largest.height));
  }
  if (!Has(State_.words, "--mesh-outline"))
  {
    State_.Set("--mesh-outline", "box");
  }
  Parsed_ = Parse(State_.words);
  const RenderOptions& options = Options();
  Output = options.output;
  options.shot.camera.Check();
  options.shot.colors.Check();
  LoadedModel input = LoadModel(options.shot.input, {}, Watch);
  WarnOfDiagnostics(input);
  shot_ = Prepare(options.OfPicture(), std::move(input), Watch);
  if (const Surface& first = *shot_.scene.layers.front().surface; !isViewGiven && first.IsFlat())
  {
    shot_.view = ShowingFlat(shot_.view, first.Normal({}), BoxOf(*shot_.input.model));
    LayOut();
  }
  for (std::size_t k = 0; k < shot_.chosen.size(); ++k)
  {
    const std::string& word = shot_.chosen[k];
    const bool isPair = word.find('=') == std::string::npos && k + 1 < shot_.chosen.size() &&
      !shot_.chosen[k + 1].starts_with("--");
    State_.words.insert(std::ranges::find(State_.words, "--"),
      isPair ? fmt::format("{}={}", word, shot_.chosen[k + 1]) : word);
    k += isPair ? 1 : 0;
  }
  State_.now.view = shot_.view;
  State_.now.contours = options.contours.AreGiven();
  State_.now.edges = shot_.appearance.edges.has_value();
  if (!shot_.input.times.empty())
  {
    State_.now.step = shot_.input.step;
  }
}

ShownCommand::~ShownCommand() = default;

const RenderOptions& ShownCommand::Options() const
{
  return Parsed_->options;
}

std::unique_ptr<ShownCommand::Parsed> ShownCommand::Parse(
  const std::vector<std::string>& words) const
{
  auto parsed = std::make_unique<Parsed>();
  RenderOptions& options = parsed->options;
  CommonOptions ignored;
  parsed->program = ParseCommand(words,
    [&](CLI::App& command)
    {
      options.AddTo(command);
      AddCommonOptions(command, ignored);
    });
  options.Check(options.output.empty()
      ? std::filesystem::path(options.shot.input.files.front()).stem().string() + ".png"
      : options.output);
  // The window draws as many samples as are given, the saved figure the number of figures.
  if (!IsGiven(*options.shot.command, "--samples"))
  {
    options.shot.samples = 1;
  }
  options.figure.Ask();
  options.figure.Check(options.shot.size);
  return parsed;
}

void ShownCommand::Take(ShownState state)
{
  state.now.output = NameOfFile(0);
  auto parsed = Parse(WordsOf(state.now, state.words, {}, std::to_string(kDefaultContours)));
  const ShotOptions asked = parsed->options.OfPicture();
  const bool isSameStep = asked.input.step.value_or(shot_.input.step) == shot_.input.step;
  Shot next = Prepare(asked,
    isSameStep ? Changed(shot_.input, asked.input)
               : LoadModel(asked.input, {}, Watch, shot_.input.source),
    Watch);
  shot_ = std::move(next);
  Parsed_ = std::move(parsed);
  State_ = std::move(state);
  State_.now.view = shot_.view;
}

void ShownCommand::Resize(int width, int height)
{
  State_.Set("--size", fmt::format("{}x{}", width, height));
  RenderOptions& options = Parsed_->options;
  options.shot.size = { width, height, {} };
  LayOut();
}

bool ShownCommand::LayOut()
{
  const FigureLayout layout = Options().figure.LayOut(Options().shot.size, shot_, false);
  const bool isNew = layout.corner != shot_.layout->corner ||
    layout.picture.width != shot_.size.width || layout.picture.height != shot_.size.height;
  shot_.layout = layout;
  shot_.size = layout.picture;
  return isNew;
}

std::string ShownCommand::NameOfFile(int number) const
{
  if (Output.empty())
  {
    return fmt::format("{}_view_{}.png",
      std::filesystem::path(Options().shot.input.files.front()).stem().string(), number);
  }
  const std::filesystem::path given(Output);
  return number == 0
    ? Output
    : (given.parent_path() /
        fmt::format("{}_{}{}", given.stem().string(), number, given.extension().string()))
        .string();
}

std::string ShownCommand::NextName()
{
  while (Output.empty() && std::filesystem::exists(NameOfFile(Saved)))
  {
    ++Saved;
  }
  return NameOfFile(Saved);
}

std::vector<std::string> ShownCommand::FigureWords(const std::string& output) const
{
  ShownNow now = State_.now;
  now.output = output;
  std::vector<std::string> words = WordsOf(now, State_.words, {}, std::to_string(kDefaultContours));
  if (!Has(words, "--figure"))
  {
    words.insert(words.end() - 1, "--figure");
  }
  return words;
}
} // namespace pixelexact
