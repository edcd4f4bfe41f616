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

/// What of the exact picture is given up to be faster, and told with it: --stride,
/// --truncate-order.
class QualityOptions
{
public:
  /// The order is set in the shot's input.
  void AddTo(CLI::App& command, ShotOptions& shot);

  /// Pixels across a block that is traced once; 1: each is.
  [[nodiscard]] int Stride() const { return stride_; }
  /// Throws UsageError for options that ask for more than blocks have.
  void Check(const CLI::App& command) const;

private:
  int stride_ = 1;
};

/// A component of a field that a shot shows without its top modes.
struct TruncatedField
{
  std::string name;
  std::string component; ///< as ComponentName tells
  int order = 0;
  std::int64_t modes = 0;   ///< of a component, in all elements
  std::int64_t dropped = 0; ///< of them
  double change = 0.0;      ///< proven bound of how far values moved; infinite: none was found
};

/// Those of a shot's layers, each once. Bounds the changes, which takes a while and shows how far
/// it is.
std::vector<TruncatedField> TruncatedFields(const Shot& shot);

/// What was given up for a picture.
struct QualityFacts
{
  int stride = 1;
  std::vector<TruncatedField> fields;

  /// One line for each; none: nothing.
  [[nodiscard]] std::vector<std::string> Texts() const;
  void AddTo(Table& table) const;
  void AddTo(nlohmann::ordered_json& summary) const;
};

/// Replaces all fields of an input by what is left of them at an order.
void Truncate(LoadedModel& input, int order);
} // namespace pixelexact
