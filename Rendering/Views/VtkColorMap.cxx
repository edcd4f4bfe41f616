// SPDX-License-Identifier: BSD-3-Clause
#include "Views/VtkColorMap.h"

#include "Core/Base/Error.h"
#include "Trace/Scene.h"

#include "vtkColorTransferFunction.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkScalarsToColors.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pixelexact
{
namespace
{
enum class Between
{
  Rgb,
  Lab,
  Diverging
};

struct NamedMap
{
  std::string_view name;
  Between between;
  std::uint32_t nan;
  std::span<const std::uint32_t> colors; ///< 0xRRGGBB, at equal steps over the range
};

// kMaps, the rows of Rendering/Settings/colormaps.json, which states the source of each map.
#include "ColorMapRows.inc"

/// Steps of a table: four for each of the 256 values of a byte.
constexpr int kTableSize = 1024;

double Channel(std::uint32_t color, int shift)
{
  return static_cast<double>((color >> shift) & 0xffU) / 255.0;
}

/// The name of a reversed map ends with this.
constexpr std::string_view kReversed = "_r";

struct ChosenMap
{
  const NamedMap* map = nullptr; ///< null where there is none of the name
  bool reversed = false;
};

ChosenMap FindMap(std::string_view name)
{
  ChosenMap chosen{ .reversed = name.ends_with(kReversed) };
  if (chosen.reversed)
  {
    name.remove_suffix(kReversed.size());
  }
  const auto* found = std::ranges::find(kMaps, name, &NamedMap::name);
  chosen.map = found != std::end(kMaps) ? found : nullptr;
  return chosen;
}

void SetSpace(vtkColorTransferFunction* map, Between between)
{
  switch (between)
  {
    case Between::Lab:
      map->SetColorSpaceToLab();
      break;
    case Between::Diverging:
      map->SetColorSpaceToDiverging();
      break;
    default:
      map->SetColorSpaceToRGB();
  }
}

bool IsEmpty(vtkScalarsToColors* table)
{
  if (table->GetIndexedLookup() != 0)
  {
    return false; // then all values have the NaN colour
  }
  if (auto* colors = vtkColorTransferFunction::SafeDownCast(table))
  {
    return colors->GetSize() == 0;
  }
  return table->GetNumberOfAvailableColors() == 0;
}

/// Values without a logarithm get the colour of NaN; VTK gives them that of the lower end.
ColorMap OfPositive(ColorMap map)
{
  return [map = std::move(map)](std::span<const double> values, std::uint8_t* rgba)
  {
    std::vector<double> known(values.begin(), values.end());
    for (double& value : known)
    {
      value = value > 0.0 ? value : std::numeric_limits<double>::quiet_NaN();
    }
    map(known, rgba);
  };
}

class VtkColorTable final : public ColorTable
{
public:
  explicit VtkColorTable(vtkScalarsToColors* table)
    : Table(table)
  {
    Table->Build(); // IsOpaque reads the colours that this computes
    State = Table->GetMTime();
  }

  [[nodiscard]] ColorMap Over(const std::array<double, 2>& range) const override
  {
    RequireRange(range);
    const double* own = Table->GetRange();
    const bool differs = range[0] != own[0] || range[1] != own[1];
    if (differs && (!IsLogarithmic() || range[0] > 0.0))
    {
      Table->SetRange(range.data());
    }
    ColorMap map = ToColorMap(Table);
    State = Table->GetMTime();
    return map;
  }
  [[nodiscard]] bool IsLogarithmic() const override { return Table->UsingLogScale() != 0; }
  [[nodiscard]] bool IsOpaque() const override { return Table->IsOpaque() != 0; }
  [[nodiscard]] std::array<double, 2> RangeOfNothing() const override
  {
    return { Table->GetRange()[0], Table->GetRange()[1] };
  }
  [[nodiscard]] bool IsSame(const ColorTable& other) const override
  {
    const auto* table = dynamic_cast<const VtkColorTable*>(&other);
    return table != nullptr && table->Table == Table && table->State == State;
  }

private:
  // Kept alive, so that no other table can have its address.
  vtkSmartPointer<vtkScalarsToColors> Table;
  mutable vtkMTimeType State = 0;
};
} // namespace

std::shared_ptr<const ColorTable> ColorTableOf(vtkScalarsToColors* table)
{
  return std::make_shared<VtkColorTable>(table);
}

void RequireRange(const std::array<double, 2>& range)
{
  // The difference must also be finite, because tables divide by it.
  if (!std::isfinite(range[1] - range[0]) || range[0] > range[1])
  {
    std::ostringstream text;
    text << "the range of colours, " << range[0] << " to " << range[1]
         << ", is none: both ends must be finite, and the second not below the first; a reversed "
            "table turns colours around";
    throw Error(text.str());
  }
}

ColorMap ToColorMap(vtkScalarsToColors* table)
{
  if (table == nullptr)
  {
    throw Error("no lookup table");
  }
  if (table->GetVectorMode() == vtkScalarsToColors::RGBCOLORS)
  {
    throw Unsupported("the lookup table takes vectors for RGB colours (VectorMode); choose a "
                      "component or the magnitude");
  }
  RequireRange({ table->GetRange()[0], table->GetRange()[1] });
  table->Build();
  if (IsEmpty(table))
  {
    throw Error("the lookup table has no colours");
  }
  ColorMap map = [keep = vtkSmartPointer<vtkScalarsToColors>(table)](
                   std::span<const double> values, std::uint8_t* rgba)
  {
    // VTK takes a pointer to non-const data but only reads it.
    keep->MapScalarsThroughTable2(const_cast<double*>(values.data()), rgba, VTK_DOUBLE,
      static_cast<int>(values.size()), 1, VTK_RGBA);
  };
  return table->UsingLogScale() != 0 && table->GetRange()[0] > 0.0 ? OfPositive(std::move(map))
                                                                   : map;
}

int ComponentOf(vtkScalarsToColors* table, int fieldComponents)
{
  if (fieldComponents == 1 || table == nullptr)
  {
    return 0;
  }
  if (table->GetVectorMode() == vtkScalarsToColors::MAGNITUDE)
  {
    return kMagnitude;
  }
  const int component = table->GetVectorComponent();
  if (component < 0 || component >= fieldComponents)
  {
    throw Error("the lookup table asks for vector component " + std::to_string(component) +
      ", but the field has " + std::to_string(fieldComponents) + " components");
  }
  return component;
}

std::vector<std::string> ColorMapNames()
{
  std::vector<std::string> names;
  for (const NamedMap& map : kMaps)
  {
    names.emplace_back(map.name);
  }
  return names;
}

bool HasColorMap(std::string_view name)
{
  return FindMap(name).map != nullptr;
}

vtkSmartPointer<vtkLookupTable> MakeColorMap(
  const std::string& name, const std::array<double, 2>& range)
{
  const auto [found, reversed] = FindMap(name);
  if (found == nullptr)
  {
    std::ostringstream text;
    text << "unknown colour map '" << name << "' (available: ";
    for (const NamedMap& map : kMaps)
    {
      text << map.name << ", ";
    }
    text << "and each reversed, as " << kMaps[0].name << kReversed << ')';
    throw Error(text.str());
  }
  vtkNew<vtkColorTransferFunction> colors;
  SetSpace(colors, found->between);
  const std::size_t last = found->colors.size() - 1;
  for (std::size_t i = 0; i <= last; ++i)
  {
    const double part = static_cast<double>(i) / static_cast<double>(last);
    const std::uint32_t color = found->colors[reversed ? last - i : i];
    colors->AddRGBPoint(part, Channel(color, 16), Channel(color, 8), Channel(color, 0));
  }
  return MakeColorTable(
    colors, { Channel(found->nan, 16), Channel(found->nan, 8), Channel(found->nan, 0) }, range);
}

vtkSmartPointer<vtkLookupTable> MakeColorTable(vtkColorTransferFunction* colors,
  const std::array<double, 3>& nan, const std::array<double, 2>& range)
{
  if (!std::isfinite(range[0]) || !std::isfinite(range[1]) || range[0] > range[1])
  {
    throw Error("the range of a colour map must be finite and run upwards");
  }
  double lower = range[0];
  double upper = range[1];
  if (lower == upper)
  {
    // For a constant field, the nearest range that a table can have, with the value in the middle.
    const double half = std::max(0.5 * std::abs(lower) * 1e-6, 1e-300);
    lower -= half;
    upper += half;
  }
  // A table lookup costs a hundredth of interpolation in CIELAB.
  std::vector<double> samples(3 * kTableSize);
  colors->GetTable(0.0, 1.0, kTableSize, samples.data());
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(kTableSize);
  table->SetTableRange(lower, upper);
  for (int i = 0; i < kTableSize; ++i)
  {
    const double* rgb = &samples[3 * static_cast<std::size_t>(i)];
    table->SetTableValue(i, rgb[0], rgb[1], rgb[2]);
  }
  table->SetNanColor(nan[0], nan[1], nan[2], 1.0);
  return table;
}
} // namespace pixelexact
