// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/Error.h"
#include "Core/Location/Sample.h"
#include "Formats/SolverModel.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

// Models that readers return, evaluated; and texts that they refuse.
namespace pixelexact::testing
{
/// Points of prisms and hexahedra, in xi.
inline const Vec3 kInside[] = { { -0.7, -0.2, -0.5 }, { -0.1, 0.9, -0.6 }, { -0.3, -0.9, -0.1 } };

inline Mesh ViewOf(const SolverMesh& mesh)
{
  return { mesh.map.View(), mesh.centre, mesh.size, mesh.uncertainty };
}

inline Vec3 PointAt(const SolverModel& model, int element, const Vec3& xi)
{
  Vec3 x;
  MapForward(ViewOf(model.mesh), element, std::span(&xi, 1), std::span(&x, 1));
  return x;
}

inline std::vector<double> ValueAt(
  const SolverModel& model, std::size_t field, int element, const Vec3& xi)
{
  const SolverField& f = model.fields.at(field);
  std::vector<double> value(f.values.components);
  EvaluateAt(ViewOf(model.mesh), { f.name, f.values.View(), f.mapping }, element, std::span(&xi, 1),
    value, {});
  return value;
}

inline std::string Replaced(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// Expects `read` to throw an error whose message contains all parts.
template <class Read>
void ExpectRefusal(const Read& read, const std::vector<std::string>& parts)
{
  try
  {
    read();
    ADD_FAILURE() << "was read";
  }
  catch (const Error& error)
  {
    for (const auto& part : parts)
    {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos)
        << "'" << part << "' in: " << error.what();
    }
  }
}
} // namespace pixelexact::testing
