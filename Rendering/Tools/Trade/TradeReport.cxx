// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/TradeReport.h"

#include "Base/Output.h"
#include "Base/Report.h"
#include "Drawing/ImageFile.h"
#include "Drawing/Picture.h"
#include "Drawing/Plot.h"
#include "Scene/Shot.h"
#include "Trade/TradePage.h"
#include "Trade/TradeRows.h"
#include "Views/VtkColorMap.h"

#include <fmt/format.h>
#include <vtkLookupTable.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace pixelexact
{
namespace
{
constexpr Rgba kMagenta{ 255, 0, 255, 255 };
constexpr Rgba kCyan{ 0, 200, 255, 255 };
constexpr Rgba kBlack{ 0, 0, 0, 255 };
constexpr auto kExact = static_cast<std::uint8_t>(PixelVerdict::Exact);
constexpr auto kNothing = static_cast<std::uint8_t>(PixelVerdict::Nothing);
constexpr auto kUnknown = static_cast<std::uint8_t>(PixelVerdict::Unknown);

void Put(std::vector<std::uint8_t>& rgb, std::size_t pixel, const Rgba& color)
{
  std::copy_n(color.begin(), 3, rgb.begin() + static_cast<std::ptrdiff_t>(3 * pixel));
}

Rgba At(const std::vector<std::uint8_t>& rgba, std::size_t pixel)
{
  const std::uint8_t* color = &rgba[4 * pixel];
  return { color[0], color[1], color[2], 255 };
}
} // namespace

std::vector<std::uint8_t> PaintValues(
  const Picture& picture, const ColorMap& map, const Rgba& background)
{
  std::vector<std::uint8_t> colors(4 * picture.Size());
  map(picture.value, colors.data());
  std::vector<std::uint8_t> rgb(3 * picture.Size());
  for (std::size_t i = 0; i < picture.Size(); ++i)
  {
    Put(rgb, i,
      picture.verdict[i] == kExact ? At(colors, i)
                                   : (picture.verdict[i] == kUnknown ? kMagenta : background));
    if (!picture.contour.empty() &&
      picture.contour[i] == static_cast<std::uint8_t>(ContourVerdict::In))
    {
      Put(rgb, i, kBlack);
    }
  }
  return rgb;
}

std::vector<std::uint8_t> PaintErrors(const Picture& truth, const Picture& picture,
  const std::array<double, 2>& range, const ColorMap& map, const Rgba& background)
{
  std::vector<double> logarithms(truth.Size());
  for (std::size_t i = 0; i < truth.Size(); ++i)
  {
    const double error = Relative(std::fabs(picture.value[i] - truth.value[i]), range);
    logarithms[i] = std::log10(std::clamp(error, kPaintedErrors[0], kPaintedErrors[1]));
  }
  std::vector<std::uint8_t> colors(4 * truth.Size());
  map(logarithms, colors.data());
  std::vector<std::uint8_t> rgb(3 * truth.Size());
  for (std::size_t i = 0; i < truth.Size(); ++i)
  {
    const bool has = picture.verdict[i] == kExact;
    if (truth.verdict[i] == kExact)
    {
      Put(rgb, i, has ? At(colors, i) : kMagenta);
    }
    else
    {
      Put(rgb, i, has && truth.verdict[i] == kNothing ? kCyan : background);
    }
  }
  return rgb;
}

namespace
{

std::string Percent(std::int64_t count, std::int64_t of)
{
  return of > 0
    ? fmt::format("{:.3g} %", 100.0 * static_cast<double>(count) / static_cast<double>(of))
    : "";
}

std::string Megabytes(double bytes)
{
  return bytes >= 0.0 ? fmt::format("{:.3g}", bytes * 1e-6) : "";
}

/// A row of the page's table.
std::string RowOf(const TradeRow& row, const TradeFacts& facts, bool contours)
{
  const PictureErrors& e = row.errors;
  const auto error = [&facts](double value) { return Short(Relative(value, facts.range), 3); };
  std::vector<std::string> cells{ ForHtml(row.setting.name) };
  if (!row.IsThere())
  {
    return fmt::format("<tr><td>{}</td><td colspan={} class=text>{}</td></tr>\n", cells[0],
      contours ? 16 : 12, ForHtml(row.refused));
  }
  cells.insert(cells.end(),
    { Short(row.first.Median(), 3), Short(row.first.Ratio(), 3), Short(row.next.Median(), 3),
      Short(row.next.Ratio(), 3), Megabytes(row.bytes), error(e.largest), error(e.mean),
      error(e.atShare), Percent(e.wrongBin, e.compared), Percent(e.missing, e.shown),
      fmt::to_string(e.invented), fmt::to_string(row.unknown) });
  if (contours)
  {
    const bool has = e.hasContours;
    cells.insert(cells.end(),
      { has ? Percent(e.contourMissed, e.contourPixels) : "",
        has ? Percent(e.contourDisplaced, e.contourPixels) : "",
        has ? fmt::to_string(e.contourInvented) : "", has ? Short(e.contourFarthest, 3) : "" });
  }
  std::string text = "<tr>";
  for (const std::string& cell : cells)
  {
    text += "<td>" + cell + "</td>";
  }
  return text + "</tr>\n";
}

std::string TableOf(const std::vector<TradeRow>& rows, const TradeFacts& facts)
{
  const bool contours = rows.front().errors.hasContours;
  std::string table = "<table><tr><th>setting<th>first picture, s<th>over exact<th>later cut, "
                      "s<th>over exact<th>memory, MB<th>largest error<th>mean error<th>error of " +
    Short(100.0 * facts.share) +
    " %<th>wrong colour<th>no answer<th>invented pixels<th>unknown pixels";
  if (contours)
  {
    table += "<th>contour missed<th>displaced<th>invented pixels<th>farthest, pixels";
  }
  table += "</tr>\n";
  for (const TradeRow& row : rows)
  {
    table += RowOf(row, facts, contours);
  }
  return table + "</table>\n";
}

std::string OrdersText(const std::vector<TradeRow>& rows, const TradeFacts& facts)
{
  std::string text;
  for (const TradeOrder& order : OrdersOf(rows, facts.range))
  {
    text +=
      fmt::format("<li>{}: order {:.2f} over {} settings, {:.2f} between the two finest</li>\n",
        Name(order.family), order.overall, order.settings, order.last);
  }
  return text.empty() ? "" : "<ul>" + text + "</ul>";
}

std::string FactsText(const TradeFacts& facts)
{
  std::string text = "<table class=facts>";
  for (const auto& [name, value] : facts.lines)
  {
    text += "<tr><th>" + ForHtml(name) + "</th><td class=text>" + ForHtml(value) + "</td></tr>\n";
  }
  return text + "</table>\n";
}

/// Writes pictures into the folder and keeps them for the page.
class Folder
{
public:
  explicit Folder(std::string folder)
    : Name(std::move(folder))
  {
  }
  /// The picture as an address that holds it.
  std::string Write(
    const std::string& name, int width, int height, const std::vector<std::uint8_t>& rgb)
  {
    const std::string file = PathOf(name);
    WriteBytes(file, EncodeImage({ width, height, 3, rgb }, PictureFormat::Png, {}, file));
    return DataAddressOf(file);
  }
  [[nodiscard]] std::string PathOf(const std::string& name) const
  {
    return (std::filesystem::path(Name) / name).string();
  }

private:
  std::string Name;
};
} // namespace

void WriteTradeReport(const std::string& folder, const TradeScene& scene, const Picture& truth,
  const std::vector<TradeRow>& rows, const TradeFacts& facts, const Rgba& background)
{
  Folder files(folder);
  TradePage page;
  page.pareto = files.Write(
    "pareto.png", kPlotWidth, kPlotHeight, DrawPareto(rows, facts, kPlotWidth, kPlotHeight));
  page.convergence = files.Write("convergence.png", kPlotWidth, kPlotHeight,
    DrawConvergence(rows, facts, kPlotWidth, kPlotHeight));
  page.truth =
    files.Write("truth.png", truth.width, truth.height, PaintValues(truth, scene.map, background));
  const ColorMap errors = ToColorMap(
    MakeColorMap("inferno", { std::log10(kPaintedErrors[0]), std::log10(kPaintedErrors[1]) }));
  for (const TradeRow& row : rows)
  {
    if (row.IsThere())
    {
      const Picture& picture = row.picture;
      page.pictures.push_back({ row.setting.name,
        files.Write(row.setting.name + ".png", picture.width, picture.height,
          PaintValues(picture, scene.map, background)),
        files.Write(row.setting.name + "-error.png", picture.width, picture.height,
          PaintErrors(truth, picture, facts.range, errors, background)) });
    }
  }
  page.facts = FactsText(facts);
  page.table = TableOf(rows, facts);
  page.orders = OrdersText(rows, facts);
  page.recommendation = facts.recommendation;
  page.command = facts.command;
  OutputFile file(files.PathOf("report.html"));
  file.Stream() << ToHtml(page);
  file.Close();
}
} // namespace pixelexact
