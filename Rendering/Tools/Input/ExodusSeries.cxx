// SPDX-License-Identifier: BSD-3-Clause
#include "Input/ExodusSeries.h"

#include "Base/Command.h"
#include "Input/BlockInput.h"

#include "Files/ExodusGrid.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <numeric>

namespace pixelexact
{
namespace
{
void RequireExodus(const std::string& file)
{
  constexpr std::array<std::string_view, 4> kMarks{ "CDF\x01", "CDF\x02", "CDF\x05", kHdf5Mark };
  RequireMark(file, kMarks, "Exodus II file (netCDF)");
}

} // namespace

std::vector<ExodusName> MeshesOf(const std::vector<std::string>& files)
{
  std::map<int, ExodusName> meshes;
  for (const std::string& file : files)
  {
    const auto name = ParseExodusName(file);
    if (!name)
    {
      throw UsageError("'" + files[0] + "' holds mesh and fields, and '" + file +
        "' is no other part or mesh of it; name one file alone");
    }
    const auto [at, isNew] = meshes.try_emplace(name->mesh, *name);
    const ExodusName& first = meshes.begin()->second;
    if (name->first != first.first || name->parts != first.parts ||
      (!isNew && (name->parts == 0 || at->second.meshSuffix != name->meshSuffix)))
    {
      throw UsageError("'" + files[0] + "' and '" + file +
        "' are no meshes of one series (out.e, out.e-s002, ...) and no parts of one mesh "
        "(out.e.4.0, out.e.4.1, ...); name one file alone");
    }
  }
  std::vector<ExodusName> ordered;
  std::ranges::transform(
    meshes, std::back_inserter(ordered), [](const auto& entry) { return entry.second; });
  return ordered;
}

ExodusStep ChooseStep(
  const std::vector<ExodusName>& meshes, const InputRequest& request, InputGrid& input)
{
  std::vector<ExodusStep> steps;
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh)
  {
    const std::vector<std::string> files = PartsOf(meshes[mesh]);
    std::ranges::for_each(files, &RequireExodus);
    const std::vector<double> times = ExodusTimes(files.front());
    input.times.insert(input.times.end(), times.begin(), times.end());
    for (std::size_t own = 0; own < std::max(times.size(), std::size_t{ 1 }); ++own)
    {
      steps.push_back({ mesh, own });
    }
  }
  if (meshes.size() > 1 &&
    (input.times.size() != steps.size() ||
      std::ranges::adjacent_find(input.times, std::greater_equal()) != input.times.end()))
  {
    input.times.resize(steps.size());
    std::iota(input.times.begin(), input.times.end(), 0.0);
    input.notes.push_back("'" + request.files[0] +
      "': the times of its meshes do not ascend; numbers of steps stand for them.");
  }
  input.step = ChooseStep(request, input.times);
  return steps[static_cast<std::size_t>(input.step)];
}

void NoteOtherMeshes(const ExodusName& only, std::vector<std::string>& notes)
{
  std::error_code failure;
  const std::string next = only.first + "-s002" +
    (only.parts > 0 ? "." + only.partsText + "." + std::string(only.digits, '0') : "");
  if (only.mesh == 1 && std::filesystem::exists(next, failure))
  {
    notes.push_back("'" + next + "' continues '" + only.first +
      "' on another mesh; name both, and what follows, for all time steps.");
  }
}
} // namespace pixelexact
