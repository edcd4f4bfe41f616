// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/FoundJumps.h"

#include "Base/Report.h"
#include "Scene/Shot.h"

#include "Core/Base/Counted.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace pixelexact
{
FoundJumps::FoundJumps(const Shot& shot, Frame& frame)
  : Jumps(FindCutJumps(shot.scene, frame.centres))
  , Layers(shot.scene.layers.size())
  , SourceCells(shot.input.model->SourceCells())
{
}

std::array<std::int64_t, 2> FoundJumps::Cells() const
{
  std::array<std::int64_t, 2> cells{};
  std::ranges::transform(Jumps.largest->elements, cells.begin(),
    [this](std::int32_t element) { return SourceCells[static_cast<std::size_t>(element)]; });
  return cells;
}

void FoundJumps::AddTo(Table& table) const
{
  table.Row("jumps",
    "{} of neighbouring pixels jump, {} continuous, {} not finite, {} without a "
    "common face",
    Counted(Jumps.jumping, "pair"), Jumps.continuous, Jumps.notFinite, Jumps.notFound);
  if (!Jumps.largest)
  {
    return;
  }
  const CutJump& largest = *Jumps.largest;
  const auto [here, there] = Cells();
  const Vec3& at = largest.position;
  table.Row("", "largest {} at {}, {}, {}, between elements {} and {}{}", Short(largest.jump),
    Short(at.x), Short(at.y), Short(at.z), here, there,
    Layers > 1 ? fmt::format("; layer {}", largest.layer + 1) : std::string());
  table.Row("", "colours: yellow 0 to dark purple {}; light blue: continuous", Short(largest.jump));
}

void FoundJumps::AddTo(nlohmann::ordered_json& summary) const
{
  nlohmann::ordered_json& jumps = summary["jumps"];
  jumps = { { "jumping", Jumps.jumping }, { "continuous", Jumps.continuous },
    { "not_finite", Jumps.notFinite }, { "not_found", Jumps.notFound }, { "largest", nullptr } };
  if (Jumps.largest)
  {
    const Vec3& at = Jumps.largest->position;
    jumps["largest"] = { { "value", Jumps.largest->jump }, { "position", { at.x, at.y, at.z } },
      { "elements", Cells() }, { "layer", Jumps.largest->layer + 1 } };
  }
}
} // namespace pixelexact
