// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Report.h"

#include "Core/Element/MeshRanges.h"
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
  bool isExpression = false;
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

/// Certifies fields, expressions included, or with no name every field of the model that is none.
/// Parallel, with progress on stderr. Throws Error for a name that is none, and for expressions
/// whose ranges cannot be proven.
CertifiedFacts Certify(const LoadedModel& input, const std::vector<std::string>& names);

void AddTo(Table& table, const CertifiedFacts& facts);
/// Adds the members "jacobian", "certify_seconds" and, where there are any, "expressions".
void AddTo(nlohmann::ordered_json& summary, const CertifiedFacts& facts);
/// Returns a field's member "certified".
nlohmann::ordered_json ToJson(const CertifiedField& field);
} // namespace pixelexact
