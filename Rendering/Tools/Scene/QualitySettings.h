// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Truncation.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace CLI
{
class App;
} // namespace CLI

namespace pixelexact
{
class Table;
struct LoadedModel;
struct Shot;
struct ShotOptions;

/// Options that give up exactness for speed and are reported with the picture: --stride,
/// --truncate-order.
class QualityOptions
{
public:
  /// The order is stored in the shot's input.
  void AddTo(CLI::App& command, ShotOptions& shot);

  /// Side in pixels of a block that is traced once; 1: each pixel is traced.
  [[nodiscard]] int Stride() const { return stride_; }
  /// Throws UsageError for options that blocks do not support.
  void Check(const CLI::App& command) const;

private:
  int stride_ = 1;
};

/// A component of a field that a shot shows without its top modes.
struct TruncatedField
{
  std::string name;
  std::string component; ///< as in ComponentName
  int order = 0;
  std::int64_t modes = 0;   ///< of a component, in all elements
  std::int64_t dropped = 0; ///< number of dropped modes
  double change = 0.0;      ///< proven bound of the change of values; infinite: none was found
};

/// The truncated fields of a shot's layers, each once. Bounding the changes takes a while and shows
/// its progress.
std::vector<TruncatedField> TruncatedFields(const Shot& shot);

/// The losses of exactness in a picture.
struct QualityFacts
{
  int stride = 1;
  std::vector<TruncatedField> fields;

  /// One line for each; empty: nothing was given up.
  [[nodiscard]] std::vector<std::string> Texts() const;
  void AddTo(Table& table) const;
  void AddTo(nlohmann::ordered_json& summary) const;
};

/// Truncates all fields of an input to an order.
void Truncate(LoadedModel& input, int order);
} // namespace pixelexact
