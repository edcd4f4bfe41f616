// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/LineFunctions.h"
#include "Core/Math/Vec.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

// Files of Nek5000, nekRS and neko, written by hand.
namespace pixelexact::testing
{
struct NekFile
{
  using Values = std::function<double(const Vec3& x, int component)>;
  /// A block's components, and its values.
  struct Block
  {
    int components = 1;
    Values values;
  };

  int nodes = 3; ///< of an element in a direction
  bool isPlane = false;
  int word = 8;
  bool isSwapped = false;
  std::vector<std::int32_t> numbers{ 1, 2 };
  std::int64_t total = 0; ///< 0: as many as there are numbers
  int part = 0;
  int parts = 1;
  double time = 0.0;
  std::string codes = "XUP";
  std::string tail;
  bool hasRanges = false;
  /// The position of the node xi of the element with a number.
  std::function<Vec3(std::int32_t number, const Vec3& xi)> place = &Bent;
  std::vector<Block> fields{ { 3, &Velocity }, { 1, &Pressure } };

  /// Boxes that follow each other along x, curved.
  static Vec3 Bent(std::int32_t number, const Vec3& xi)
  {
    return { 2.0 * number + xi.x + 0.125 * xi.y, xi.y - 0.0625 * xi.x * xi.x, 0.5 * xi.z };
  }
  static double Velocity(const Vec3& x, int component)
  {
    return component == 0 ? x.y : component == 1 ? 2.0 * x.x : x.z - x.x;
  }
  static double Pressure(const Vec3& x, int) { return 1.0 + x.x - 3.0 * x.y + 0.5 * x.z; }

  [[nodiscard]] std::string Header() const
  {
    char text[200];
    std::snprintf(text, sizeof(text),
      "#std %1d %2d %2d %2d %10d %10lld %20.13E %9d %6d %6d %-10s%s", word, nodes, nodes,
      isPlane ? 1 : nodes, static_cast<int>(numbers.size()),
      static_cast<long long>(total > 0 ? total : static_cast<std::int64_t>(numbers.size())), time,
      7, part, parts, codes.c_str(), tail.c_str());
    std::string header = text;
    header.resize(132, ' ');
    return header;
  }

  [[nodiscard]] std::string Text() const
  {
    std::string text = Header();
    Append(text, 6.54321F);
    for (const std::int32_t number : numbers)
    {
      Append(text, number);
    }
    std::vector<Block> blocks = fields;
    if (codes.starts_with("X"))
    {
      blocks.insert(blocks.begin(),
        { isPlane ? 2 : 3, [](const Vec3& x, int component) { return x[component]; } });
    }
    std::size_t values = 0;
    for (const Block& block : blocks)
    {
      for (const std::int32_t number : numbers)
      {
        values += AppendElement(text, block, number);
      }
    }
    if (hasRanges)
    {
      text.append(values / NodesOfElement() * 2 * sizeof(float), '\0');
    }
    return text;
  }

private:
  [[nodiscard]] std::size_t NodesOfElement() const
  {
    const auto n = static_cast<std::size_t>(nodes);
    return isPlane ? n * n : n * n * n;
  }

  std::size_t AppendElement(std::string& text, const Block& block, std::int32_t number) const
  {
    const auto line = GaussLobattoPoints(nodes);
    const auto at = [&](int i) { return static_cast<double>(line[static_cast<std::size_t>(i)]); };
    for (int c = 0; c < block.components; ++c)
    {
      for (int k = 0; k < (isPlane ? 1 : nodes); ++k)
      {
        for (int j = 0; j < nodes; ++j)
        {
          for (int i = 0; i < nodes; ++i)
          {
            const Vec3 x = place(number, { at(i), at(j), isPlane ? 0.0 : at(k) });
            const double value = block.values(x, c);
            word == 4 ? Append(text, static_cast<float>(value)) : Append(text, value);
          }
        }
      }
    }
    return static_cast<std::size_t>(block.components) * NodesOfElement();
  }

  template <class Number>
  void Append(std::string& text, Number number) const
  {
    std::string bytes(reinterpret_cast<const char*>(&number), sizeof(number));
    if (isSwapped)
    {
      std::ranges::reverse(bytes);
    }
    text += bytes;
  }
};
} // namespace pixelexact::testing
