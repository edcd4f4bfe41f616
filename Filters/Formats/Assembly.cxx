// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Assembly.h"

#include "Core/Base/Error.h"
#include "Core/Basis/ModeBound.h"
#include "Core/Element/ElementUnits.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>
#include <map>

namespace pixelexact
{
namespace
{
/// A coordinate in a file is off by half a unit in the last place from writing it and by a few from
/// the solver's evaluation.
constexpr double kCoordinateRoundings = 4.0;

using Bases = std::span<const ElementBasis* const>;

template <class Function>
void ForElements(std::size_t elements, Function&& function)
{
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, elements, 64),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      std::vector<double> source;
      for (std::size_t e = range.begin(); e < range.end(); ++e)
      {
        function(e, source);
      }
    });
}

SolverExpansion Allocate(Bases basis, int components)
{
  SolverExpansion expansion;
  expansion.components = components;
  expansion.spaceOf.reserve(basis.size());
  expansion.offset.reserve(basis.size());
  std::map<Space, std::int32_t> known;
  std::size_t size = 0;
  for (const auto* b : basis)
  {
    const Space& space = b->GetSpace();
    const auto [at, isNew] = known.try_emplace(space, static_cast<std::int32_t>(known.size()));
    if (isNew)
    {
      expansion.spaces.push_back(space);
    }
    expansion.spaceOf.push_back(at->second);
    expansion.offset.push_back(static_cast<std::int64_t>(size));
    size += static_cast<std::size_t>(space.Modes()) * components;
  }
  // Not initialised: every coefficient is written once.
  expansion.coefficients = { std::unique_ptr<double[]>(new double[size]), size };
  return expansion;
}

/// The canonical coefficients of component c of element e.
std::span<double> Component(SolverExpansion& expansion, std::size_t e, int c)
{
  const auto modes = static_cast<std::size_t>(expansion.spaces[expansion.spaceOf[e]].Modes());
  return { &expansion.coefficients.data[expansion.offset[e] + c * modes], modes };
}

/// sum over the modes of what one unit of noise in every source value can put into the function.
double NoiseOf(const ChangeOfBasis& change)
{
  const auto amplification = change.Amplification();
  double noise = 0.0;
  ForEachMode(change.Target(),
    [&](int p, int q, int r, int mode)
    { noise += amplification[mode] * ModeBound(change.Target(), p, q, r); });
  return noise;
}

ElementUnits UnitsOf(std::span<const double> source, const std::string& name)
{
  const std::size_t n = source.size() / 3;
  Vec3 low(INFINITY);
  Vec3 high(-INFINITY);
  for (int c = 0; c < 3; ++c)
  {
    for (const double x : source.subspan(c * n, n))
    {
      if (!std::isfinite(x))
      {
        throw InvalidData(name + " has a coordinate that is NaN or infinite; write the mesh anew.");
      }
      low[c] = std::fmin(low[c], x);
      high[c] = std::fmax(high[c], x);
    }
  }
  try
  {
    return MakeElementUnits(low, high);
  }
  catch (const InvalidData& error)
  {
    throw InvalidData(name + " " + error.what());
  }
}
} // namespace

SolverExpansion AssembleField(Bases basis, int components, const Gather& gather)
{
  SolverExpansion expansion = Allocate(basis, components);
  ForElements(basis.size(),
    [&](std::size_t e, std::vector<double>& source)
    {
      const ElementBasis& b = *basis[e];
      const auto n = static_cast<std::size_t>(b.sources);
      source.resize(b.IsVector() ? n : n * components);
      gather(e, source);
      for (int c = 0; c < components; ++c)
      {
        const std::span values(source);
        b.parts[b.IsVector() ? c : 0].Apply(
          b.IsVector() ? values : values.subspan(c * n, n), 0.0, Component(expansion, e, c));
      }
    });
  return expansion;
}

void AssembleMap(Bases basis, const Gather& gather,
  const std::function<std::string(std::size_t)>& describe, SolverMesh& mesh)
{
  mesh.map = Allocate(basis, 3);
  mesh.centre.resize(3 * basis.size());
  mesh.size.resize(basis.size());
  mesh.uncertainty.resize(basis.size());
  std::map<const ElementBasis*, double> noise;
  for (const auto* b : basis)
  {
    if (!noise.contains(b))
    {
      noise[b] = NoiseOf(b->parts[0]);
    }
  }
  ForElements(basis.size(),
    [&](std::size_t e, std::vector<double>& source)
    {
      const ChangeOfBasis& change = basis[e]->parts[0];
      const auto n = static_cast<std::size_t>(basis[e]->sources);
      source.resize(3 * n);
      gather(e, source);
      const ElementUnits units = UnitsOf(source, describe(e));
      for (int c = 0; c < 3; ++c)
      {
        const auto coefficients = Component(mesh.map, e, c);
        change.Apply(std::span(source).subspan(c * n, n), units.centre[c], coefficients);
        for (double& value : coefficients)
        {
          value = std::ldexp(value, -units.exponent); // a power of two: exact
        }
        mesh.centre[3 * e + c] = units.centre[c];
      }
      mesh.size[e] = std::ldexp(1.0, units.exponent);
      mesh.uncertainty[e] = kCoordinateRoundings * std::numeric_limits<double>::epsilon() / 2 *
        units.largest * noise.at(basis[e]);
    });
}
} // namespace pixelexact
