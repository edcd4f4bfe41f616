// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/TradePage.h"

#include "Core/Base/Error.h"

#include <nlohmann/json.hpp>
#include <vtkBase64Utilities.h>

#include <fstream>
#include <iterator>

namespace pixelexact
{
namespace
{
constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>PixelExact: speed against accuracy</title>
<style>
body { font: 15px/1.45 sans-serif; color: #222; max-width: 1200px; margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.5em; } h2 { font-size: 1.15em; margin-top: 2em; }
table { border-collapse: collapse; font-size: 13px; }
th, td { border: 1px solid #ddd; padding: 3px 7px; text-align: right; }
th { background: #f4f4f4; font-weight: 600; } td:first-child, .text { text-align: left; }
.facts th { text-align: left; } .scroll { overflow-x: auto; }
img { max-width: 100%; } code { background: #f4f4f4; padding: 2px 4px; word-break: break-all; }
.answer { background: #eef5ff; border-left: 4px solid #145ab4; padding: .6em 1em; white-space: pre-wrap; }
#pair { position: relative; display: inline-block; line-height: 0; border: 1px solid #ccc; }
#other { position: absolute; left: 0; top: 0; clip-path: inset(0 0 0 50%); }
#edge { position: absolute; top: 0; bottom: 0; width: 2px; background: #c81e1e; left: 50%; pointer-events: none; }
#slide { width: 100%; max-width: 700px; }
</style></head><body>
<h1>Speed against accuracy</h1>
)";

constexpr const char* kScript = R"(<script>
const choice = document.getElementById('choice'), slide = document.getElementById('slide');
const other = document.getElementById('other'), errors = document.getElementById('errors');
const edge = document.getElementById('edge');
for (const one of pictures) choice.add(new Option(one.name));
function show() {
  other.src = pictures[choice.selectedIndex].picture;
  errors.src = pictures[choice.selectedIndex].errors;
}
function move() {
  other.style.clipPath = 'inset(0 0 0 ' + slide.value + '%)';
  edge.style.left = slide.value + '%';
}
choice.onchange = show;
slide.oninput = move;
choice.selectedIndex = Math.max(0, pictures.findIndex(one => !one.name.startsWith('exact')));
show();
move();
</script></body></html>
)";

std::string ImageOf(const std::string& address, const char* text)
{
  return std::string("<img alt=\"") + text + "\" src=\"" + address + "\">\n";
}
} // namespace

std::string ForHtml(const std::string& text)
{
  std::string safe;
  for (const char c : text)
  {
    switch (c)
    {
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '&':
        safe += "&amp;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string DataAddressOf(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{ std::istreambuf_iterator<char>(stream),
    std::istreambuf_iterator<char>() };
  if (!stream || bytes.empty())
  {
    throw Error("'" + file + "' cannot be read");
  }
  std::string text(bytes.size() / 3 * 4 + 8, '\0');
  const unsigned long length =
    vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
      reinterpret_cast<unsigned char*>(text.data()), 0);
  text.resize(length);
  return "data:image/png;base64," + text;
}

std::string ToHtml(const TradePage& page)
{
  std::string html = kHead;
  html += page.facts;
  if (!page.recommendation.empty())
  {
    html +=
      "<h2>Recommendation</h2>\n<div class=answer>" + ForHtml(page.recommendation) + "</div>\n";
  }
  html += "<h2>Error against time</h2>\n" + ImageOf(page.pareto, "error against time");
  html += "<h2>All settings</h2>\n<p>Errors are over the range of the colours. Times are medians; "
          "a first picture is made from a model in memory, a later cut with all that can be kept. "
          "Drawing of triangles, which a graphics card does, is not in the linear times.</p>\n"
          "<div class=scroll>" +
    page.table + "</div>\n";
  html += "<h2>Convergence to the exact picture</h2>\n" + page.orders +
    ImageOf(page.convergence, "mean error against spacing");
  html += "<h2>Side by side</h2>\n<p>Left of the red line the exact picture, right of it <select "
          "id=choice></select></p>\n<div id=pair>" +
    ImageOf(page.truth, "exact") +
    "<img id=other alt=\"other setting\"><div id=edge></div></div>\n"
    "<p><input id=slide type=range min=0 max=100 value=50 step=0.1></p>\n"
    "<p>Its error, from black (1e-8 of the range and less) to yellow (all of it); magenta: no "
    "answer, cyan: invented.</p>\n<img id=errors alt=\"error\">\n";
  html += "<h2>Again</h2>\n<p><code>" + ForHtml(page.command) + "</code></p>\n";
  nlohmann::ordered_json pictures = nlohmann::ordered_json::array();
  for (const TradePage::Pictures& one : page.pictures)
  {
    pictures.push_back(
      { { "name", one.name }, { "picture", one.picture }, { "errors", one.errors } });
  }
  html += "<script>const pictures = " + pictures.dump() + ";</script>\n";
  return html + kScript;
}
} // namespace pixelexact
