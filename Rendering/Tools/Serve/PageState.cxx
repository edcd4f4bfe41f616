// SPDX-License-Identifier: BSD-3-Clause
#include "Serve/PageState.h"

#include "Base/Command.h"
#include "Picture/CameraMoves.h"
#include "Picture/ShownWords.h"
#include "Serve/PageWords.h"

#include "Core/Base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace pixelexact
{
namespace
{
/// Radians and parts of the image's height of one message.
constexpr double kMaxMove = 10.0;
constexpr double kMaxZoom = 100.0;

/// Words of cameras, which PageState::Eye replaces.
bool IsOfCamera(const std::string& word)
{
  const std::string name = OptionOf(word);
  return name == "--view" || name == "--camera-position" || name == "--focal-point" ||
    name == "--view-up" || name == "--view-angle" || name == "--parallel-scale";
}

void ReplaceSize(std::vector<std::string>& words, const std::string& size)
{
  std::erase_if(words, [](const std::string& word) { return OptionOf(word) == "--size"; });
  words.insert(std::ranges::find(words, "--"), size);
}
} // namespace

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

void RefuseMember(const std::string& name)
{
  throw UsageError("the message's member '" + name + "' is invalid");
}

PageState::PageState(std::vector<std::string> words, Changed changed)
  : OnChange(std::move(changed))
  , words_(std::move(words))
  , Given(words_)
  , Good(words_)
{
}

void PageState::Apply(const nlohmann::json& message)
{
  Move(message);
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
}

void PageState::Move(const nlohmann::json& message)
{
  CameraView moved = Eye;
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
  if (HasEye && !(moved == Eye))
  {
    (void)Camera(moved, 1, 1); // throws Error where it is no camera
    Eye = moved;
    OnChange(false);
  }
}

void PageState::SetOptions(const nlohmann::json& options)
{
  if (!options.is_object())
  {
    RefuseMember("set");
  }
  std::vector<std::string> words = words_;
  for (const auto& [name, value] : options.items())
  {
    if (!value.is_null() && !value.is_string() && !(value.is_boolean() && value.get<bool>()))
    {
      RefuseMember("set");
    }
    words = WithOption(words, name,
      value.is_null() ? std::nullopt
                      : std::optional(value.is_string() ? value.get<std::string>() : "true"));
    if (name == "--field" || name == "--component" || name == "--range" || name == "--log" ||
      name == "--show" || name == "--owners")
    {
      Range.reset();
    }
  }
  words_ = std::move(words);
  OnChange(false);
}

void PageState::SetView(const std::string& name)
{
  std::erase_if(words_, IsOfCamera);
  const auto end = std::ranges::find(words_, "--");
  if (name == "fit")
  {
    std::vector<std::string> camera;
    std::ranges::copy_if(Given, std::back_inserter(camera), IsOfCamera);
    words_.insert(end, camera.begin(), camera.end());
  }
  else
  {
    words_.insert(end, "--view=" + name);
  }
  Fits = true;
  OnChange(true);
}

void PageState::SetSize(const nlohmann::json& size)
{
  const auto given = TwoNumbers(size, kMaxSide);
  if (!given || (*given)[0] < kMinSide || (*given)[1] < kMinSide ||
    (*given)[0] * (*given)[1] > kMaxPixels)
  {
    throw UsageError(fmt::format("a page's picture has sides of {} to {} and at most {} pixels",
      kMinSide, kMaxSide, kMaxPixels));
  }
  const std::string word =
    fmt::format("--size={}x{}", static_cast<int>((*given)[0]), static_cast<int>((*given)[1]));
  ReplaceSize(words_, word);
  // The size is the browser's, whatever options fail.
  ReplaceSize(Good, word);
  OnChange(true);
}

std::vector<std::string> PageState::Command(const std::string& output) const
{
  const auto has = [this](const char* option)
  { return std::ranges::find(words_, option, OptionOf) != words_.end(); };
  ShownNow now;
  now.view = Eye;
  now.range = Range;
  now.contours = has("--contours");
  now.edges = has("--edges");
  now.output = output;
  return WordsOf(now, words_, {}, {});
}

void PageState::Fit(const CameraView& view)
{
  Eye = view;
  HasEye = true;
  Fits = false;
  std::erase_if(words_, IsOfCamera);
  std::erase_if(Good, IsOfCamera);
}

bool PageState::Withdraw()
{
  const bool changes = words_ != Good;
  words_ = Good;
  Fits = Fits && !HasEye;
  Range.reset();
  return changes;
}
} // namespace pixelexact
