// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Flexi/Series.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"
#include "Formats/Flexi/MeshFile.h"
#include "Formats/Flexi/StateFile.h"
#include "Formats/Hdf5/Hdf5File.h"

#include <algorithm>
#include <filesystem>

namespace pixelexact::flexi
{
namespace
{
/// The path of a state's mesh.
std::string FindMesh(const std::string& state, const std::string& named)
{
  if (named.empty())
  {
    throw InvalidData(state +
      ": it does not name its mesh (MeshFile); name the mesh before it: x_mesh.h5 " +
      std::filesystem::path(state).filename().string() + ".");
  }
  const std::filesystem::path path(named);
  const std::filesystem::path folder = std::filesystem::path(state).parent_path();
  for (const auto& candidate : { folder / path.filename(), folder / path })
  {
    std::error_code failure;
    if (std::filesystem::is_regular_file(candidate, failure))
    {
      return candidate.string();
    }
  }
  throw InvalidData(state + ": its mesh '" + path.filename().string() +
    "' is not in its folder; copy it there, or name it before the state.");
}
} // namespace

bool IsFile(const std::string& path)
{
  try
  {
    const auto file = OpenHdf5(path);
    return IsMesh(*file) || IsState(*file);
  }
  catch (const std::exception&)
  {
    return false; // the reader reports it
  }
}

Series::Series(const std::vector<std::string>& files)
{
  std::string mesh;
  std::vector<std::string> wanted; ///< of the states
  for (const std::string& name : files)
  {
    const auto file = OpenHdf5(name);
    if (IsState(*file))
    {
      const StateHead head = ReadHead(*file, name);
      States.push_back({ name, {}, head.time });
      wanted.push_back(head.mesh);
      for (const std::string& variable : head.variables)
      {
        if (std::ranges::find(Names, variable) == Names.end())
        {
          Names.push_back(variable);
        }
      }
    }
    else if (!IsMesh(*file))
    {
      throw InvalidData(name +
        ": it is neither a state of FLEXI (DG_Solution) nor a mesh of HOPR (ElemInfo, NodeCoords); "
        "name a file x_State_*.h5 or x_mesh.h5.");
    }
    else if (!mesh.empty())
    {
      throw InvalidData(std::string(name)
                          .append(": it is a second mesh beside ")
                          .append(mesh)
                          .append("; name one mesh."));
    }
    else
    {
      mesh = name;
    }
  }
  for (std::size_t i = 0; i < States.size(); ++i)
  {
    States[i].mesh = mesh.empty() ? FindMesh(States[i].file, wanted[i]) : mesh;
  }
  OnlyMesh = States.empty() ? mesh : "";
  std::ranges::stable_sort(States, {}, &State::time);
  for (const State& state : States)
  {
    TimeOf.push_back(state.time);
  }
}

int Series::StepOfMesh(int step) const
{
  if (States.empty())
  {
    return 0;
  }
  const std::string& mesh = States[static_cast<std::size_t>(step)].mesh;
  return static_cast<int>(std::ranges::find(States, mesh, &State::mesh) - States.begin());
}

SolverModel Series::Read(int step, bool wantMesh) const
{
  SolverModel model;
  if (States.empty())
  {
    model.mesh = ReadMesh(*OpenHdf5(OnlyMesh), OnlyMesh);
    return model;
  }
  const State& state = States[static_cast<std::size_t>(step)];
  const auto file = OpenHdf5(state.file);
  const StateHead head = ReadHead(*file, state.file);
  const auto mesh = OpenHdf5(state.mesh);
  if (const std::int64_t elements = CountElements(*mesh); elements != head.elements)
  {
    throw InvalidData(state.file + ": it has " + Counted(head.elements, "element") + ", but " +
      state.mesh + " has " + std::to_string(elements) + "; name the mesh of the run before it.");
  }
  if (wantMesh)
  {
    model.mesh = ReadMesh(*mesh, state.mesh);
  }
  ReadFields(*file, head, state.file, model);
  model.time = head.time;
  return model;
}
} // namespace pixelexact::flexi
