// SPDX-License-Identifier: BSD-3-Clause
#include "Input/Input.h"

#include "Base/Numbers.h"

// How INPUT is asked for on the command line.
namespace pixelexact
{
namespace
{
int ParseStep(const std::string& text, bool mayBeAll)
{
  int number = 0;
  if (!ParseInteger(text, number) || number < 0)
  {
    Refuse("--time-step", text,
      mayBeAll
        ? "the number of a step, counted from 0, or all (info names the times)"
        : "the number of one step, counted from 0 (call once for each; info names the times)");
  }
  return number;
}
} // namespace

void AddField(CLI::App& command, std::string& field)
{
  AddText(command, "--field", field, "NAME",
    "Name of the field, or an expression of fields, such as mag(curl(vec(u,v,w))) (default: the "
    "first one, which is named on stderr)");
}

void InputRequest::AddTo(CLI::App& command, bool required)
{
  AddArguments(command, "INPUT", files, "FILE",
    "The mesh file (" + InputSuffixes() +
      ") and, where the "
      "format keeps them apart, its field files (.gf; .fld, .chk or .rst; .msh without a mesh); "
      "x.000000 and u.000000 "
      "stand "
      "for all pieces that a parallel run of MFEM wrote; further .xml files are the rest of a "
      "Nektar++ session or parts of its mesh; numbered .vtu or .pvtu files, several Nektar++ "
      "field files and several .mfem_root files make a time series")
    .Required(required);
  const AddedOption number = AddRead(
    command, "--time-step",
    [this](const std::string& text)
    {
      allSteps = mayBeAll && text == "all";
      step = allSteps ? std::nullopt : std::optional(ParseStep(text, mayBeAll));
    },
    mayBeAll ? "N|all" : "N",
    std::string("Time step, counted from 0 (default: the first)") +
      (mayBeAll ? "; all: a picture of each" : ""));
  AddNumber(command, "--time", time, "T", "Time; of the steps the nearest one").Excludes(number);
  AddChoice(
    command, "--nodes", [this](const std::string& text) { gaussLobatto = text == "gll"; },
    { "equispaced", "gll" },
    "Where the nodes of VTK's Lagrange cells are: equispaced (default), or at "
    "Gauss-Lobatto-Legendre "
    "points");
  AddFlag(command, "--mirrored-wedges", mirroredWedges,
    "VTK's Lagrange wedges have MFEM's order of nodes");
}
} // namespace pixelexact
