// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/MeshBuilder.h"

#include "Core/Faces/FaceTable.h"
#include "Core/Location/Locator.h"
#include "Trace/Camera.h"

#include <functional>
#include <memory>

namespace pixelexact::testing
{
/// Two hexahedra side by side along x, bent alike: x = g(y, z) parts them. The one at lower x is 2
/// high and wide; the other one is `part` of that, in the middle. The first may be the second
/// element.
class TwoBlocks
{
public:
  using Function = std::function<long double(int side, long double y, long double z)>;

  /// x of the face between them.
  static long double Between(long double y, long double z) { return 0.1L * y * z + 0.05L * y * y; }

  TwoBlocks(double part, const std::vector<Function>& values, bool swapped = false)
    : Values(static_cast<int>(values.size()))
  {
    for (int number = 0; number < 2; ++number)
    {
      const int side = swapped ? 1 - number : number;
      const auto map = [side, part](const LongVec3& xi) -> LongVec3
      {
        const long double scale = side == 0 ? 1.0L : static_cast<long double>(part);
        const long double y = scale * xi[1];
        const long double z = scale * xi[2];
        return { (xi[0] + (side == 0 ? -1 : 1)) / 2 + Between(y, z), y, z };
      };
      const Space space = UniformSpace(Shape::Hexahedron, 2);
      Blocks.Add(space, map);
      Values.Add(space,
        [&](const LongVec3& xi, long double* to)
        {
          const LongVec3 x = map(xi);
          for (std::size_t c = 0; c < values.size(); ++c)
          {
            to[c] = values[c](side, x[1], x[2]);
          }
        });
    }
    field_ = { "u", Values.View() };
    locator_ = std::make_unique<Locator>(Blocks.View());
    Table = std::make_unique<FaceTable>(locator_->Index());
  }

  /// A ray along x, from lower x.
  static Ray RayAt(double y, double z) { return { { -3.0, y, z }, { 1.0, 0.0, 0.0 } }; }

  MeshBuilder Blocks;
  ExpansionBuilder Values;
  Field field_;
  std::unique_ptr<Locator> locator_;
  std::unique_ptr<FaceTable> Table;
};
} // namespace pixelexact::testing
