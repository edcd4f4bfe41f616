// SPDX-License-Identifier: BSD-3-Clause
#include "Serve/ServedView.h"

#include "Base/Command.h"
#include "Picture/DrawnShot.h"
#include "Picture/ShownWords.h"
#include "Serve/PageWords.h"
#include "Serve/ServedInput.h"
#include "Serve/ServedMessages.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <utility>

namespace pixelexact
{
namespace
{
/// Time of tracing of a coarse picture.
constexpr double kCoarseSeconds = 0.03;

/// The beginning of names of saved files.
std::string StemOf(const ServedScene& scene)
{
  return std::filesystem::path(scene.GetOptions().shot.input.files.front()).stem().string() +
    "_view.";
}
} // namespace

ServedView::ServedView(
  std::vector<std::string> words, std::shared_ptr<Outbox> outbox, std::function<void()> changed)
  : Browser(std::move(outbox))
  , Wake(std::move(changed))
  , State(std::move(words), [this](bool atOnce) { Changed(atOnce); })
{
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

std::pair<ServedView::Work, ServedView::Clock::time_point> ServedView::Next(FileDrawer& files)
{
  const std::lock_guard lock(Mutex);
  if (!Waiting.empty())
  {
    return { Work::Change, Clock::time_point::min() };
  }
  // A browser gets one file after the other.
  if (!Files.empty() && files.IsIdle() && !Browser->HoldsFile())
  {
    return { Work::File, Clock::time_point::min() };
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
  return HasLeft() || std::ranges::any_of(Waiting, changes);
}

void ServedView::Changed(bool atOnce)
{
  Stale = true;
  const std::lock_guard lock(Mutex);
  ExactDue = Clock::now() + (atOnce ? Clock::duration::zero() : Clock::duration(kPause));
}

void ServedView::Perform(
  ServedInput& input, FileDrawer& files, const std::function<bool()>& othersWait)
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
      Handle(message);
    }
    if (Stale)
    {
      Update(input);
    }
    for (const std::string& suffix : std::exchange(Saves, {}))
    {
      RequestFile(suffix);
    }
    if (HoverAt)
    {
      Hover(*std::exchange(HoverAt, std::nullopt));
    }
    const auto [work, due] = Next(files);
    if (work == Work::File)
    {
      BeginFile(input, files);
    }
    if (work == Work::Exact && due <= Clock::now())
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
  Saves.clear();
  HoverAt.reset();
  if (State.Withdraw())
  {
    Changed(true);
  }
  else if (Stale)
  {
    const std::lock_guard lock(Mutex);
    ExactDue.reset();
  }
  SendRefusal(text);
}

void ServedView::SendRefusal(const std::string& text)
{
  Browser->SendText(TextMessage(
    { { "kind", "failure" }, { "text", text }, { "options", OptionsOf(State.Words()) } }));
}

void ServedView::Handle(const nlohmann::json& message)
{
  State.Apply(message);
  if (message.contains("hover"))
  {
    const auto at = TwoNumbers(message["hover"], PageState::kMaxSide);
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

void ServedView::Update(ServedInput& input)
{
  // The renderer holds parts of the scene, so it forgets them first.
  Coarse->DropFrame();
  Probe->DropFrame();
  const std::string picture = "view.png";
  const bool isFitted = State.IsFitted();
  Shown = std::make_unique<ServedScene>(
    WithoutFigure(isFitted ? State.Command(picture) : State.Words()), picture, input);
  if (!isFitted)
  {
    State.Fit(Shown->GetShot().view);
    // The words of the camera give the same one up to rounding; pictures are those of the words.
    Shown = std::make_unique<ServedScene>(WithoutFigure(State.Command(picture)), picture, input);
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
  std::atomic<bool> isInterrupted = false;
  const auto goesOn = [&]
  {
    if (!isInterrupted && (IsInterrupted() || (Clock::now() - begin > Patience && othersWait())))
    {
      isInterrupted = true;
    }
    return !isInterrupted;
  };
  const RenderOptions& options = Shown->GetOptions();
  const Shot& shot = Shown->GetShot();
  std::optional<DrawnShot> finished;
  try
  {
    Frame traced = TraceShot(options, shot, [&](double) { return goesOn(); });
    if (!isInterrupted)
    {
      finished.emplace(options, shot, std::move(traced), false, goesOn);
    }
  }
  catch (const Interrupted&)
  {
    finished.reset();
  }
  if (!finished)
  {
    // The change that interrupted it may be refused.
    const bool isChanged = IsInterrupted();
    Patience = isChanged ? kLongTrace : 2 * Patience;
    const std::lock_guard lock(Mutex);
    ExactDue = Clock::now() + (isChanged ? kPause : kLater);
    return;
  }
  Patience = kLongTrace;
  const DrawnShot& drawn = *finished;
  const std::vector<ValueRange>& ranges = drawn.GetAppearance().Ranges();
  if (ranges.size() == 1 && !drawn.Debug().IsInPlace())
  {
    State.KeepRange(ranges.front());
  }
  nlohmann::ordered_json header = Header();
  AddExact(header, options, shot, drawn);
  header["width"] = shot.size.width;
  header["height"] = shot.size.height;
  header["seconds"] = std::chrono::duration<double>(Clock::now() - begin).count();
  State.Confirm();
  Browser->SendFrame(PictureMessage(drawn.Picture(), true, std::move(header)));
}

nlohmann::ordered_json ServedView::Header() const
{
  nlohmann::ordered_json header;
  header["kind"] = "frame";
  header["exact"] = true;
  header["options"] = OptionsOf(State.Words());
  header["command"] = RepeatedCommand{ State.Command(StemOf(*Shown) + "png"), {} }.Text();
  return header;
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

void ServedView::RequestFile(const std::string& suffix)
{
  FileRequest file{ suffix, StemOf(*Shown), {} };
  if (!IsSavedSuffix(file.suffix))
  {
    SendRefusal("a page saves png, tif, jpg, svg, pdf or vti");
    return;
  }
  if (Files.size() >= kMaxFiles)
  {
    SendRefusal(fmt::format("{} files wait to be saved; save more when they have come", kMaxFiles));
    return;
  }
  file.words = State.Command(file.Picture());
  if (file.IsBuffers())
  {
    file.words.push_back("--buffers=" + file.stem + file.suffix);
  }
  Files.push_back(std::move(file));
}

void ServedView::BeginFile(ServedInput& input, FileDrawer& files)
{
  FileRequest file = std::move(Files.front());
  Files.pop_front();
  try
  {
    auto scene = std::make_unique<ServedScene>(file.words, file.Picture(), input);
    files.Begin(std::move(file), std::move(scene), Browser, [left = Left] { return left->load(); });
  }
  catch (const std::exception& error)
  {
    SendRefusal(error.what());
  }
}
} // namespace pixelexact
