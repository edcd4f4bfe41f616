// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Options.h"

#include "Trace/Volume/Volume.h"

#include <optional>
#include <string>

namespace pixelexact
{
class ColorOptions;
class HighOrderModel;

/// Options of a volume.
class VolumeOptions
{
public:
  void AddTo(CLI::App& command);

  [[nodiscard]] bool IsAsked() const { return !name_.empty(); }
  /// The field as it was named, perhaps with a component.
  [[nodiscard]] const std::string& Name() const { return name_; }

  /// Throws UsageError for options that a volume excludes, for those that have no effect where it
  /// is `alone`, without a surface, and for colours that do not exist.
  void Check(bool alone) const;

  /// The volume of a model. A map by name is spread over the range of `colors` where that has
  /// ends, else over the proven range of the field. Throws Error where the field or the file cannot
  /// be used.
  [[nodiscard]] Volume Make(
    const HighOrderModel& model, const ColorOptions& colors, bool alone) const;

private:
  const CLI::App* Command = nullptr;
  std::string name_;
  std::string transfer_ = "viridis";
  std::optional<double> unit_;
};
} // namespace pixelexact
