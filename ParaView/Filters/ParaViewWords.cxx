// SPDX-License-Identifier: BSD-3-Clause
// The names that messages have in ParaView: its filters, panels and properties.
#include "MessageWords.h"

namespace pixelexact
{
namespace
{
[[maybe_unused]] const bool kHasWords = []
{
  SetMessageWords({
    // Sentences about functions.
    { "run vtkUnstructuredGridToHighOrderGrid again (in ParaView: PixelExact Convert)",
      "apply PixelExact Convert to it" },
    { "pass it through vtkUnstructuredGridToHighOrderGrid first",
      "apply PixelExact Convert first" },
    { "vtkAppendFilter; ParaView: Append Datasets", "Append Datasets" },
    { "then vtkAppendFilter or Merge Blocks", "then Append Datasets or Merge Blocks" },
    { "Leave out SetMirroredWedges (--mirrored-wedges)", "Switch Mirrored Wedges off" },
    { "Have them mirrored back by SetMirroredWedges (--mirrored-wedges)",
      "Switch Mirrored Wedges on" },
    { "SetSurfaceElements (--surface-elements)", "Surface Elements" },
    { "switch SurfaceElements off (leave out --surface-elements)", "switch Surface Elements off" },
    { "leave out --surface-elements", "switch Surface Elements off" },
    { "--surface-elements reads", "Surface Elements reads" },
    { "Leave out SetNodePlacement (--nodes gll)", "Set Nodes to Equispaced" },
    { "Have them taken as such by SetNodePlacement (--nodes gll; triangles to order 3)",
      "Set Nodes to Gauss-Lobatto (triangles to order 3)" },
    { "(SetNodePlacement, --nodes gll)", "(Nodes: Gauss-Lobatto)" },
    { "give one with SetCutFunction", "choose a cut function" },
    { "call SetFileName", "open one" },
    { "call SetCutFunction, SetSurface or AddLayer", "choose a Surface under Display" },
    { "set ResultArrayName", "type one under Result Array Name" },
    { "another ResultArrayName", "another Result Array Name" },
    { "set Function", "type one under Function" },
    { "raise that number", "raise that number under Properties" },
    { "MaximumNumberOfNodes", "Maximum Number Of Nodes" },
    { "PixelExact's classes use", "PixelExact's pictures and filters use" },
    { "whoever asked this mapper for its input (vtkCellPicker, vtkPointPicker or an exporter) gets "
      "an empty vtkPolyData. Pick with vtkHighOrderPicker, vtkPropPicker or "
      "vtkHardwareSelector; to export, write the picture (vtkWindowToImageFilter), the mapper's "
      "GetBuffers(), or polygons of your own made from its input by GetInput().",
      "Export Scene writes nothing for it, and picks do not find it. Export the triangles of "
      "PixelExact Linear Cut or the lines of PixelExact Contour, shown in its place, or save the "
      "picture by Save Screenshot; pick by Value Under Pointer." },
    // Filters.
    { "vtkUnstructuredGridToHighOrderGrid", "PixelExact Convert" },
    { "vtkHighOrderPack", "PixelExact Pack" },
    { "vtkAppendFilter", "Append Datasets" },
    { "vtkExtractBlock", "Extract Block" },
    { "vtkExtractCells", "Extract Selection" },
    { "ExtractCells", "Extract Selection" },
    // Data and functions.
    { "vtkUnstructuredGrid", "unstructured grid" },
    { "vtkPolyData", "polygonal mesh" },
    { "vtkPVPlane", "plane" },
    { "vtkPVCylinder", "cylinder" },
    { "vtkPVBox", "box" },
    { "vtkPlane", "plane" },
    { "vtkSphere", "sphere" },
    { "vtkCylinder", "cylinder" },
    { "vtkBox", "box" },
    { "vtkQuadric", "quadric" },
    { "vtkImplicitTorus", "torus" },
  });
  return true;
}();
} // namespace
} // namespace pixelexact
