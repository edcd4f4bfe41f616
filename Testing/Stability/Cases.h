// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MeshBuilder.h"

#include <span>
#include <string>

// The manufactured elements of the location sweeps.
namespace pixelexact::testing
{
struct LocationCase
{
  std::string sweep;
  std::string parameter;
  double at = 0.0; ///< the parameter's value
  Shape shape = Shape::Hexahedron;
  int order = 1;
  MeshBuilder mesh;
  int element = 0;
  /// A xi of the shape.
  std::function<Vec3(Random&)> inside;
  /// A xi beyond one face, up to where Phi is known to be injective on the shape and beyond.
  std::function<Vec3(Random&)> outside;
};

/// The extent of the sweeps: some values of each parameter, or all.
enum class Extent
{
  Short,
  Full
};

/// 1 to 16, and on to 32 by fours.
std::vector<int> AllOrders();

/// Makes the cases of one kind, value by value of its parameter.
struct LocationSweep
{
  const char* name;
  void (*add)(Extent extent, std::vector<LocationCase>& cases);
};
std::span<const LocationSweep> LocationSweeps();
} // namespace pixelexact::testing
