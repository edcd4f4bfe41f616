// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/TradeScript.h"

#include "Scene/Shot.h"

#include "Core/Math/Vec.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <vtkBox.h>
#include <vtkImplicitTorus.h>
#include <vtkLinearTransform.h>
#include <vtkMatrix4x4.h>
#include <vtkPlane.h>
#include <vtkQuadric.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <filesystem>

namespace pixelexact
{
namespace
{
/// Quotes a text for Python.
std::string PythonQuoted(const std::string& text)
{
  return nlohmann::json(text).dump();
}

std::string ReaderOf(const std::vector<std::string>& files)
{
  std::vector<std::string> paths(files.size());
  std::ranges::transform(files, paths.begin(),
    [](const std::string& file) { return PythonQuoted(std::filesystem::absolute(file).string()); });
  const std::string suffix = std::filesystem::path(files.front()).extension().string();
  if (suffix == ".vtu" && files.size() == 1)
  {
    return "reader = vtkXMLUnstructuredGridReader()\nreader.SetFileName(" + paths[0] + ")\n";
  }
  const bool isMfem = suffix == ".mesh";
  if (!isMfem && suffix != ".xml")
  {
    return {};
  }
  std::string text = std::string("reader = ") + (isMfem ? "vtkMFEMReader" : "vtkNektarReader") +
    "()\nreader.SetFileName(" + paths[0] + ")\n";
  for (std::size_t k = 1; k < paths.size(); ++k)
  {
    const bool isSession = std::filesystem::path(files[k]).extension() == ".xml";
    text += std::string("reader.") +
      (isMfem         ? "AddGridFunctionFileName("
          : isSession ? "AddSessionFileName("
                      : "AddFieldFileName(") +
      paths[k] + ")\n";
  }
  return text;
}

std::string FunctionText(vtkImplicitFunction* function)
{
  if (auto* plane = vtkPlane::SafeDownCast(function))
  {
    const double* o = plane->GetOrigin();
    const double* n = plane->GetNormal();
    return fmt::format("function = vtkPlane()\nfunction.SetOrigin({}, {}, {})\n"
                       "function.SetNormal({}, {}, {})\n",
      o[0], o[1], o[2], n[0], n[1], n[2]);
  }
  if (auto* torus = vtkImplicitTorus::SafeDownCast(function))
  {
    const double* c = torus->GetCenter();
    const double* a = torus->GetAxis();
    return fmt::format("function = vtkImplicitTorus()\nfunction.SetCenter({}, {}, {})\n"
                       "function.SetAxis({}, {}, {})\nfunction.SetRadius({})\n"
                       "function.SetTubeRadius({})\n",
      c[0], c[1], c[2], a[0], a[1], a[2], torus->GetRadius(), torus->GetTubeRadius());
  }
  if (auto* box = vtkBox::SafeDownCast(function))
  {
    const double* b = box->GetBounds();
    return fmt::format("function = vtkBox()\nfunction.SetBounds({}, {}, {}, {}, {}, {})\n", b[0],
      b[1], b[2], b[3], b[4], b[5]);
  }
  auto* quadric = vtkQuadric::SafeDownCast(function);
  std::string text = "function = vtkQuadric()\nfunction.SetCoefficients([";
  for (int k = 0; k < 10; ++k)
  {
    text += fmt::format("{}{}", k > 0 ? ", " : "", quadric->GetCoefficients()[k]);
  }
  text += "])\n";
  if (auto* transform = vtkLinearTransform::SafeDownCast(quadric->GetTransform()))
  {
    const vtkMatrix4x4* matrix = transform->GetMatrix();
    text += fmt::format("transform = vtkTransform()\ntransform.Translate({}, {}, {})\n"
                        "function.SetTransform(transform)\n",
      matrix->GetElement(0, 3), matrix->GetElement(1, 3), matrix->GetElement(2, 3));
  }
  return text;
}

std::string PipelineText(const TradeSetting& setting, const Shot& shot)
{
  const std::string field = PythonQuoted(shot.scene.layers.front().field->name);
  const std::string cutter = "cut = vtkCutter()\ncut.SetCutFunction(function)\n";
  switch (setting.family)
  {
    case TradeFamily::Cut:
      return fmt::format("cut = vtkHighOrderLinearCut()\ncut.SetInputConnection(field)\n"
                         "cut.SetCutFunction(function)\ncut.SetResolution({})\ncut.AddField({})\n",
        setting.number, field);
    case TradeFamily::Resample:
    {
      const std::array<int, 3> nodes = NodesAlong(shot.input.grid, setting.number);
      return fmt::format("volume = vtkHighOrderLinearResample()\nvolume.SetInputConnection(field)\n"
                         "volume.SetDimensions({}, {}, {})\nvolume.AddField({})\n",
               nodes[0], nodes[1], nodes[2], field) +
        cutter + "cut.SetInputConnection(volume.GetOutputPort())\n";
    }
    case TradeFamily::Subdivide:
      return fmt::format("volume = vtkHighOrderSubdivide()\nvolume.SetInputConnection(field)\n"
                         "volume.SetLevel({})\nvolume.AddField({})\n",
               setting.number, field) +
        cutter + "cut.SetInputConnection(volume.GetOutputPort())\n";
    default:
      return cutter + "cut.SetInputConnection(field)\n";
  }
}
} // namespace

std::string ScriptOf(
  const TradeScene& scene, const TradeSetting& setting, const std::vector<std::string>& files)
{
  const std::string reader = ReaderOf(files);
  if (setting.family == TradeFamily::Exact || IsOfGradientFilter(setting.family) ||
    reader.empty() || !scene.function || !scene.shot->input.times.empty())
  {
    return {};
  }
  return "#!/usr/bin/env python3\n\"\"\"" + setting.name +
    R"(: a linear cut-surface, exact at its corners. Usage: FILE OUTPUT.vtp"""
import sys

from vtkmodules.vtkCommonDataModel import vtkBox, vtkPlane, vtkQuadric
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkCutter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridReader
from pixelexact import (
    vtkHighOrderLinearCut,
    vtkHighOrderLinearResample,
    vtkHighOrderSubdivide,
    vtkImplicitTorus,
    vtkMFEMReader,
    vtkNektarReader,
)

)" + reader +
    "field = reader.GetOutputPort()\n" + FunctionText(scene.function) +
    PipelineText(setting, *scene.shot) + R"(writer = vtkXMLPolyDataWriter()
writer.SetInputConnection(cut.GetOutputPort())
writer.SetFileName(sys.argv[1])
sys.exit(0 if writer.Write() else 1)
)";
}
} // namespace pixelexact
