// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Assembly.h"

#include "Core/Base/Error.h"
#include "Core/Basis/ModeBound.h"
#include "Core/Basis/OrderReduction.h"
#include "Core/Element/ElementUnits.h"
#include "Core/Math/Rounding.h"
#include "Formats/FileText.h"

#include <glm/common.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace pixelexact
{
namespace
{
using Bases = std::span<const ElementBasis* const>;
using Describe = std::function<std::string(std::size_t)>;

/// Scratch memory of one thread.
struct Work
{
  std::vector<double> source;
  ChangeOfBasis::Scratch scratch;
};

template <class Function>
void ForElements(std::size_t elements, Function&& function)
{
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, elements, 64),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      Work work;
      for (std::size_t e = range.begin(); e < range.end(); ++e)
      {
        function(e, work);
      }
    });
}

Space Same(const Space& space)
{
  return space;
}

/// Allocates coefficients in the spaces that `spaceOf` makes from the bases' spaces.
OwnedExpansion Allocate(Bases basis, int components, Space (*spaceOf)(const Space&))
{
  std::vector<Space> spaces(basis.size());
  std::ranges::transform(
    basis, spaces.begin(), [spaceOf](const ElementBasis* b) { return spaceOf(b->GetSpace()); });
  OwnedExpansion expansion;
  expansion.Allocate(spaces, components);
  return expansion;
}

/// The canonical coefficients of component c of element e.
std::span<double> Component(OwnedExpansion& expansion, std::size_t e, int c)
{
  const auto modes = static_cast<std::size_t>(expansion.SpaceOf(e).Modes());
  return expansion.Coefficients(e).subspan(static_cast<std::size_t>(c) * modes, modes);
}

struct Box
{
  Vec3 low{ INFINITY };
  Vec3 high{ -INFINITY };
};

/// The box of one element's source values, which are stored component by component; a plane mesh's
/// z stays 0.
Box BoxOf(std::span<const double> source, int components, const Describe& describe, std::size_t e)
{
  const std::size_t n = source.size() / components;
  Box box;
  if (components < 3)
  {
    box.low.z = box.high.z = 0.0;
  }
  for (int c = 0; c < components; ++c)
  {
    for (const double x : source.subspan(c * n, n))
    {
      if (!std::isfinite(x))
      {
        throw InvalidData(
          describe(e) + " has a coordinate that is NaN or infinite; write the mesh again.");
      }
      box.low[c] = std::fmin(box.low[c], x);
      box.high[c] = std::fmax(box.high[c], x);
    }
  }
  return box;
}

ElementUnits UnitsOf(const Box& box, const Describe& describe, std::size_t e)
{
  try
  {
    return MakeElementUnits(box.low, box.high);
  }
  catch (const InvalidData& error)
  {
    throw InvalidData(describe(e) + " " + error.what());
  }
}

/// The coordinates of the element's centre, one per component.
std::span<const double> ShiftsOf(const ElementUnits& units, std::size_t components)
{
  static_assert(sizeof(units.centre) == 3 * sizeof(double));
  return { &units.centre.x, components };
}

/// The map's noise for each basis.
std::map<const ElementBasis*, MapNoise> NoiseOf(Bases basis)
{
  std::map<const ElementBasis*, MapNoise> noise;
  for (const auto* b : basis)
  {
    noise.try_emplace(b, b->parts[0]);
  }
  return noise;
}

void Prepare(Bases basis, Space (*spaceOf)(const Space&), SolverMesh& mesh)
{
  mesh.map = Allocate(basis, 3, spaceOf);
  mesh.centre.resize(3 * basis.size());
  mesh.size.resize(basis.size());
  mesh.uncertainty.resize(basis.size());
}

/// Stores an element's units and uncertainty in `mesh`. `modes`: those of the map, in units of the
/// element. `roundoff`: of the coordinates.
void StoreUnits(const ElementUnits& units, const MapNoise& noise, std::span<const double> modes,
  double roundoff, std::size_t e, SolverMesh& mesh)
{
  for (int c = 0; c < 3; ++c)
  {
    mesh.centre[3 * e + c] = units.centre[c];
  }
  mesh.size[e] = std::ldexp(1.0, units.exponent);
  const double roundings =
    std::ldexp(kCoordinateRoundings * roundoff * units.largest, -units.exponent);
  mesh.uncertainty[e] = mesh.size[e] * noise.Of(roundings, modes);
}

/// Finds the orders of maps that rounding explains, in one basis.
class RoundedOrders
{
public:
  /// `space`: of the maps; that of the basis, or of the slab on it.
  RoundedOrders(const ChangeOfBasis& change, const Space& space, double roundoff)
    : MapSpace(space)
    , Roundoff(roundoff)
    , Noise(NoiseBound(change))
  {
    std::map<std::array<int, 3>, double> ofMode;
    ForEachMode(change.Target(),
      [&](int p, int q, int r, int mode) {
        ofMode[{ p, q, r }] = change.Amplification()[mode];
      });
    // Modes across a slab are not from coordinates.
    ForEachMode(space,
      [&](int p, int q, int r, int) {
        Amplification.push_back(ofMode[{ p, q, r }]);
      });
  }

  /// The reduction of an element's map. Refers to the mesh and to this object.
  [[nodiscard]] OrderReduction Of(const SolverMesh& mesh, std::size_t e) const
  {
    const auto centre = std::span(mesh.centre).subspan(3 * e, 3);
    const double largest =
      std::max({ std::fabs(centre[0]), std::fabs(centre[1]), std::fabs(centre[2]) });
    const double roundings = kCoordinateRoundings * Roundoff * (largest / mesh.size[e] + 1.0);
    return { MapSpace, Amplification, mesh.map.Coefficients(e), roundings, Noise, 1.0 };
  }

private:
  Space MapSpace;
  double Roundoff;
  double Noise;
  std::vector<double> Amplification; ///< per mode of a map
};

/// The box of all elements, by their source values.
Box BoxOfMesh(Bases basis, int components, const Gather& gather, const Describe& describe)
{
  Box all;
  std::vector<double> source;
  for (std::size_t e = 0; e < basis.size(); ++e)
  {
    source.resize(static_cast<std::size_t>(components) * basis[e]->sources);
    gather(e, source);
    const Box box = BoxOf(source, components, describe, e);
    all.low = glm::min(all.low, box.low);
    all.high = glm::max(all.high, box.high);
  }
  return all;
}

/// The maps of a surface in space, whose source has three components.
void AssembleShell(Bases basis, const std::map<const ElementBasis*, MapNoise>& noise,
  const Gather& gather, const Describe& describe, SolverMesh& mesh, double roundoff)
{
  std::map<const ElementBasis*, double> ofMap;
  for (const auto* b : basis)
  {
    if (!ofMap.contains(b))
    {
      ofMap[b] = NoiseBound(b->parts[0]);
    }
  }
  ForElements(basis.size(),
    [&](std::size_t e, Work& work)
    {
      const ChangeOfBasis& change = basis[e]->parts[0];
      work.source.resize(3 * static_cast<std::size_t>(basis[e]->sources));
      gather(e, work.source);
      const ElementUnits units = UnitsOf(BoxOf(work.source, 3, describe, e), describe, e);
      std::vector<double> modes(3 * static_cast<std::size_t>(change.Target().Modes()));
      change.Apply(work.source, ShiftsOf(units, 3), modes, work.scratch);
      const auto inUnits = [&units](double x) { return std::ldexp(x, -units.exponent); };
      std::ranges::transform(modes, modes.begin(), inUnits);
      StoreUnits(units, noise.at(basis[e]), modes, roundoff, e, mesh);
      const double roundings = inUnits(kCoordinateRoundings * roundoff * units.largest);
      const Space needed = OrderReduction(
        change.Target(), change.Amplification(), modes, roundings, ofMap.at(basis[e]), 1.0)
                             .Reduce();
      try
      {
        LiftSurface(change.Target(), needed, modes, mesh.slab->thickness, mesh.map.Coefficients(e));
      }
      catch (const InvalidData& error)
      {
        throw InvalidData(describe(e) + " " + error.what());
      }
    });
}
} // namespace

OwnedExpansion AssembleField(Bases basis, int components, const Gather& gather)
{
  OwnedExpansion expansion = Allocate(basis, components, &Same);
  const std::vector<double> zeros(static_cast<std::size_t>(components));
  ForElements(basis.size(),
    [&](std::size_t e, Work& work)
    {
      const ElementBasis& b = *basis[e];
      const auto n = static_cast<std::size_t>(b.sources);
      work.source.resize(b.IsVector() ? n : n * components);
      gather(e, work.source);
      if (!b.IsVector())
      {
        b.parts[0].Apply(work.source, zeros, expansion.Coefficients(e), work.scratch);
        return;
      }
      for (int c = 0; c < components; ++c)
      {
        b.parts[c].Apply(
          work.source, std::span(zeros).first(1), Component(expansion, e, c), work.scratch);
      }
    });
  return expansion;
}

void AssembleMap(Bases basis, const Gather& gather,
  const std::function<std::string(std::size_t)>& describe, SolverMesh& mesh, double roundoff)
{
  Prepare(basis, &Same, mesh);
  const auto noise = NoiseOf(basis);
  ForElements(basis.size(),
    [&](std::size_t e, Work& work)
    {
      work.source.resize(3 * static_cast<std::size_t>(basis[e]->sources));
      gather(e, work.source);
      const ElementUnits units = UnitsOf(BoxOf(work.source, 3, describe, e), describe, e);
      const auto coefficients = mesh.map.Coefficients(e);
      basis[e]->parts[0].Apply(work.source, ShiftsOf(units, 3), coefficients, work.scratch);
      const double inUnits = std::ldexp(1.0, -units.exponent);
      for (double& value : coefficients)
      {
        value *= inUnits; // a power of two: exact
      }
      StoreUnits(units, noise.at(basis[e]), coefficients, roundoff, e, mesh);
    });
}

void AssemblePlaneMap(Bases basis, int components, const Gather& gather,
  const std::function<std::string(std::size_t)>& describe, SolverMesh& mesh, double roundoff)
{
  const Box all = BoxOfMesh(basis, components, gather, describe);
  const Slab slab = MakeSlab(all.low, all.high, kCoordinateRoundings * roundoff);
  mesh.slab = slab;
  Prepare(basis, &Lifted, mesh);
  const auto noise = NoiseOf(basis);
  if (slab.inSpace)
  {
    AssembleShell(basis, noise, gather, describe, mesh, roundoff);
    return;
  }
  ForElements(basis.size(),
    [&](std::size_t e, Work& work)
    {
      const ChangeOfBasis& change = basis[e]->parts[0];
      const auto n = static_cast<std::size_t>(basis[e]->sources);
      const auto modes = static_cast<std::size_t>(change.Target().Modes());
      work.source.resize(components * n);
      gather(e, work.source);
      Box box = BoxOf(work.source, components, describe, e);
      box.low.z = slab.middle - slab.thickness / 2;
      box.high.z = slab.middle + slab.thickness / 2;
      const ElementUnits units = UnitsOf(box, describe, e);
      std::vector<double> plane(2 * modes);
      change.Apply(std::span(work.source).first(2 * n), ShiftsOf(units, 2), plane, work.scratch);
      const auto inUnits = [&units](double x) { return std::ldexp(x, -units.exponent); };
      std::ranges::transform(plane, plane.begin(), inUnits);
      LiftMap(change.Target(), plane, inUnits(slab.middle - units.centre.z),
        inUnits(slab.thickness / 2), mesh.map.Coefficients(e));
      StoreUnits(units, noise.at(basis[e]), plane, roundoff, e, mesh);
    });
}

void DropRoundedOrders(Bases basis, double roundoff, SolverMesh& mesh)
{
  std::map<const ElementBasis*, RoundedOrders> rounded;
  for (std::size_t e = 0; e < basis.size(); ++e)
  {
    if (!rounded.contains(basis[e]))
    {
      rounded.try_emplace(basis[e], basis[e]->parts[0], mesh.map.SpaceOf(e), roundoff);
    }
  }
  std::vector<Space> kept(basis.size());
  ForElements(basis.size(),
    [&](std::size_t e, Work&)
    {
      const OrderReduction reduction = rounded.at(basis[e]).Of(mesh, e);
      kept[e] = reduction.Reduce();
      if (kept[e] != mesh.map.SpaceOf(e))
      {
        mesh.uncertainty[e] = mesh.size[e] * reduction.Uncertainty(kept[e]);
      }
    });
  OwnedExpansion reduced;
  reduced.Allocate(kept, 3);
  const std::size_t size = reduced.coefficients.size();
  // In place, since the maps may take most of the memory: each one moves towards the front.
  for (std::size_t e = 0; e < basis.size(); ++e)
  {
    const auto modes = rounded.at(basis[e]).Of(mesh, e).Keep(kept[e], 1.0);
    std::ranges::copy(modes, mesh.map.coefficients.begin() + reduced.offset[e]);
  }
  reduced.coefficients = std::move(mesh.map.coefficients);
  reduced.coefficients.Shrink(size);
  mesh.map = std::move(reduced);
}

void ScaleToSlab(const Slab& slab, SolverField& field)
{
  if (field.mapping != Mapping::Identity)
  {
    RequirePlane(slab, "'" + field.name + "': H(curl), H(div) and density fields");
  }
  if (field.mapping != Mapping::Contravariant && field.mapping != Mapping::Density)
  {
    return;
  }
  for (double& value : field.values.coefficients)
  {
    value *= slab.thickness / 2;
  }
}
} // namespace pixelexact
