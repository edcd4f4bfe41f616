// SPDX-License-Identifier: BSD-3-Clause
#include "Input/BlockInput.h"
#include "Input/Format.h"
#include "Input/NativeInput.h"
#include "Input/VtkInput.h"

#include <array>

namespace pixelexact
{
namespace
{
constexpr std::array kFormats = std::to_array<Format>({
#include "FormatRows.inc"
});
} // namespace

std::span<const Format> Formats()
{
  return kFormats;
}
} // namespace pixelexact
