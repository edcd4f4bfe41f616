// SPDX-License-Identifier: BSD-3-Clause
#include "Input/OtherInputs.h"

#include "Base/Command.h"

#include "Core/Expression/Expression.h"
#include "HighOrderModel.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>

namespace pixelexact
{
namespace
{
/// The last parts of a path, as many as there are up to `count`.
std::string EndOf(const std::filesystem::path& path, int count)
{
  std::filesystem::path end = path.filename();
  std::filesystem::path folder = path.parent_path();
  for (int k = 1; k < count && folder.has_filename(); ++k)
  {
    end = folder.filename() / end;
    folder = folder.parent_path();
  }
  return end.string();
}
} // namespace

std::vector<InputRequest> RequestsWith(
  const InputRequest& first, const std::vector<std::vector<std::string>>& groups)
{
  std::vector<InputRequest> requests;
  requests.reserve(groups.size());
  for (const std::vector<std::string>& files : groups)
  {
    InputRequest request = first;
    request.files = files;
    if (std::ranges::all_of(files, HoldsFieldsAlone))
    {
      request.files.clear();
      std::ranges::copy_if(first.files, std::back_inserter(request.files),
        [](const std::string& file) { return !HoldsFieldsAlone(file); });
      request.files.insert(request.files.end(), files.begin(), files.end());
    }
    requests.push_back(std::move(request));
  }
  return requests;
}

std::vector<std::string> NamesOfInputs(const std::vector<InputRequest>& requests)
{
  constexpr int kMaxParts = 8;
  std::vector<std::string> names(requests.size());
  for (int parts = 1; parts <= kMaxParts; ++parts)
  {
    std::ranges::transform(requests, names.begin(),
      [parts](const InputRequest& request)
      {
        const auto path = std::filesystem::absolute(request.files.back()).lexically_normal();
        return EndOf(path, parts);
      });
    if (std::set<std::string>(names.begin(), names.end()).size() == names.size())
    {
      return names;
    }
  }
  // The same file may be there several times.
  for (std::size_t k = 0; k < names.size(); ++k)
  {
    names[k] = EndOf(requests[k].files.back(), 1) + " (" + std::to_string(k + 1) + ")";
  }
  return names;
}

void OtherInputs::AddTo(CLI::App& command)
{
  Bind(command, "--with", Groups);
}

std::vector<InputRequest> OtherInputs::RequestsAfter(const InputRequest& first) const
{
  std::vector<InputRequest> requests = RequestsWith(first, Groups);
  requests.insert(requests.begin(), first);
  return requests;
}

std::vector<std::string> OtherInputs::Files() const
{
  std::vector<std::string> files;
  for (const std::vector<std::string>& group : Groups)
  {
    files.insert(files.end(), group.begin(), group.end());
  }
  return files;
}

const Field& FieldNamedOrOnly(
  const HighOrderModel& model, const std::string& text, const std::string& name)
{
  if (!IsMoreThanName(text) && model.Fields().size() == 1 && model.FindField(text) == nullptr)
  {
    return model.Fields().front();
  }
  try
  {
    return model.GetField(text);
  }
  catch (const Error& error)
  {
    throw Error("'" + name + "': " + error.what());
  }
}
} // namespace pixelexact
