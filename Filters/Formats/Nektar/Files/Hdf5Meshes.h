// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/FileText.h"

#include <vector>

namespace pixelexact::nektar
{
/// The HDF5 files that sessions name as their GEOMETRY and that are not among them, where they lie
/// beside the session. Those that do not are left to the parser's message.
std::vector<std::string> MissingMeshes(const std::vector<NamedText>& sessions);
} // namespace pixelexact::nektar
