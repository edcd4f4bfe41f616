// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// The header of a file of Nek5000, nekRS or neko (x0.f00001).
namespace pixelexact::nek5000
{
/// Bytes before the elements' numbers: 132 characters, and 6.54321 as a float in the file's byte
/// order.
inline constexpr std::size_t kHeaderBytes = 136;

/// Whether a character is a decimal digit.
inline bool IsDigit(char c)
{
  return c >= '0' && c <= '9';
}

/// A field of a file, as it follows the mesh.
struct HeaderField
{
  std::string name;
  int components = 1;
  bool isRead = true; ///< else its values are at other nodes
};

struct Header
{
  int wordSize = 8;           ///< bytes of a value, 4 or 8
  std::array<int, 3> nodes{}; ///< of an element along xi1, xi2, xi3; the last one is 1 in 2-D
  std::int64_t elements = 0;  ///< in this file
  std::int64_t elementsOfAll = 0;
  double time = 0.0;
  std::int64_t part = 0; ///< counted from 0
  std::int64_t parts = 1;
  bool hasMesh = false;
  bool hasVelocity = false;
  bool hasPressure = false;
  bool hasTemperature = false;
  int scalars = 0;
  /// The pressure has values at other nodes than the other fields, those of a mesh of lower order.
  bool isPressureElsewhere = false;
  bool isSwapped = false; ///< the byte order is not that of this machine

  [[nodiscard]] int Dimension() const { return nodes[2] == 1 ? 2 : 3; }
  [[nodiscard]] int NodesOfElement() const { return nodes[0] * nodes[1] * nodes[2]; }
  /// Values of a node in the file, of all components.
  [[nodiscard]] int Components() const;
  /// The fields in the order of the file.
  [[nodiscard]] std::vector<HeaderField> Fields() const;
};

/// Parses the first kHeaderBytes bytes of a file. Throws InvalidData or Unsupported, with the
/// file's name and the remedy.
Header ParseHeader(const std::string& file, std::string_view head);
} // namespace pixelexact::nek5000
