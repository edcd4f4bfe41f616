// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SolverModelViews.h"

#include "Core/Base/Error.h"
#include "Formats/Nektar/Reader.h"

#include <gtest/gtest.h>

#include <zlib.h>

// Small Nektar++ sessions and fields as text.
namespace pixelexact::testing
{

inline std::string Session(const std::string& geometry)
{
  return "<?xml version=\"1.0\"?>\n<NEKTAR><GEOMETRY DIM=\"3\" SPACE=\"3\">" + geometry +
    "</GEOMETRY></NEKTAR>";
}

/// The unit cube as one hexahedron of number 5.
inline std::string Cube(const std::string& more = "")
{
  std::string text = "<VERTEX>";
  const int x[8] = { 0, 1, 1, 0, 0, 1, 1, 0 };
  const int y[8] = { 0, 0, 1, 1, 0, 0, 1, 1 };
  for (int v = 0; v < 8; ++v)
  {
    text += "<V ID=\"" + std::to_string(v) + "\">" + std::to_string(x[v]) + " " +
      std::to_string(y[v]) + " " + std::to_string(v / 4) + "</V>";
  }
  text += "</VERTEX><EDGE>";
  const int edges[12][2] = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 0, 4 }, { 1, 5 }, { 2, 6 },
    { 3, 7 }, { 4, 5 }, { 5, 6 }, { 6, 7 }, { 7, 4 } };
  for (int e = 0; e < 12; ++e)
  {
    text += "<E ID=\"" + std::to_string(e) + "\">" + std::to_string(edges[e][0]) + " " +
      std::to_string(edges[e][1]) + "</E>";
  }
  return text +
    "</EDGE><FACE><Q ID=\"0\">0 1 2 3</Q><Q ID=\"1\">0 5 8 4</Q><Q ID=\"2\">1 6 9 5</Q>"
    "<Q ID=\"3\">2 6 10 7</Q><Q ID=\"4\">3 7 11 4</Q><Q ID=\"5\">8 9 10 11</Q></FACE>"
    "<ELEMENT><H ID=\"5\">0 1 2 3 4 5</H></ELEMENT>" +
    more + "<DOMAIN>C[0]</DOMAIN>";
}

inline std::string Field(const std::string& attributes, const std::string& values)
{
  return "<NEKTAR><Metadata><Time>2.5</Time></Metadata><ELEMENTS FIELDS=\"u\" " + attributes + ">" +
    values + "</ELEMENTS></NEKTAR>";
}

inline const std::string kLinearHexahedron =
  "SHAPE=\"Hexahedron\" BASIS=\"Modified_A,Modified_A,Modified_A\" ";

inline SolverModel ReadSession(const std::string& session, const std::string& field = "")
{
  std::vector<NamedText> fields;
  if (!field.empty())
  {
    fields.push_back({ "folder/u.fld", field });
  }
  return nektar::Read({ { "folder/a.xml", session } }, fields);
}

inline std::string Base64(const std::vector<unsigned char>& bytes)
{
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  unsigned bits = 0;
  unsigned count = 0;
  for (const unsigned char byte : bytes)
  {
    bits = bits << 8U | byte;
    for (count += 8; count >= 6;)
    {
      count -= 6;
      text += digits[bits >> count & 63U];
    }
  }
  return count > 0 ? text + digits[bits << (6 - count) & 63U] : text;
}

template <class T>
std::string Compressed(const std::vector<T>& values)
{
  uLongf size = compressBound(values.size() * sizeof(T));
  std::vector<unsigned char> packed(size);
  compress(
    packed.data(), &size, reinterpret_cast<const Bytef*>(values.data()), values.size() * sizeof(T));
  packed.resize(size);
  return Base64(packed);
}

/// The unit cube whose list of vertices has these attributes.
inline std::string Placed(const std::string& attributes, const std::string& more = "")
{
  return Replaced(Cube(more), "<VERTEX>", "<VERTEX " + attributes + ">");
}

inline Vec3 Corner(const SolverModel& model)
{
  return PointAt(model, 0, { 1.0, 1.0, 1.0 });
}

inline void ExpectRefusal(
  const std::string& session, const std::string& field, const std::vector<std::string>& parts)
{
  ExpectRefusal([&] { ReadSession(session, field); }, parts);
}

inline void ExpectRefusal(
  const std::vector<NamedText>& sessions, const std::vector<std::string>& parts)
{
  ExpectRefusal([&] { nektar::Read(sessions, {}); }, parts);
}
} // namespace pixelexact::testing
