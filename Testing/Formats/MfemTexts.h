// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SolverModelViews.h"

#include "Core/Base/Error.h"
#include "Formats/MFEM/Reader.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

// Texts of MFEM's meshes and grid functions, and the messages for those that are refused.
namespace pixelexact::testing::mfemtexts
{
inline SolverModel ReadTexts(const std::string& mesh, const std::vector<std::string>& fields = {})
{
  std::vector<NamedText> texts;
  for (const auto& field : fields)
  {
    texts.push_back({ "folder/u.gf", field });
  }
  return mfem::Read({ "folder/a.mesh", mesh }, texts);
}

inline std::string Message(const std::string& mesh, const std::vector<std::string>& fields = {})
{
  try
  {
    ReadTexts(mesh, fields);
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return {};
}

inline void ExpectMessage(const std::string& message, const std::vector<std::string>& parts)
{
  for (const auto& part : parts)
  {
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' in: " << message;
  }
}
} // namespace pixelexact::testing::mfemtexts
