// SPDX-License-Identifier: BSD-3-Clause
// Asks an element for points, each alone and of a locator of its own, and times the answers.
//
//   AskPoints < QUESTION > ANSWERS
//
// The question is numbers apart by blanks: the shape's (Shape.h), three orders, the uncertainty of
// the map, the coefficients of x, y and z (in units of 1 about the origin), how many points, the
// points. A line for each: verdict, xi, coverage, and the processor's milliseconds for Sample and
// for FindOwners, the least of three where it is more than one.
#include "MeshBuilder.h"

#include "Core/Location/Owners.h"
#include "Core/Location/Sample.h"

#include <tbb/global_control.h>

#include <ctime>
#include <exception>
#include <iomanip>
#include <iostream>
#include <stdexcept>

namespace pixelexact::testing
{
namespace
{
template <class T>
T Read()
{
  T value{};
  if (!(std::cin >> value))
  {
    throw std::runtime_error("the question ends too early.");
  }
  return value;
}

/// Processor milliseconds of body(locator), with a locator that has only the elements' bounds.
template <class Body>
double Milliseconds(const Mesh& mesh, const Body& body)
{
  double least = 0.0;
  for (int repeat = 0; repeat < 3; ++repeat)
  {
    const Locator locator(mesh);
    (void)locator.Index().BoundsOf(0);
    const std::clock_t begin = std::clock();
    body(locator);
    const double took = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    least = repeat == 0 ? took : std::min(least, took);
    if (least < 1.0)
    {
      break;
    }
  }
  return least;
}

void Answer()
{
  const tbb::global_control serial(tbb::global_control::max_allowed_parallelism, 1);
  Space space;
  space.shape = static_cast<Shape>(Read<int>());
  for (auto& order : space.order)
  {
    order = static_cast<std::uint8_t>(Read<int>());
  }
  MeshBuilder builder;
  builder.Add(space, [](const LongVec3&) -> LongVec3 { return {}; });
  builder.Uncertainty[0] = Read<double>();
  for (double& c : builder.Phi.Coefficients)
  {
    c = Read<double>();
  }
  const Mesh mesh = builder.View();
  Validate(mesh);
  std::cout << std::setprecision(17);
  for (int left = Read<int>(); left > 0; --left)
  {
    const auto x = Read<double>();
    const auto y = Read<double>();
    const Vec3 point(x, y, Read<double>());
    Verdict verdict = Verdict::Unknown;
    Vec3 xi(0.0);
    SampleTarget target;
    target.verdict = std::span(&verdict, 1);
    target.xi = std::span(&xi, 1);
    const double sample = Milliseconds(mesh,
      [&](const Locator& locator) { SampleTile(locator, nullptr, std::span(&point, 1), target); });
    Owners owners;
    const double all = Milliseconds(mesh,
      [&](const Locator& locator)
      { FindOwnersOfTile(locator, std::span(&point, 1), std::span(&owners, 1)); });
    std::cout << Name(verdict) << ' ' << xi.x << ' ' << xi.y << ' ' << xi.z << ' '
              << Name(owners.coverage) << ' ' << sample << ' ' << all << '\n';
  }
}
} // namespace
} // namespace pixelexact::testing

int main()
{
  try
  {
    pixelexact::testing::Answer();
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "AskPoints: " << error.what() << '\n';
    return 1;
  }
}
