// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/FaceTable.h"

#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace pixelexact
{
/// A face to which a solver's file gives a boundary attribute (MFEM) or composite (Nektar++).
struct AttributedFace
{
  ElementFace face;
  std::int32_t attribute = 0;

  auto operator<=>(const AttributedFace&) const = default;
};

/// Elements' faces by attribute: one between two elements counts twice.
std::map<std::int32_t, std::int64_t> CountByAttribute(std::span<const AttributedFace> faces);

/// The faces of one attribute, in their order. Throws InvalidData, naming the attributes that there
/// are, where it is none of them.
std::vector<ElementFace> FacesOfAttribute(
  std::span<const AttributedFace> faces, std::int32_t attribute);
} // namespace pixelexact
