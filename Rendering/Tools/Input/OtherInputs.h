// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/Input.h"

#include <string>
#include <vector>

namespace CLI
{
class App;
} // namespace CLI

namespace pixelexact
{
class HighOrderModel;
struct Field;

/// The requests of the inputs that --with names, a group of files each. They are as `first` in all
/// but the files; where a group contains fields only, its mesh is that of `first`.
std::vector<InputRequest> RequestsWith(
  const InputRequest& first, const std::vector<std::vector<std::string>>& groups);

/// A name for each input: that of its last file, with as many of its folders as distinguish all of
/// them. Where a file is there several times, names are numbered.
std::vector<std::string> NamesOfInputs(const std::vector<InputRequest>& requests);

/// --with of commands that compute the same numbers of several inputs.
class OtherInputs
{
public:
  void AddTo(CLI::App& command);
  [[nodiscard]] bool IsEmpty() const { return Groups.empty(); }
  /// INPUT, then the others in their order.
  [[nodiscard]] std::vector<InputRequest> RequestsAfter(const InputRequest& first) const;
  /// All files of the others.
  [[nodiscard]] std::vector<std::string> Files() const;

private:
  std::vector<std::vector<std::string>> Groups;
};

/// The field of this name, or, where there is none and `text` is no expression, the only one, whose
/// name may be that of its file. `name`: of the input. Throws Error, naming input and fields.
const Field& FieldNamedOrOnly(
  const HighOrderModel& model, const std::string& text, const std::string& name);
} // namespace pixelexact
