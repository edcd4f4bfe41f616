// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/Error.h"
#include "Formats/Gmsh/Reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

// Gmsh files written by hand.
namespace pixelexact::testing
{
/// Bytes of a binary file.
class Bytes
{
public:
  explicit Bytes(bool swapped = false)
    : Swapped(swapped)
  {
  }

  Bytes& Text(const std::string& text)
  {
    Data += text;
    return *this;
  }
  Bytes& Ints(const std::vector<std::int32_t>& values) { return Add(values); }
  Bytes& Sizes(const std::vector<std::uint64_t>& values) { return Add(values); }
  Bytes& Reals(const std::vector<double>& values) { return Add(values); }

  std::string Data;

private:
  template <class Value>
  Bytes& Add(const std::vector<Value>& values)
  {
    for (const Value value : values)
    {
      std::string bytes(reinterpret_cast<const char*>(&value), sizeof(Value));
      if (Swapped)
      {
        std::ranges::reverse(bytes);
      }
      Data += bytes;
    }
    return *this;
  }

  bool Swapped;
};

inline constexpr const char* kFormat41 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
inline constexpr const char* kFormat22 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";

/// Two tetrahedra, numbers 11 and 12, on the nodes 1 to 5, in the volumes 1 and 2, and the triangle
/// 10 of surface 7 between them.
inline const std::string kNodes41 =
  "$Nodes\n1 5 1 5\n3 1 0 5\n1\n2\n3\n4\n5\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n$EndNodes\n";
inline const std::string kElements41 = "$Elements\n3 3 10 12\n2 7 2 1\n10 2 3 4\n3 1 4 1\n"
                                       "11 1 2 3 4\n3 2 4 1\n12 2 3 4 5\n$EndElements\n";
inline const std::string kPair41 = kFormat41 + kNodes41 + kElements41;
inline const std::string kNodes22 =
  "$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n$EndNodes\n";
inline const std::string kPair22 = kFormat22 + kNodes22 +
  "$Elements\n3\n10 2 2 0 7 2 3 4\n11 4 2 0 1 1 2 3 4\n12 4 2 0 2 2 3 4 5\n$EndElements\n";

/// `tags`: text after the name. `values`: the lines.
inline std::string View(const std::string& section, const std::string& name, double time, int step,
  int components, int count, const std::string& values)
{
  return "$" + section + "\n1\n\"" + name + "\"\n1\n" + std::to_string(time) + "\n3\n" +
    std::to_string(step) + "\n" + std::to_string(components) + "\n" + std::to_string(count) + "\n" +
    values + "$End" + section + "\n";
}

inline SolverModel ReadGmsh(
  const std::string& text, const std::vector<std::string>& views = {}, int step = 0)
{
  std::vector<NamedText> files{ { "folder/a.msh", text } };
  for (const auto& view : views)
  {
    files.push_back({ "folder/view.msh", view });
  }
  return gmsh::Read(files, step);
}

inline std::string GmshMessage(const std::string& text, const std::vector<std::string>& views = {})
{
  try
  {
    ReadGmsh(text, views);
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return {};
}

inline void ExpectParts(const std::string& message, const std::vector<std::string>& parts)
{
  for (const auto& part : parts)
  {
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' in: " << message;
  }
}
} // namespace pixelexact::testing
