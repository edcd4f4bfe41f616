// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Elements/Collection.h"

#include "Core/Base/Error.h"
#include "Core/Basis/Space.h"
#include "Formats/MFEM/Elements/CollectionName.h"
#include "Formats/MFEM/Elements/ElementBases.h"
#include "Formats/MFEM/Elements/UnknownOrders.h"

#include <array>
#include <mutex>
#include <optional>
#include <vector>

namespace pixelexact::mfem
{
namespace
{
/// Limit of orders for dense bases, which take minutes to compute above it.
int LargestOrder(const CollectionName& name, Geometry solid)
{
  if (name.continuity == Continuity::HCurl || name.continuity == Continuity::HDiv)
  {
    switch (solid)
    {
      case Geometry::Cube:
        return name.continuity == Continuity::HDiv ? kMaxOrder : 8;
      case Geometry::Prism:
      case Geometry::Triangle:
      case Geometry::Square:
        return 16;
      case Geometry::Pyramid:
        return 6;
      default:
        return 8;
    }
  }
  switch (solid)
  {
    case Geometry::Cube:
    case Geometry::Square:
      return kMaxOrder;
    case Geometry::Pyramid:
      return name.continuity == Continuity::H1 ? 8 : 12;
    default:
      return 16;
  }
}

std::size_t At(Geometry geometry)
{
  return static_cast<std::size_t>(geometry);
}

const char* PluralOf(Geometry geometry)
{
  static constexpr std::array kNames{ "points", "segments", "triangles", "squares", "tetrahedra",
    "cubes", "prisms", "pyramids" };
  return kNames.at(At(geometry));
}

/// The collections of fixed order are not defined on all shapes.
bool IsDefined(const CollectionName& name, Geometry solid)
{
  if (!name.legacy || solid == Geometry::Cube || name.dimension == 2)
  {
    return true;
  }
  if (name.continuity == Continuity::HDiv)
  {
    return name.order == 0;
  }
  if (solid == Geometry::Tetrahedron || name.order <= 1)
  {
    return true;
  }
  return solid == Geometry::Prism && name.shared;
}

ElementBasis MakeBasis(const CollectionName& name, Geometry solid)
{
  if (!IsDefined(name, solid))
  {
    throw Unsupported("MFEM defines the finite element collection '" + name.text +
      "' on other shapes than " + PluralOf(solid) + ".");
  }
  const int largest = LargestOrder(name, solid);
  if (name.order > largest)
  {
    throw Unsupported("the finite element collection '" + name.text + "' on " + PluralOf(solid) +
      ": orders above " + std::to_string(largest) +
      " are refused there; project the field to a lower order in MFEM (ProjectGridFunction).");
  }
  if (name.continuity == Continuity::HCurl || name.continuity == Continuity::HDiv)
  {
    return VectorBasis(name, solid);
  }
  return solid == Geometry::Pyramid ? PyramidBasis(name) : ScalarBasis(name, solid);
}
} // namespace

struct Collection::Internals
{
  CollectionName name;
  std::array<int, kGeometries> unknowns{};
  std::array<std::vector<std::vector<int>>, kGeometries> orders;
  std::array<std::optional<ElementBasis>, kGeometries> bases;
  std::mutex making;
};

Collection::Collection()
  : Data(std::make_unique<Internals>())
{
}

Collection::Collection(Collection&&) noexcept = default;
Collection& Collection::operator=(Collection&&) noexcept = default;
Collection::~Collection() = default;

Collection Collection::Parse(const std::string& name, int dimension)
{
  Collection collection;
  auto& data = *collection.Data;
  data.name = ParseCollectionName(name, dimension);
  for (int g = 0; g < kGeometries; ++g)
  {
    const auto geometry = static_cast<Geometry>(g);
    data.unknowns[g] = EntityUnknowns(data.name, geometry);
    for (int o = 0; o < Orientations(geometry); ++o)
    {
      data.orders[g].push_back(EntityOrder(data.name, geometry, o));
    }
  }
  return collection;
}

Continuity Collection::GetContinuity() const
{
  return Data->name.continuity;
}

Mapping Collection::GetMapping() const
{
  switch (GetContinuity())
  {
    case Continuity::HCurl:
      return Mapping::Covariant;
    case Continuity::HDiv:
      return Mapping::Contravariant;
    default:
      return Data->name.integral ? Mapping::Density : Mapping::Identity;
  }
}

bool Collection::IsVector() const
{
  return GetContinuity() == Continuity::HCurl || GetContinuity() == Continuity::HDiv;
}

int Collection::Order() const
{
  return Data->name.order;
}

std::string Collection::Description() const
{
  static constexpr std::array kSpaces{ "H1", "H(curl)", "H(div)", "L2" };
  std::string text = kSpaces.at(static_cast<std::size_t>(GetContinuity()));
  text += " of order " + std::to_string(Order()) + ", " + Describe(Data->name.closed);
  if (IsVector())
  {
    text += " and " + Describe(Data->name.open);
  }
  return Data->name.integral ? text + ", densities" : text;
}

int Collection::Unknowns(Geometry geometry) const
{
  return Data->unknowns.at(At(geometry));
}

std::span<const int> Collection::UnknownOrder(Geometry geometry, int orientation) const
{
  const int o = geometry == Geometry::Segment ? (orientation > 0 ? 0 : 1)
                                              : orientation % Orientations(geometry);
  return Data->orders.at(At(geometry)).at(o);
}

bool Collection::MixesTriangleUnknowns() const
{
  return GetContinuity() == Continuity::HCurl && Order() > 1;
}

std::array<double, 4> Collection::TriangleMixing(int orientation) const
{
  return TangentMixing(orientation % Orientations(Geometry::Triangle));
}

const ElementBasis& Collection::Basis(Geometry solid) const
{
  const std::scoped_lock lock(Data->making);
  auto& basis = Data->bases.at(At(solid));
  if (!basis)
  {
    basis = MakeBasis(Data->name, solid);
  }
  return *basis;
}
} // namespace pixelexact::mfem
