// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/ShownWords.h"

#include "Base/Numbers.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <iterator>

namespace pixelexact
{
std::string OptionOf(const std::string& word)
{
  return word.starts_with("--") ? word.substr(0, word.find('=')) : std::string();
}

namespace
{
bool IsOneOf(const std::string& name, std::initializer_list<const char*> names)
{
  return std::ranges::any_of(names, [&name](const char* one) { return name == one; });
}

bool IsOfContours(const std::string& name)
{
  return name.starts_with("--contour") ||
    IsOneOf(name,
      { "--certifier", "--subdivisions", "--interior", "--show-undecided-contours",
        "--undecided-contour-color" });
}

bool IsReplaced(const std::string& name, const ShownNow& now)
{
  return IsOneOf(name,
           { "--view", "--camera-position", "--focal-point", "--view-up", "--view-angle",
             "--parallel-scale", "--output", "--json" }) ||
    (now.range && name == "--range") || (now.step && IsOneOf(name, { "--time-step", "--time" })) ||
    (!now.contours && IsOfContours(name)) || (!now.edges && name.starts_with("--edge"));
}

/// Turning the camera leaves roundings where 0 is meant.
std::string Text(const Vec3& v, double size)
{
  const auto clean = [size](double number) { return WithoutRoundings(number, size); };
  return fmt::format("{},{},{}", clean(v.x), clean(v.y), clean(v.z));
}
} // namespace

std::vector<std::string> WordsOf(const ShownNow& now, const std::vector<std::string>& words,
  const std::vector<std::string>& chosen, const std::string& contours)
{
  std::vector<std::string> result{ "render" };
  bool surfaceIsThere = now.surface.empty();
  const std::string moved = OptionOf(now.surface);
  bool contoursAreThere = false;
  bool edgesAreThere = false;
  std::vector<std::string> all(words.begin() + 1, words.end());
  all.insert(std::ranges::find(all, "--"), chosen.begin(), chosen.end());
  std::vector<std::string> added;
  for (const std::string& word : all)
  {
    const std::string name = OptionOf(word);
    if (IsReplaced(name, now) || word == "--")
    {
      continue;
    }
    contoursAreThere = contoursAreThere || name == "--contours";
    edgesAreThere = edgesAreThere || name == "--edges";
    if (name == moved && !surfaceIsThere)
    {
      surfaceIsThere = true;
      result.push_back(now.surface);
      continue;
    }
    result.push_back(word);
  }
  if (!surfaceIsThere)
  {
    result.push_back(now.surface);
  }
  if (now.contours && !contoursAreThere)
  {
    result.push_back("--contours=" + contours);
  }
  if (now.edges && !edgesAreThere)
  {
    result.emplace_back("--edges");
  }
  if (now.range)
  {
    result.push_back(fmt::format("--range={},{}", (*now.range)[0], (*now.range)[1]));
  }
  if (now.step)
  {
    result.push_back(fmt::format("--time-step={}", *now.step));
  }
  const CameraView& view = now.view;
  const double distance = glm::length(view.position - view.focalPoint);
  result.insert(result.end(),
    { "--camera-position=" + Text(view.position, distance),
      "--focal-point=" + Text(view.focalPoint, distance),
      "--view-up=" + Text(view.viewUp, glm::length(view.viewUp)),
      view.parallel ? fmt::format("--parallel-scale={}", view.parallelScale)
                    : fmt::format("--view-angle={}", view.viewAngle),
      "--output=" + now.output });
  return result;
}
} // namespace pixelexact
