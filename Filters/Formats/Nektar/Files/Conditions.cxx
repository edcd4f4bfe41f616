// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Files/Conditions.h"

#include "Core/Base/Error.h"
#include "Core/Base/ParseWhole.h"
#include "Formats/Nektar/Files/Expression.h"

#include <algorithm>
#include <cctype>

namespace pixelexact::nektar
{
namespace
{
/// The conditions that hold: those of the last file that has some.
pugi::xml_node Conditions(std::span<const Document* const> session)
{
  pugi::xml_node found;
  for (const Document* file : session)
  {
    const pugi::xml_node conditions = file->Root().child("CONDITIONS");
    found = conditions.first_child() ? conditions : found;
  }
  return found;
}

std::string Upper(std::string text)
{
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}
} // namespace

Parameters::Parameters(std::span<const Document* const> session)
{
  for (const auto& node : Conditions(session).child("PARAMETERS").children("P"))
  {
    const std::string text = Document::Text(node);
    const auto equals = text.find('=');
    if (equals == std::string::npos)
    {
      continue;
    }
    const std::string_view name = WithoutBlanks(std::string_view(text).substr(0, equals));
    const std::string_view value = WithoutBlanks(std::string_view(text).substr(equals + 1));
    try
    {
      Values[std::string(name)] =
        Evaluate(value, [this](std::string_view other) { return Find(other); });
    }
    catch (const InvalidData&)
    {
      // A solver may need more than this parser supports. A missing parameter causes an error where
      // it is used.
      Values.erase(std::string(name));
    }
  }
}

std::optional<double> Parameters::Find(std::string_view name) const
{
  const auto found = Values.find(name);
  return found != Values.end() ? std::optional(found->second) : std::nullopt;
}

std::optional<std::string> HomogeneousType(std::span<const Document* const> session)
{
  for (const auto& node : Conditions(session).child("SOLVERINFO").children("I"))
  {
    if (Upper(node.attribute("PROPERTY").value()) == "HOMOGENEOUS")
    {
      return std::string(node.attribute("VALUE").value()).substr(0, 40);
    }
  }
  return std::nullopt;
}

std::string HomogeneousRemedy()
{
  return "extrude the mesh (NekMesh -m "
         "extrude:layers=<n>:length=<l> 2D.xml 3D.xml) and bring the field onto it (FieldConvert "
         "-m "
         "interpfield:fromxml=2D.xml:fromfld=2D.fld 3D.xml 3D.fld).";
}
} // namespace pixelexact::nektar
