// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nek5000/Reader.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Core/Element/ElementUnits.h"
#include "Core/Math/Rounding.h"
#include "Formats/Assembly.h"
#include "Formats/Nek5000/StepElements.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace pixelexact::nek5000
{
namespace
{
/// Lagrange's polynomials of the Gauss-Lobatto-Legendre nodes, of which x is the fastest.
ElementBasis BasisOf(const Header& header)
{
  const auto [nx, ny, nz] = header.nodes;
  Space space = UniformSpace(Shape::Hexahedron, 1);
  for (std::size_t d = 0; d < 3; ++d)
  {
    space.order[d] = static_cast<std::uint8_t>(header.nodes[d] - 1);
  }
  std::vector<int> source;
  source.reserve(static_cast<std::size_t>(header.NodesOfElement()));
  for (int i = 0; i < nx; ++i)
  {
    for (int j = 0; j < ny; ++j)
    {
      for (int k = 0; k < nz; ++k)
      {
        source.push_back(i + nx * (j + ny * k));
      }
    }
  }
  ElementBasis basis;
  basis.parts.push_back(ChangeOfBasis::Hexahedron(space, Family::GaussLobattoLagrange, source));
  basis.sources = header.NodesOfElement();
  return basis;
}

void AddMesh(const StepElements& elements, SolverMesh& mesh)
{
  const Header& header = elements.GetHeader();
  const int dimension = header.Dimension();
  const ElementBasis basis = BasisOf(header);
  const std::vector<const ElementBasis*> bases(elements.Count(), &basis);
  const auto gather = [&](std::size_t e, std::span<double> source) {
    elements.Gather({ 0, dimension }, e, source);
  };
  const auto describe = [&](std::size_t e) { return elements.Describe(e); };
  const double roundoff = elements.IsSingle() ? kFloatRoundoff : kUnitRoundoff;
  if (dimension == 3)
  {
    AssembleMap(bases, gather, describe, mesh, roundoff);
  }
  else
  {
    AssemblePlaneMap(bases, 2, gather, describe, mesh, roundoff);
  }
  DropRoundedOrders(bases, roundoff, mesh);
  // Files do not contain which elements share a vertex, so each element has its own.
  for (std::size_t e = 0; e < elements.Count(); ++e)
  {
    mesh.number.push_back(static_cast<std::int64_t>(e) + 1);
    Corners corners{};
    for (std::size_t c = 0; c < corners.size(); ++c)
    {
      const std::size_t corner = dimension == 3 ? c : c % 4;
      corners[c] = static_cast<std::int64_t>(corners.size() * e + corner);
    }
    mesh.corners.push_back(corners);
  }
}

/// Adds the fields of a step one after the other, in the order of the file.
class FieldReader
{
public:
  FieldReader(const StepElements& elements, const std::string& file, SolverModel& model)
    : Elements(elements)
    , Basis(BasisOf(elements.GetHeader()))
    , Bases(elements.Count(), &Basis)
    , Name(file)
    , Model(model)
  {
  }

  void Add(const std::string& name, int components)
  {
    const Block block{ Before, components };
    Before += components;
    std::atomic<std::size_t> undefined = 0;
    SolverField field;
    field.name = name;
    field.basis = "Nek5000, Gauss-Lobatto-Legendre nodes";
    field.values = AssembleField(Bases, components,
      [&](std::size_t e, std::span<double> source)
      {
        Elements.Gather(block, e, source);
        if (!std::ranges::all_of(source, [](double value) { return std::isfinite(value); }))
        {
          std::ranges::fill(source, std::numeric_limits<double>::quiet_NaN());
          ++undefined;
        }
      });
    if (undefined > 0)
    {
      Model.notes.push_back(Name + ": the field '" + name + "' is NaN or infinite at nodes of " +
        std::to_string(undefined) + " of " + Counted(Elements.Count(), "element") +
        "; it is NaN there. Where the run has diverged, use an earlier step.");
    }
    Elements.Forget();
    Model.fields.push_back(std::move(field));
  }

  /// Passes over values.
  void Skip(int components) { Before += components; }

private:
  const StepElements& Elements;
  ElementBasis Basis;
  std::vector<const ElementBasis*> Bases;
  const std::string& Name;
  SolverModel& Model;
  int Before = 0;
};
} // namespace

SolverModel Read(const std::vector<NamedText>& step, const std::vector<NamedText>& mesh)
{
  SolverModel model;
  if (!mesh.empty())
  {
    const StepElements elements(mesh);
    if (!elements.GetHeader().hasMesh)
    {
      throw InvalidData(mesh.front().name + ": the file has no mesh (X).");
    }
    AddMesh(elements, model.mesh);
    elements.Forget();
  }
  const std::string& file = step.front().name;
  const StepElements elements(step);
  const Header& header = elements.GetHeader();
  FieldReader fields(elements, file, model);
  fields.Skip(header.hasMesh ? header.Dimension() : 0);
  for (const HeaderField& field : header.Fields())
  {
    if (field.isRead)
    {
      fields.Add(field.name, field.components);
      continue;
    }
    model.notes.push_back(file + ": the " + field.name +
      " has values at other nodes than the velocity (a file for restarts) and is left out; write "
      "it with if_full_pres = .false.");
    fields.Skip(field.components);
  }
  return model;
}
} // namespace pixelexact::nek5000
