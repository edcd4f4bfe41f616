// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Elements/VectorSpaces.h"

namespace pixelexact::mfem
{
namespace
{
constexpr long double kTetrahedronCentre = 1 / 4.0L;
constexpr long double kTriangleCentre = 1 / 3.0L;

LongVec3 Scaled(long double factor, const LongVec3& a)
{
  return { factor * a[0], factor * a[1], factor * a[2] };
}

/// The modes of full order, and of those the ones that do not depend on the first coordinate.
struct TopModes
{
  std::vector<int> all;
  std::vector<int> withoutFirst;
};

TopModes TopModesOf(const Space& space)
{
  TopModes top;
  ForEachMode(space,
    [&](int p, int q, int r, int mode)
    {
      if (p + q + r == space.MaxOrder())
      {
        top.all.push_back(mode);
        if (p == 0)
        {
          top.withoutFirst.push_back(mode);
        }
      }
    });
  return top;
}
} // namespace

VectorSpace TetrahedronSpace(Continuity kind, int order)
{
  const bool curl = kind == Continuity::HCurl;
  const Space space = UniformSpace(Shape::Tetrahedron, curl ? order - 1 : order);
  const TopModes top = TopModesOf(space);
  const auto tops = static_cast<int>(top.all.size());
  const auto last = static_cast<int>(top.withoutFirst.size());
  return { 3 * space.Modes() + (curl ? 2 * tops + last : tops),
    [curl, space, top](const LongVec3& unit, LongVec3* values)
    {
      std::vector<long double> modes(space.Modes());
      EvaluateModes(space, { 2 * unit[0] - 1, 2 * unit[1] - 1, 2 * unit[2] - 1 }, modes.data());
      for (const long double mode : modes)
      {
        *values++ = { mode, 0, 0 };
        *values++ = { 0, mode, 0 };
        *values++ = { 0, 0, mode };
      }
      const long double x = unit[0] - kTetrahedronCentre;
      const long double y = unit[1] - kTetrahedronCentre;
      const long double z = unit[2] - kTetrahedronCentre;
      for (const int t : top.all)
      {
        if (!curl)
        {
          *values++ = Scaled(modes[t], { x, y, z });
          continue;
        }
        *values++ = Scaled(modes[t], { y, -x, 0 });
        *values++ = Scaled(modes[t], { z, 0, -x });
      }
      // The third rotation adds what has no factor x: x (0, z, -y) = y (z, 0, -x) - z (y, -x, 0).
      for (std::size_t i = 0; curl && i < top.withoutFirst.size(); ++i)
      {
        *values++ = Scaled(modes[top.withoutFirst[i]], { 0, z, -y });
      }
    } };
}

Space TriangleSpace(int order)
{
  const auto n = static_cast<std::uint8_t>(order);
  return { Shape::Prism, Form::Collapsed, { n, 0, n } };
}

PlaneSpace TriangleVectors(Continuity kind, int order)
{
  const Space space = TriangleSpace(kind == Continuity::HCurl ? order - 1 : order);
  const auto top = TopModesOf(space).all;
  return { 2 * space.Modes() + static_cast<int>(top.size()),
    [kind, space, top](long double x, long double y, std::array<long double, 2>* values)
    {
      std::vector<long double> modes(space.Modes());
      EvaluateModes(space, { 2 * x - 1, 0, 2 * y - 1 }, modes.data());
      for (const long double mode : modes)
      {
        *values++ = { mode, 0 };
        *values++ = { 0, mode };
      }
      const long double dx = x - kTriangleCentre;
      const long double dy = y - kTriangleCentre;
      for (const int t : top)
      {
        *values++ = kind == Continuity::HCurl ? std::array{ modes[t] * dy, -modes[t] * dx }
                                              : std::array{ modes[t] * dx, modes[t] * dy };
      }
    } };
}

LongVec3 Cross(const LongVec3& a, const LongVec3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}
} // namespace pixelexact::mfem
