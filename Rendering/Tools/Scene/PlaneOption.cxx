// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/PlaneOption.h"

#include "Base/Command.h"
#include "Base/Numbers.h"
#include "Base/Options.h"

#include "Core/Base/Error.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <string_view>

namespace pixelexact
{
namespace
{
constexpr const char* kName = "--plane";
constexpr std::string_view kAxisLetters = "xyz";
/// Sides of a box that differ by less are alike.
constexpr double kAlike = 0.01;

/// Rounds to about a millionth of the side, in decimals, so that the middle of a box whose bounds
/// have rounding errors is 0 and not 1e-17.
double Rounded(double at, double side)
{
  if (!std::isnormal(side))
  {
    return at;
  }
  const int decimals = 6 - static_cast<int>(std::floor(std::log10(side)));
  const double unit = std::pow(10.0, std::abs(decimals));
  const double rounded =
    decimals >= 0 ? std::round(at * unit) / unit : std::round(at / unit) * unit;
  return std::isfinite(rounded) ? rounded : at;
}

int ShortestSide(const Vec3& sides)
{
  int shortest = 2;
  for (const int d : { 1, 0 })
  {
    shortest = sides[d] < (1.0 - kAlike) * sides[shortest] ? d : shortest;
  }
  return shortest;
}
} // namespace

PlaneChoice PlaneChoice::Read(const std::string& text)
{
  PlaneChoice choice;
  if (!text.empty() && kAxisLetters.find(text.front()) != std::string_view::npos)
  {
    choice.Axis = static_cast<int>(kAxisLetters.find(text.front()));
    std::string_view rest = std::string_view(text).substr(1);
    if (rest.empty())
    {
      return choice;
    }
    choice.IsPart = rest.ends_with('%');
    rest.remove_suffix(choice.IsPart ? 1 : 0);
    if (rest.front() != '=' || !ParseNumber(rest.substr(1), choice.At) ||
      !std::isfinite(choice.At) || (choice.IsPart && !(choice.At >= 0.0 && choice.At <= 100.0)))
    {
      Refuse(kName, text, kForm);
    }
    choice.At /= choice.IsPart ? 100.0 : 1.0;
    return choice;
  }
  const std::vector<double> numbers = ReadNumbers(kName, text, 6, kForm);
  choice.Given = { { numbers[0], numbers[1], numbers[2] }, { numbers[3], numbers[4], numbers[5] } };
  try
  {
    (void)Plane(choice.Given.origin, choice.Given.normal);
  }
  catch (const Error& error)
  {
    throw UsageError(std::string(kName) + ": " + error.what());
  }
  return choice;
}

PlaneChoice PlaneChoice::ThroughTheMiddle()
{
  PlaneChoice choice;
  choice.Axis = kShortest;
  return choice;
}

PlaneChoice::Place PlaneChoice::PlaceIn(const Box3& box) const
{
  if (Axis == kNoAxis)
  {
    return Given;
  }
  const Vec3 sides = box.upper - box.lower;
  const int axis = Axis == kShortest ? ShortestSide(sides) : Axis;
  Place place{ Vec3(0.0), Vec3(0.0) };
  place.normal[axis] = 1.0;
  place.origin[axis] =
    IsPart ? Rounded(std::lerp(box.lower[axis], box.upper[axis], At), sides[axis]) : At;
  // Adding 0 removes the minus sign of -0.
  place.origin[axis] += 0.0;
  return place;
}

Plane PlaneChoice::Make(const Box3& box) const
{
  const Place place = PlaceIn(box);
  return { place.origin, place.normal };
}

std::string PlaneChoice::Numbers(const Box3& box) const
{
  const auto& [o, n] = PlaceIn(box);
  return fmt::format("{},{},{},{},{},{}", o.x, o.y, o.z, n.x, n.y, n.z);
}
} // namespace pixelexact
