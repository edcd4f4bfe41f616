// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/PaperReport.h"

#include "Base/Output.h"
#include "Base/Report.h"
#include "Drawing/ImageFile.h"
#include "Drawing/Plot.h"

#include "Core/Base/Error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <ostream>

namespace pixelexact
{
namespace
{
struct Figure
{
  const char* name;
  const char* title;
  const char* across;
  const char* paper; ///< numbers in the paper's text or caption; empty: only a curve
};
constexpr std::array<Figure, 8> kFigures{ {
  { "8a", "Sampling a grid over the volume", "samples", "" },
  { "8b", "Sampling a plane", "samples",
    "8,388,608 samples of order 2: about 30 s, 180 MB (section 6.1)" },
  { "10a", "Frames by order", "order",
    "10 to 20 frames a second also of large images (section 6)" },
  { "10b", "Frames by elements, order 3", "elements", "not strongly related (section 6.4)" },
  { "10c", "Frames by image and cut-surface", "pixels", "the most important factor (section 6.4)" },
  { "10d", "Memory by order", "order", "grows as n^3 (section 6.4)" },
  { "10e", "Memory by image", "pixels", "linear (section 6.4)" },
  { "10f", "Memory by elements", "elements", "linear (section 6.4)" },
} };
constexpr const char* kPaperNine =
  "contours: 524,288 triangles 0.265 s, 8,388,608 triangles 3.5 s, high-order 2000 x 2000 pixels "
  "0.3 s (figure 9)";
constexpr const char* kPaperEleven =
  "colours: 902,289 triangles 0.08 s, 8,388,608 triangles 2.0 s, pixel-exact 1800 x 800 pixels "
  "0.015 s (figure 11)";

constexpr std::array<Rgba, 4> kColors{ { { 200, 30, 30, 255 }, { 20, 90, 180, 255 },
  { 20, 140, 70, 255 }, { 200, 130, 0, 255 } } };

bool IsMemory(const PaperRow& row)
{
  return row.bytes >= 0.0;
}

Plot PlotOf(const Figure& figure, const PaperResults& results)
{
  Plot plot;
  plot.logarithmic = { true, true };
  plot.title = fmt::format("Figure {}: {}", figure.name, figure.title);
  plot.across = figure.across;
  plot.up = "seconds";
  std::map<std::string, std::size_t> places;
  for (const PaperRow& row : results.rows)
  {
    if (row.figure != figure.name)
    {
      continue;
    }
    plot.up = IsMemory(row) ? "MB" : "seconds";
    const auto [place, isNew] = places.try_emplace(row.series, plot.series.size());
    if (isNew)
    {
      plot.series.push_back(
        { row.series, kColors[plot.series.size() % kColors.size()], {}, true, false });
    }
    plot.series[place->second].points.push_back(
      { row.x, IsMemory(row) ? row.bytes / 1e6 : row.seconds, "" });
  }
  return plot;
}
} // namespace

void WritePaper(const std::string& folder, const PaperResults& results)
{
  std::error_code error;
  std::filesystem::create_directory(folder, error);
  if (!std::filesystem::is_directory(folder))
  {
    throw Error("--output: the folder '" + folder + "' cannot be made" +
      (error ? ": " + error.message() : std::string()));
  }
  const auto in = [&folder](const std::string& name)
  { return (std::filesystem::path(folder) / name).string(); };
  OutputFile csv(in("paper.csv"));
  csv.Stream() << "figure,series,x,seconds,bytes\n";
  for (const PaperRow& row : results.rows)
  {
    csv.Stream() << fmt::format("{},{},{},{},{}\n", row.figure, row.series, row.x,
      IsMemory(row) ? std::string() : fmt::to_string(row.seconds),
      IsMemory(row) ? fmt::format("{:.0f}", row.bytes) : std::string());
  }
  csv.Close();
  if (!results.errors.empty())
  {
    OutputFile errors(in("errors.csv"));
    errors.Stream() << "triangles,cut_seconds,contour_seconds,bytes,largest_error,mean_error,"
                       "contour_pixels,missed,displaced,invented\n";
    for (const PaperErrors& e : results.errors)
    {
      errors.Stream() << fmt::format("{},{},{},{:.0f},{},{},{},{},{},{}\n", e.triangles,
        e.cutSeconds, e.contourSeconds, e.bytes, e.largest, e.mean, e.contourPixels, e.missed,
        e.displaced, e.invented);
    }
    errors.Close();
  }
  constexpr int kWidth = 800;
  constexpr int kHeight = 500;
  for (const Figure& figure : kFigures)
  {
    const Plot plot = PlotOf(figure, results);
    if (!plot.series.empty())
    {
      const std::string file = in(fmt::format("figure-{}.png", figure.name));
      WriteBytes(file,
        EncodeImage(
          { kWidth, kHeight, 3, plot.Draw(kWidth, kHeight) }, PictureFormat::Png, {}, file));
    }
  }
}

void PrintPaper(const PaperResults& results)
{
  for (const Figure& figure : kFigures)
  {
    bool first = true;
    std::string series;
    Table table;
    for (const PaperRow& row : results.rows)
    {
      if (row.figure != figure.name)
      {
        continue;
      }
      if (first)
      {
        table.Row(std::string("figure ") + figure.name, figure.title);
        if (*figure.paper != '\0')
        {
          table.Row("paper", figure.paper);
        }
      }
      first = false;
      table.Row(row.series == series ? std::string() : row.series, "{} {}: {}", Short(row.x),
        figure.across,
        IsMemory(row) ? fmt::format("{} MB", Short(row.bytes / 1e6, 4))
                      : fmt::format("{} s", Short(row.seconds, 3)));
      series = row.series;
    }
    if (!first)
    {
      table.Print();
    }
  }
  if (results.errors.empty())
  {
    return;
  }
  Table table;
  table.Row("figures 9, 11", "a plane through the input");
  table.Row("paper", kPaperNine);
  table.Row("", kPaperEleven);
  table.Row("exact", "{} s with colours, {} s with contours", Short(results.exactSeconds, 3),
    Short(results.exactContourSeconds, 3));
  for (const PaperErrors& e : results.errors)
  {
    table.Row(fmt::format("{} triangles", e.triangles),
      "cut {} s, {} MB, contours {} s; errors of colours: largest {}, mean {} of the range",
      Short(e.cutSeconds, 3), Short(e.bytes / 1e6, 4), Short(e.contourSeconds, 3),
      Short(e.largest, 3), Short(e.mean, 3));
    table.Row("", "of {} contour pixels {} missed, {} displaced; {} invented", e.contourPixels,
      e.missed, e.displaced, e.invented);
  }
  table.Print();
}

nlohmann::ordered_json ToJson(const PaperResults& results)
{
  nlohmann::ordered_json summary;
  for (const PaperRow& row : results.rows)
  {
    nlohmann::ordered_json entry{ { "figure", row.figure }, { "series", row.series },
      { "x", row.x } };
    entry[IsMemory(row) ? "bytes" : "seconds"] = IsMemory(row) ? row.bytes : row.seconds;
    summary["rows"].push_back(entry);
  }
  for (const PaperErrors& e : results.errors)
  {
    summary["linear"].push_back({ { "triangles", e.triangles }, { "cut_seconds", e.cutSeconds },
      { "contour_seconds", e.contourSeconds }, { "bytes", e.bytes }, { "largest_error", e.largest },
      { "mean_error", e.mean }, { "contour_pixels", e.contourPixels }, { "missed", e.missed },
      { "displaced", e.displaced }, { "invented", e.invented } });
  }
  if (!results.errors.empty())
  {
    summary["exact_seconds"] = results.exactSeconds;
    summary["exact_contour_seconds"] = results.exactContourSeconds;
  }
  return summary;
}
} // namespace pixelexact
