// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Report.h"

#include "Core/Element/Validity.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// Results of `info --certify`: proven ranges of the fields, of their gradients and of det J.
namespace pixelexact
{
struct LoadedModel;

struct CertifiedField
{
  std::string name;
  std::vector<MeshRange> components;
  std::optional<MeshRange> magnitude; ///< of vectors
  std::optional<MeshRange> gradient;  ///< magnitude of the gradient, of scalars
  bool gradientIsAnswerable = true;
};

struct CertifiedFacts
{
  std::vector<CertifiedField> fields;
  MeshRange jacobian;
  std::array<std::int64_t, 3> count{}; ///< elements by Validity
  /// The first elements that are not valid, by number of their cell in the file.
  std::array<std::vector<std::int64_t>, 3> first;
  double seconds = 0.0;
};

/// Certifies every field of the model. Parallel, with progress on stderr.
CertifiedFacts Certify(const LoadedModel& input);

void AddTo(Table& table, const CertifiedFacts& facts);
/// Adds the members "jacobian" and "certify_seconds".
void AddTo(nlohmann::ordered_json& summary, const CertifiedFacts& facts);
/// Returns a field's member "certified".
nlohmann::ordered_json ToJson(const CertifiedField& field);
} // namespace pixelexact
