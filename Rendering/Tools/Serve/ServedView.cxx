// SPDX-License-Identifier: BSD-3-Clause
#include "Serve/ServedView.h"

#include "Base/Command.h"
#include "Base/Report.h"
#include "Picture/CameraMoves.h"
#include "Picture/DrawnShot.h"
#include "Picture/PictureFile.h"
#include "Serve/PageWords.h"
#include "Serve/ServedInput.h"
#include "Serve/ServedMessages.h"

#include "Core/Base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <iterator>
#include <utility>

namespace pixelexact
{
namespace
{
/// Time of tracing of a coarse picture.
constexpr double kCoarseSeconds = 0.03;
/// Radians and parts of the image's height of one message.
constexpr double kMaxMove = 10.0;
constexpr double kMaxZoom = 100.0;

/// Two finite numbers of at most `limit`; none: the value is no such array.
std::optional<std::array<double, 2>> TwoNumbers(const nlohmann::json& value, double limit)
{
  if (!value.is_array() || value.size() != 2 || !value[0].is_number() || !value[1].is_number())
  {
    return std::nullopt;
  }
  const std::array numbers{ value[0].get<double>(), value[1].get<double>() };
  const bool isValid =
    std::ranges::all_of(numbers, [limit](double x) { return std::fabs(x) <= limit; });
  return isValid ? std::optional(numbers) : std::nullopt;
}

/// Words of cameras, which ServedView::Eye replaces.
bool IsOfCamera(const std::string& word)
{
  const std::string name = OptionOf(word);
  return name == "--view" || name == "--camera-position" || name == "--focal-point" ||
    name == "--view-up" || name == "--view-angle" || name == "--parallel-scale";
}

[[noreturn]] void RefuseMember(const std::string& name)
{
  throw UsageError("the message's member '" + name + "' is invalid");
}
} // namespace

ServedView::ServedView(
  std::vector<std::string> words, std::shared_ptr<Outbox> outbox, std::function<void()> changed)
  : Browser(std::move(outbox))
  , Wake(std::move(changed))
  , Words(std::move(words))
  , Given(Words)
{
  Good = Words;
  std::erase_if(Good, IsOfCamera);
  Coarse = std::make_unique<Renderer>(Counters);
  Probe = std::make_unique<Renderer>(Counters);
}

ServedView::~ServedView() = default;

bool ServedView::Post(const std::string& text)
{
  nlohmann::json message = nlohmann::json::parse(text, nullptr, false);
  if (message.is_discarded() || !message.is_object())
  {
    return false;
  }
  {
    const std::lock_guard lock(Mutex);
    if (Waiting.size() >= kMaxWaiting)
    {
      return false;
    }
    Waiting.push_back(std::move(message));
  }
  Wake();
  return true;
}

std::pair<ServedView::Work, ServedView::Clock::time_point> ServedView::Next()
{
  const std::lock_guard lock(Mutex);
  if (!Waiting.empty())
  {
    return { Work::Change, Clock::time_point::min() };
  }
  return ExactDue ? std::pair{ Work::Exact, *ExactDue }
                  : std::pair{ Work::Nothing, Clock::time_point::max() };
}

bool ServedView::IsInterrupted()
{
  const auto changes = [](const nlohmann::json& message)
  {
    return std::ranges::any_of(message.items(),
      [](const auto& member)
      { return member.key() != "hover" && member.key() != "still" && member.key() != "save"; });
  };
  const std::lock_guard lock(Mutex);
  return Left || std::ranges::any_of(Waiting, changes);
}

void ServedView::Changed(bool atOnce)
{
  Stale = true;
  const std::lock_guard lock(Mutex);
  ExactDue = Clock::now() + (atOnce ? Clock::duration::zero() : Clock::duration(kPause));
}

void ServedView::Perform(ServedInput& input, const std::function<bool()>& othersWait)
{
  std::deque<nlohmann::json> messages;
  {
    const std::lock_guard lock(Mutex);
    messages.swap(Waiting);
  }
  try
  {
    for (const nlohmann::json& message : messages)
    {
      Handle(message, input);
    }
    if (Stale)
    {
      Update(input);
    }
    for (const std::string& suffix : std::exchange(Saves, {}))
    {
      Save(suffix, input);
    }
    if (HoverAt)
    {
      Hover(*std::exchange(HoverAt, std::nullopt));
    }
    if (Next().first == Work::Exact && Next().second <= Clock::now())
    {
      DrawExact(othersWait);
    }
  }
  catch (const std::exception& error)
  {
    SendFailure(error.what());
  }
}

void ServedView::SendFailure(const std::string& text)
{
  // The page shows the last picture that could be drawn, and its settings.
  const bool draws = Words != Good;
  Words = Good;
  Fits = Fits && !Shown;
  Range.reset();
  Saves.clear();
  HoverAt.reset();
  if (draws)
  {
    Changed(true);
  }
  else if (Stale)
  {
    const std::lock_guard lock(Mutex);
    ExactDue.reset();
  }
  Browser->SendText(
    TextMessage({ { "kind", "failure" }, { "text", text }, { "options", OptionsOf(Words) } }));
}

void ServedView::Handle(const nlohmann::json& message, ServedInput& /*input*/)
{
  HandleMove(message);
  if (message.contains("set"))
  {
    SetOptions(message["set"]);
  }
  if (message.contains("view"))
  {
    if (!message["view"].is_string())
    {
      RefuseMember("view");
    }
    SetView(message["view"].get<std::string>());
  }
  if (message.contains("size"))
  {
    SetSize(message["size"]);
  }
  if (message.contains("hover"))
  {
    const auto at = TwoNumbers(message["hover"], kMaxSide);
    if (!at)
    {
      RefuseMember("hover");
    }
    HoverAt = { static_cast<int>((*at)[0]), static_cast<int>((*at)[1]) };
  }
  if (message.contains("save"))
  {
    if (!message["save"].is_string())
    {
      RefuseMember("save");
    }
    Saves.push_back(message["save"].get<std::string>());
  }
  if (message.contains("still"))
  {
    const std::lock_guard lock(Mutex);
    ExactDue = ExactDue ? std::optional(Clock::now()) : ExactDue;
  }
}

void ServedView::HandleMove(const nlohmann::json& message)
{
  CameraView moved = Eye;
  // A camera that is not yet fitted cannot be moved.
  for (const char* name : { "turn", "move" })
  {
    if (!message.contains(name))
    {
      continue;
    }
    const auto by = TwoNumbers(message[name], kMaxMove);
    if (!by)
    {
      RefuseMember(name);
    }
    moved = std::string_view(name) == "turn" ? Turned(moved, (*by)[0], (*by)[1])
                                             : Moved(moved, (*by)[0], (*by)[1]);
  }
  if (message.contains("zoom"))
  {
    const auto& factor = message["zoom"];
    if (!factor.is_number() || !(factor.get<double>() >= 1.0 / kMaxZoom) ||
      !(factor.get<double>() <= kMaxZoom))
    {
      RefuseMember("zoom");
    }
    moved = Zoomed(moved, factor.get<double>());
  }
  if (Shown && !(moved == Eye))
  {
    (void)Camera(moved, 1, 1); // throws Error where it is no camera
    Eye = moved;
    Changed(false);
  }
}

void ServedView::SetOptions(const nlohmann::json& options)
{
  if (!options.is_object())
  {
    RefuseMember("set");
  }
  std::vector<std::string> words = Words;
  for (const auto& [name, value] : options.items())
  {
    if (!value.is_null() && !value.is_string() && !(value.is_boolean() && value.get<bool>()))
    {
      RefuseMember("set");
    }
    words = WithOption(words, name,
      value.is_null() ? std::nullopt
                      : std::optional(value.is_string() ? value.get<std::string>() : "true"));
    if (name == "--field" || name == "--component" || name == "--range" || name == "--log")
    {
      Range.reset();
    }
  }
  Words = std::move(words);
  Changed(false);
}

void ServedView::SetView(const std::string& name)
{
  std::erase_if(Words, IsOfCamera);
  const auto end = std::ranges::find(Words, "--");
  if (name == "fit")
  {
    std::vector<std::string> camera;
    std::ranges::copy_if(Given, std::back_inserter(camera), IsOfCamera);
    Words.insert(end, camera.begin(), camera.end());
  }
  else
  {
    Words.insert(end, "--view=" + name);
  }
  Fits = true;
  Changed(true);
}

void ServedView::SetSize(const nlohmann::json& size)
{
  const auto given = TwoNumbers(size, kMaxSide);
  if (!given || (*given)[0] < kMinSide || (*given)[1] < kMinSide ||
    (*given)[0] * (*given)[1] > kMaxPixels)
  {
    throw UsageError(fmt::format("a page's picture has sides of {} to {} and at most {} pixels",
      kMinSide, kMaxSide, kMaxPixels));
  }
  std::erase_if(Words, [](const std::string& word) { return OptionOf(word) == "--size"; });
  Words.insert(std::ranges::find(Words, "--"),
    fmt::format("--size={}x{}", static_cast<int>((*given)[0]), static_cast<int>((*given)[1])));
  Changed(true);
}

std::vector<std::string> ServedView::Command(const std::string& output) const
{
  const auto has = [this](const char* option)
  { return std::ranges::find(Words, option, OptionOf) != Words.end(); };
  ShownNow now;
  now.view = Eye;
  now.range = Range;
  now.contours = has("--contours");
  now.edges = has("--edges");
  now.output = output;
  return WordsOf(now, Words, {}, {});
}

void ServedView::Update(ServedInput& input)
{
  // The renderer holds parts of the scene, so it forgets them first.
  Coarse->DropFrame();
  Probe->DropFrame();
  const std::string picture = "view.png";
  Shown =
    std::make_unique<ServedScene>(WithoutFigure(Fits ? Words : Command(picture)), picture, input);
  if (Fits)
  {
    Eye = Shown->GetShot().view;
    std::erase_if(Words, IsOfCamera);
    Fits = false;
    // The words of the camera give the same one up to rounding; pictures are those of the words.
    Shown = std::make_unique<ServedScene>(WithoutFigure(Command(picture)), picture, input);
  }
  Stale = false;
  DrawCoarse();
}

void ServedView::DrawCoarse()
{
  const RenderOptions& options = Shown->GetOptions();
  View view = ViewOf(options.shot.colors, nullptr, Shown->GetShot());
  view.appearance.edges.reset();
  view.appearance.outlines.reset();
  view.appearance.samples = 1;
  RenderWork work;
  work.seconds = kCoarseSeconds;
  const Frame& frame = Coarse->Render(view, work);
  Browser->SendFrame(PictureMessage(options.shot.colors.Flatten(frame), false,
    { { "kind", "frame" }, { "exact", false }, { "width", view.camera.width },
      { "height", view.camera.height } }));
  Coarse->DropFrame();
}

void ServedView::DrawExact(const std::function<bool()>& othersWait)
{
  {
    const std::lock_guard lock(Mutex);
    ExactDue.reset();
  }
  const auto begin = Clock::now();
  bool interrupted = false;
  const RenderOptions& options = Shown->GetOptions();
  const Shot& shot = Shown->GetShot();
  Frame traced = TraceShot(options, shot,
    [&](double)
    {
      interrupted =
        interrupted || IsInterrupted() || (Clock::now() - begin > kLongTrace && othersWait());
      return !interrupted;
    });
  if (interrupted)
  {
    // The change that interrupted it may be refused.
    const std::lock_guard lock(Mutex);
    ExactDue = Clock::now() + kPause;
    return;
  }
  const DrawnShot drawn(options, shot, std::move(traced));
  const std::vector<ValueRange>& ranges = drawn.GetAppearance().Ranges();
  if (ranges.size() == 1)
  {
    Range = ranges.front();
  }
  nlohmann::ordered_json header = State();
  AddExact(header, options, shot, drawn);
  header["width"] = shot.size.width;
  header["height"] = shot.size.height;
  header["seconds"] = std::chrono::duration<double>(Clock::now() - begin).count();
  Good = Words;
  Browser->SendFrame(PictureMessage(drawn.Picture(), true, std::move(header)));
}

nlohmann::ordered_json ServedView::State() const
{
  nlohmann::ordered_json state;
  state["kind"] = "frame";
  state["exact"] = true;
  state["options"] = OptionsOf(Words);
  const std::string name =
    std::filesystem::path(Shown->GetOptions().shot.input.files.front()).stem().string();
  state["command"] = RepeatedCommand{ Command(name + "_view.png"), {} }.Text();
  return state;
}

void ServedView::Hover(const std::array<int, 2>& pixel)
{
  const Shot& shot = Shown->GetShot();
  const auto [x, y] = pixel;
  if (x < 0 || y < 0 || x >= shot.size.width || y >= shot.size.height)
  {
    return;
  }
  const View view = ViewOf(Shown->GetOptions().shot.colors, nullptr, shot);
  const std::array<ImagePosition, 1> positions{ { { x + 0.5, shot.size.height - y - 0.5 } } };
  const SampleBuffers sample = Probe->Sample(view, positions);
  Browser->SendText(HoverMessage(pixel, sample, shot));
}

void ServedView::Save(const std::string& suffix, ServedInput& input)
{
  const bool isBuffers = suffix == "vti";
  if (!isBuffers && suffix != "png" && suffix != "tif" && suffix != "jpg" && suffix != "svg" &&
    suffix != "pdf")
  {
    throw UsageError("a page saves png, tif, jpg, svg, pdf or vti");
  }
  const std::string stem =
    std::filesystem::path(Shown->GetOptions().shot.input.files.front()).stem().string() + "_view.";
  const std::string picture = stem + (isBuffers ? "png" : suffix);
  std::vector<std::string> words = Command(picture);
  if (isBuffers)
  {
    words.push_back("--buffers=" + stem + "vti");
  }
  const ServedScene scene(words, picture, input);
  const RenderOptions& options = scene.GetOptions();
  const bool paths = !isBuffers && (suffix == "svg" || suffix == "pdf");
  Frame traced = TraceShot(options, scene.GetShot(), [this](double) { return !HasLeft(); });
  if (HasLeft())
  {
    return;
  }
  const DrawnShot drawn(options, scene.GetShot(), std::move(traced), paths);
  const RepeatedCommand command{ words, {} };
  Stopwatch watch;
  nlohmann::ordered_json header{ { "kind", "file" }, { "name", stem + suffix },
    { "command", command.Text() } };
  Browser->SendFile(BinaryMessage(header,
    isBuffers ? EncodeBuffersOf(options, scene.GetShot(), drawn, stem + "vti")
              : EncodePicture(options, drawn, picture, command, watch)));
}
} // namespace pixelexact
