// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Gmsh/Reader.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Formats/Assembly.h"
#include "Formats/Gmsh/FileSet.h"
#include "Formats/Gmsh/MeshFile.h"
#include "Formats/Gmsh/Views.h"

#include <algorithm>

namespace pixelexact::gmsh
{
namespace
{
void RequireElements(const MeshFile& mesh, bool surfaces, const std::string& file)
{
  if (mesh.elements.empty() && surfaces)
  {
    throw InvalidData(
      file + ": the mesh has no triangles and no quadrilaterals; leave out --surface-elements.");
  }
  if (mesh.elements.empty())
  {
    throw Unsupported(file +
      ": the mesh has no tetrahedra, hexahedra, prisms or pyramids, no triangles and no "
      "quadrilaterals" +
      (mesh.lower > 0 ? ", but " + Counted(mesh.lower, "element") + " of curves and points" +
            "; where the model has a volume, mesh it (gmsh -3), and where there are physical "
            "groups, put the volume in one or set Mesh.SaveAll = 1."
                      : "; there is nothing to show."));
  }
}

/// Where a file has no physical groups of a dimension, entities replace them.
bool HasPhysical(const auto& elements)
{
  return std::ranges::any_of(elements, [](const auto& e) { return e.physical != 0; });
}

void AddGroups(const MeshFile& mesh, bool boundary, std::vector<Group>& groups)
{
  std::map<std::int32_t, std::string> names;
  const auto note = [&names](const auto& elements)
  {
    for (const auto& element : elements)
    {
      if (element.physical != 0)
      {
        names[element.physical];
      }
    }
  };
  boundary ? note(mesh.faces) : note(mesh.elements);
  for (const PhysicalName& name : mesh.names)
  {
    if (name.dimension == mesh.dimension - (boundary ? 1 : 0) ||
      (name.dimension == kAnyDimension && names.contains(name.tag)))
    {
      names[name.tag] = name.name;
    }
  }
  for (const auto& [id, name] : names)
  {
    groups.push_back({ id, name, boundary });
  }
}

Corners CornersOf(const MeshFile& mesh, const Solid& element)
{
  Corners corners{};
  const auto count = static_cast<std::size_t>(element.type->corners);
  std::copy_n(mesh.NodesOf(element).begin(), count, corners.begin());
  if (element.type->dimension == 2)
  {
    // Copies the corners below the slab to those above.
    std::copy_n(corners.begin(), count, corners.begin() + count);
  }
  return corners;
}

void AddMesh(const MeshFile& mesh, bool surfaces, BasisTable& bases, const std::string& file,
  SolverModel& model)
{
  std::vector<const ElementBasis*> basis;
  basis.reserve(mesh.elements.size());
  for (const Solid& element : mesh.elements)
  {
    basis.push_back(NameErrors(file, [&] { return &bases.Nodal(*element.type); }));
  }
  const auto gather = [&](std::size_t e, std::span<double> source)
  {
    const auto nodes = mesh.NodesOf(mesh.elements[e]);
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      for (std::size_t d = 0; d < 3; ++d)
      {
        source[d * nodes.size() + i] = mesh.positions[3 * static_cast<std::size_t>(nodes[i]) + d];
      }
    }
  };
  const auto describe = [&](std::size_t e)
  { return file + ": element " + std::to_string(mesh.elements[e].number); };
  if (mesh.dimension == 3)
  {
    AssembleMap(basis, gather, describe, model.mesh);
  }
  else
  {
    AssemblePlaneMap(basis, 3, gather, describe, model.mesh);
    if (model.mesh.slab->inSpace && !surfaces)
    {
      model.notes.push_back(file +
        ": its elements are triangles and quadrilaterals on a surface in space. Where the model "
        "has "
        "a volume, mesh it (gmsh -3), and where there are physical groups, put the volume in one "
        "or "
        "set Mesh.SaveAll = 1.");
    }
  }
  const bool byEntity = !HasPhysical(mesh.elements);
  for (const Solid& element : mesh.elements)
  {
    model.mesh.number.push_back(element.number);
    model.mesh.corners.push_back(CornersOf(mesh, element));
    model.mesh.attribute.push_back(byEntity ? element.entity : element.physical);
  }
  std::size_t strangers = 0;
  model.mesh.boundary = FindFaces(mesh, !HasPhysical(mesh.faces), strangers);
  AddGroups(mesh, false, model.mesh.groups);
  AddGroups(mesh, true, model.mesh.groups);
  if (strangers > 0)
  {
    model.notes.push_back(file + ": " + Counted(strangers, "element") + " of " +
      (mesh.dimension == 3 ? "surfaces" : "curves") +
      " with attributes are no face of an element of a " +
      (mesh.dimension == 3
          ? "volume; --surface-elements reads the surfaces in place of the volumes."
          : "surface."));
  }
  if (mesh.inSeveralGroups > 0)
  {
    model.notes.push_back(file + ": " + Counted(mesh.inSeveralGroups, "element") +
      " in several physical groups; Attribute is the first of them.");
  }
  // A single partition number does not imply others: version 2.2 does not give their number.
  if (!mesh.partitionsHere.empty() && mesh.partitionsHere.size() < mesh.partitions)
  {
    model.notes.push_back(file + ": it holds " + Counted(mesh.partitionsHere.size(), "partition") +
      " of a mesh of " + std::to_string(mesh.partitions) +
      " that it names; what is shown is not the whole mesh. Save it in one file "
      "(Mesh.PartitionSplitMeshFiles = "
      "0).");
  }
}
} // namespace

std::vector<double> ReadTimes(const std::vector<NamedText>& files, std::size_t pieces)
{
  return StepsOf(FileSet(files, pieces).Views.Views()).times;
}

SolverModel Read(
  const std::vector<NamedText>& files, int step, bool wantMesh, std::size_t pieces, bool surfaces)
{
  FileSet set(files, pieces);
  SolverModel model;
  model.notes = set.Notes;
  const std::string& file = files.front().name;
  MeshFile mesh = set.ReadMesh(surfaces);
  RequireElements(mesh, surfaces, file);
  BasisTable bases;
  if (wantMesh)
  {
    AddMesh(mesh, surfaces, bases, file, model);
  }
  std::vector<double>().swap(mesh.positions); // with their memory
  const StepList steps = StepsOf(set.Views.Views());
  if (steps.numbered && steps.numbers.size() > 1)
  {
    model.notes.push_back(file +
      ": the times of its views do not ascend with their steps; the steps' numbers stand for "
      "them.");
  }
  if (!steps.numbers.empty())
  {
    const auto last = static_cast<int>(steps.numbers.size()) - 1;
    const std::int64_t number = steps.numbers[static_cast<std::size_t>(std::clamp(step, 0, last))];
    for (const View& view : set.Views.Views())
    {
      AddView(set.Scanners, view, number, mesh, bases, model);
    }
  }
  return model;
}
} // namespace pixelexact::gmsh
