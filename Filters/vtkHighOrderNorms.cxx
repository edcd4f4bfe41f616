// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderNorms.h"

#include "Conversion/ConvertedGrid.h"
#include "Conversion/ModelSource.h"
#include "Core/Base/Error.h"
#include "Core/Integral/FieldNorms.h"
#include "Formats/Slab.h"
#include "HighOrderModel.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

vtkStandardNewMacro(vtkHighOrderNorms);

namespace
{
using namespace pixelexact;

constexpr double kNothingKnown = std::numeric_limits<double>::quiet_NaN();

void ToTable(const FieldNorms& norms, const HighOrderModel& model, vtkTable* table)
{
  vtkNew<vtkIdTypeArray> elements;
  elements->SetName("Element");
  table->AddColumn(elements);
  constexpr std::array kNames{ "Volume", "L1", "L2", "L2Error", "Largest" };
  std::array<vtkNew<vtkDoubleArray>, kNames.size()> columns;
  for (std::size_t k = 0; k < kNames.size(); ++k)
  {
    columns[k]->SetName(kNames[k]);
    table->AddColumn(columns[k]);
  }
  for (std::size_t e = 0; e < norms.elements.size(); ++e)
  {
    const ElementNorms& one = norms.elements[e];
    const double l2 = std::sqrt(one.square.value);
    const std::array<double, kNames.size()> numbers{ one.volume.value, one.absolute.value, l2,
      std::sqrt(one.square.value + one.square.error) - l2, one.largest };
    elements->InsertNextValue(static_cast<vtkIdType>(model.SourceCells()[e]));
    for (std::size_t k = 0; k < kNames.size(); ++k)
    {
      columns[k]->InsertNextValue(one.isFinite ? numbers[k] : kNothingKnown);
    }
  }
}
} // namespace

vtkHighOrderNorms::vtkHighOrderNorms()
  : MeshFilter(pixelexact::MeshScope::WholeOnFirst)
{
  this->vtkHighOrderNorms::ResetReport();
}

vtkHighOrderNorms::~vtkHighOrderNorms() = default;

void vtkHighOrderNorms::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FieldName: " << this->FieldName << "\n";
  os << indent << "Volume: " << this->Volume << "\n";
  os << indent << "VolumeError: " << this->VolumeError << "\n";
  os << indent << "L1: " << this->L1 << "\n";
  os << indent << "L1Error: " << this->L1Error << "\n";
  os << indent << "L2: " << this->L2 << "\n";
  os << indent << "L2Error: " << this->L2Error << "\n";
  os << indent << "LinfLower: " << this->LinfLower << "\n";
  os << indent << "LinfUpper: " << this->LinfUpper << "\n";
  os << indent << "LargestSample: " << this->LargestSample << "\n";
  os << indent << "ToleranceMet: " << this->ToleranceMet << "\n";
  os << indent << "NotFiniteElements: " << this->NotFiniteElements << "\n";
  os << indent << "FoldedElements: " << this->FoldedElements << "\n";
  os << indent << "ElementsWith90Percent: " << this->ElementsWith90Percent << "\n";
}

void vtkHighOrderNorms::ResetReport()
{
  for (double* const number : { &this->Volume, &this->VolumeError, &this->L1, &this->L1Error,
         &this->L2, &this->L2Error, &this->LinfLower, &this->LinfUpper, &this->LargestSample })
  {
    *number = kNothingKnown;
  }
  this->ToleranceMet = false;
  this->NotFiniteElements = 0;
  this->FoldedElements = 0;
  this->ElementsWith90Percent = 0;
}

bool vtkHighOrderNorms::Make(vtkDataObject* mesh, vtkTable* output)
{
  const auto model = this->ModelOf(mesh);
  model->RequireSolids("norms over a mesh");
  const std::string name = ChosenName(this, this->FieldName);
  if (name.empty() && model->Fields().empty())
  {
    throw InvalidData("the grid has no field; give an expression with SetFieldName.");
  }
  const Field& field = name.empty() ? model->Fields().front() : model->GetField(name);
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(this->Input.GridOf(mesh));
  const std::optional<Slab> slab = grid != nullptr ? SlabOf(grid) : std::nullopt;
  NormEffort effort;
  for (const Field& one : model->Fields())
  {
    for (const Space& space : one.values.spaces)
    {
      effort.order = std::max(effort.order, space.MaxOrder());
    }
  }
  const FieldNorms norms = FindNorms(model->GetMesh(), field, slab ? slab->thickness : 0.0, effort,
    [this](double part) { this->UpdateProgress(0.5 * part); });
  const std::optional<Interval> largest = LargestMagnitude(
    model->GetMesh(), field, [this](double part) { this->UpdateProgress(0.5 + 0.5 * part); });
  ToTable(norms, *model, output);
  this->Volume = norms.volume.value;
  this->VolumeError = norms.volume.error;
  this->L1 = norms.l1.value;
  this->L1Error = norms.l1.error;
  this->L2 = norms.l2.value;
  this->L2Error = norms.l2.error;
  this->LinfLower = largest ? largest->lower : kNothingKnown;
  this->LinfUpper = largest ? largest->upper : kNothingKnown;
  this->LargestSample = norms.largestElement < 0 ? kNothingKnown : norms.largest;
  this->ToleranceMet = norms.met;
  this->NotFiniteElements = norms.notFinite;
  this->FoldedElements = norms.folded;
  this->ElementsWith90Percent = CountWithPart(norms, kCountedPart);
  return true;
}
