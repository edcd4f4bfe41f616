// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderExtremes.h"

#include "Conversion/ConvertedGrid.h"
#include "Conversion/ModelSource.h"
#include "Core/Base/Error.h"
#include "Core/Element/Validity.h"
#include "Core/Expression/Expression.h"
#include "Core/Location/Extremes.h"
#include "Formats/Slab.h"
#include "HighOrderModel.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <initializer_list>

vtkStandardNewMacro(vtkHighOrderExtremes);

namespace
{
using namespace pixelexact;

const Field& FieldOrFirstOf(const HighOrderModel& model, const std::string& name)
{
  if (name.empty() && model.Fields().empty())
  {
    throw InvalidData("the grid has no field; give an expression with SetFieldName.");
  }
  return name.empty() ? model.Fields().front() : model.GetField(name);
}

RangeQuestion QuestionFor(const Field& field, int component)
{
  const int components = field.values.components;
  if (component < -1 || component >= components)
  {
    throw InvalidData("field '" + field.name + "' has " + std::to_string(components) +
      " components; there is no component " + std::to_string(component) + ".");
  }
  return component == -1 && components > 1
    ? RangeQuestion{ Quantity::Magnitude, &field }
    : RangeQuestion{ Quantity::Component, &field, std::max(component, 0) };
}

/// The points of the output and their arrays.
class ExtremePoints
{
public:
  void Add(const Extreme& extreme, const HighOrderModel& model, bool isMaximum)
  {
    if (extreme.element < 0)
    {
      return;
    }
    const vtkIdType id = Points->InsertNextPoint(extreme.x.x, extreme.x.y, extreme.x.z);
    Vertices->InsertNextCell(1, &id);
    Numbers[0]->InsertNextValue(extreme.value);
    Numbers[1]->InsertNextValue(extreme.bound);
    Numbers[2]->InsertNextValue(extreme.attained);
    Numbers[3]->InsertNextValue(extreme.gap);
    Xi->InsertNextTuple3(extreme.xi.x, extreme.xi.y, extreme.xi.z);
    Element->InsertNextValue(
      static_cast<vtkIdType>(model.SourceCells()[static_cast<std::size_t>(extreme.element)]));
    Maximum->InsertNextValue(isMaximum ? 1 : 0);
  }

  void Fill(vtkPolyData* output)
  {
    output->SetPoints(Points);
    output->SetVerts(Vertices);
    constexpr std::array kNames{ "Value", "Bound", "Attained", "Gap" };
    for (std::size_t k = 0; k < Numbers.size(); ++k)
    {
      Numbers[k]->SetName(kNames[k]);
      output->GetPointData()->AddArray(Numbers[k]);
    }
    Xi->SetName("Xi");
    Element->SetName("Element");
    Maximum->SetName("Maximum");
    for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{ Element, Xi, Maximum })
    {
      output->GetPointData()->AddArray(array);
    }
  }

  ExtremePoints()
  {
    Points->SetDataTypeToDouble();
    Xi->SetNumberOfComponents(3);
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Vertices;
  std::array<vtkNew<vtkDoubleArray>, 4> Numbers;
  vtkNew<vtkDoubleArray> Xi;
  vtkNew<vtkIdTypeArray> Element;
  vtkNew<vtkUnsignedCharArray> Maximum;
};
} // namespace

vtkHighOrderExtremes::vtkHighOrderExtremes()
  : MeshFilter(pixelexact::MeshScope::WholeOnFirst)
{
  this->vtkHighOrderExtremes::ResetReport();
}

vtkHighOrderExtremes::~vtkHighOrderExtremes() = default;

void vtkHighOrderExtremes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FieldName: " << this->FieldName << "\n";
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "ToleranceMet: " << this->ToleranceMet << "\n";
  os << indent << "NotFiniteElements: " << this->NotFiniteElements << "\n";
  os << indent << "UnboundedElements: " << this->UnboundedElements << "\n";
  os << indent << "InvertedElements: " << this->InvertedElements << "\n";
  os << indent << "UndecidedElements: " << this->UndecidedElements << "\n";
}

void vtkHighOrderExtremes::ResetReport()
{
  this->ToleranceMet = false;
  this->NotFiniteElements = 0;
  this->UnboundedElements = 0;
  this->InvertedElements = 0;
  this->UndecidedElements = 0;
}

bool vtkHighOrderExtremes::Make(vtkDataObject* mesh, vtkPolyData* output)
{
  const auto model = this->ModelOf(mesh);
  const Field& field = FieldOrFirstOf(*model, ChosenName(this, this->FieldName));
  RequireSurfaceRange(model->GetMesh(), field);
  const RangeQuestion question = QuestionFor(field, this->Component);
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(this->Input.GridOf(mesh));
  const bool isPlane = grid != nullptr && SlabOf(grid).has_value();
  const auto progress = [this](double from)
  { return [this, from](double part) { this->UpdateProgress(from + part / 2.0); }; };
  const Extremes found =
    FindExtremes(model->GetMesh(), question, isPlane, kExtremeEffort, progress(0.0));
  for (const auto& verdict : ValidityOf(model->GetMesh(), RangeEffort{}, progress(0.5)))
  {
    this->InvertedElements += verdict.validity == Validity::Inverted ? 1 : 0;
    this->UndecidedElements += verdict.validity == Validity::Undecided ? 1 : 0;
  }
  this->ToleranceMet = found.met;
  this->NotFiniteElements = found.notFinite;
  this->UnboundedElements = found.unbounded;
  ExtremePoints points;
  points.Add(found.minimum, *model, false);
  points.Add(found.maximum, *model, true);
  points.Fill(output);
  return true;
}
