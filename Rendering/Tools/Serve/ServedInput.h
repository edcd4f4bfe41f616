// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/Input.h"
#include "Scene/Model.h"

#include <cstddef>
#include <list>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace pixelexact
{
/// The input of a server, which all pages share. Time steps and deformations are read and computed
/// when a page shows them; the last few are kept. For one thread.
class ServedInput
{
public:
  /// Number of models that are kept besides those that pages show.
  static constexpr std::size_t kKept = 4;
  /// Number of expressions of a model, which are kept as long as the model. A model with more is
  /// replaced.
  static constexpr std::size_t kMaxExpressions = 100;

  /// Reads the request's time step, with all of its fields. Throws Error.
  explicit ServedInput(const InputRequest& request);

  /// The input at the time step, and with the deformation and truncation, of a request, whose files
  /// must be those of the first one. `expressions`: fields that will be shown or define surfaces.
  /// Throws Error.
  [[nodiscard]] LoadedModel Get(
    const InputRequest& request, const std::vector<std::string>& expressions);

  [[nodiscard]] const std::vector<double>& Times() const { return times_; }
  [[nodiscard]] int FirstStep() const { return FirstStep_; }

private:
  struct Kept
  {
    int step = 0;
    std::string change; ///< of the mesh; empty: none
    LoadedModel model;
    std::set<std::string> expressions;
  };

  [[nodiscard]] int StepOf(const InputRequest& request) const;
  Kept& Find(const InputRequest& request, int step);
  Kept& Keep(Kept kept);
  /// The model creates the fields of these expressions. Replaces a model that has too many.
  static void Count(Kept& kept, const std::vector<std::string>& expressions);

  std::list<Kept> Models; ///< the last used one is the first
  std::vector<double> times_;
  int FirstStep_ = 0;
};
} // namespace pixelexact
