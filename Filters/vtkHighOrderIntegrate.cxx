// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderIntegrate.h"

#include "Conversion/ModelSource.h"
#include "Cuts/IntegralPieces.h"
#include "Cuts/IntegralRows.h"
#include "Cuts/SurfaceStatistics.h"
#include "HighOrderModel.h"

#include "Core/Base/Error.h"

#include "vtkDoubleArray.h"
#include "vtkImplicitFunction.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <string>

vtkStandardNewMacro(vtkHighOrderIntegrate);

namespace
{
using namespace pixelexact;

/// Null where the grid has none and none was named.
const Field* FieldOrNull(const HighOrderModel& model, const std::string& name)
{
  if (!name.empty())
  {
    return &model.GetField(name);
  }
  return model.Fields().empty() ? nullptr : &model.Fields().front();
}

/// As the property's.
constexpr double kDefaultTolerance = 1e-8;

void ToTable(const std::vector<IntegralRow>& rows, vtkTable* table)
{
  vtkNew<vtkStringArray> names;
  names->SetName("Quantity");
  table->AddColumn(names);
  const auto add = [table](const char* name)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    table->AddColumn(column);
    return column.Get();
  };
  vtkDoubleArray* const value = add("Value");
  vtkDoubleArray* const error = add("ErrorBound");
  vtkDoubleArray* const lower = add("Lower");
  vtkDoubleArray* const upper = add("Upper");
  for (const IntegralRow& row : rows)
  {
    names->InsertNextValue(row.quantity);
    value->InsertNextValue(row.Middle());
    error->InsertNextValue(row.Error());
    lower->InsertNextValue(row.value.lower);
    upper->InsertNextValue(row.value.upper);
  }
}
} // namespace

vtkHighOrderIntegrate::vtkHighOrderIntegrate()
  : MeshFilter(MeshScope::WholeOnFirst)
{
  this->vtkHighOrderIntegrate::ResetReport();
}

vtkHighOrderIntegrate::~vtkHighOrderIntegrate() = default;

void vtkHighOrderIntegrate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent
     << "CutFunction: " << (this->CutFunction ? this->CutFunction->GetClassName() : "(none)")
     << "\n";
  os << indent << "BoundaryAttributes:";
  for (const std::int32_t attribute : this->Attributes)
  {
    os << " " << attribute;
  }
  os << "\n" << indent << "Over: " << this->Over << "\n";
  os << indent << "ClipFunctions: " << this->ClipFunctions.size() << "\n";
  os << indent << "IsoFieldName: " << this->IsoFieldName << "\n";
  os << indent << "IsoComponent: " << this->IsoComponent << "\n";
  os << indent << "IsoValue: " << this->IsoValue << "\n";
  os << indent << "FieldName: " << this->FieldName << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "Seconds: " << this->Seconds << "\n";
  os << indent << "Norms: " << this->Norms << "\n";
  os << indent << "Extremes: " << this->Extremes << "\n";
  os << indent << "StatisticsClasses: " << this->StatisticsClasses << "\n";
  os << indent << "CorrelateWith: " << this->CorrelateWith << "\n";
  for (int d = 0; d < 3; ++d)
  {
    os << indent << "MinimumPoint " << d << ": " << this->MinimumPoint[d] << "\n";
    os << indent << "MaximumPoint " << d << ": " << this->MaximumPoint[d] << "\n";
  }
  os << indent << "ToleranceMet: " << this->ToleranceMet << "\n";
  os << indent << "UnresolvedArea: " << this->UnresolvedArea << "\n";
}

vtkMTimeType vtkHighOrderIntegrate::GetMTime()
{
  vtkMTimeType latest = this->Superclass::GetMTime();
  if (this->CutFunction)
  {
    latest = std::max(latest, this->CutFunction->GetMTime());
  }
  for (const auto& function : this->ClipFunctions)
  {
    latest = std::max(latest, function->GetMTime());
  }
  return latest;
}

void vtkHighOrderIntegrate::SetCutFunction(vtkImplicitFunction* function)
{
  vtkSetSmartPointerBodyMacro(CutFunction, vtkImplicitFunction, function);
}

vtkImplicitFunction* vtkHighOrderIntegrate::GetCutFunction()
{
  return this->CutFunction;
}

void vtkHighOrderIntegrate::AddClipFunction(vtkImplicitFunction* function)
{
  if (function == nullptr)
  {
    vtkErrorMacro("AddClipFunction: there is no function.");
    return;
  }
  this->ClipFunctions.emplace_back(function);
  this->Modified();
}

void vtkHighOrderIntegrate::ClearClipFunctions()
{
  if (!this->ClipFunctions.empty())
  {
    this->ClipFunctions.clear();
    this->Modified();
  }
}

int vtkHighOrderIntegrate::GetNumberOfClipFunctions()
{
  return static_cast<int>(this->ClipFunctions.size());
}

void vtkHighOrderIntegrate::AddBoundaryAttribute(int attribute)
{
  this->Attributes.push_back(attribute);
  this->Modified();
}

void vtkHighOrderIntegrate::ClearBoundaryAttributes()
{
  if (!this->Attributes.empty())
  {
    this->Attributes.clear();
    this->Modified();
  }
}

int vtkHighOrderIntegrate::GetNumberOfBoundaryAttributes()
{
  return static_cast<int>(this->Attributes.size());
}

int vtkHighOrderIntegrate::Chosen() const
{
  if (this->Over == OverCutFunction && !this->CutFunction)
  {
    throw InvalidData("there is no cut function; give one with SetCutFunction.");
  }
  if (this->Over != OverAny)
  {
    return this->Over;
  }
  const bool iso = !this->IsoFieldName.empty();
  if ((this->CutFunction ? 1 : 0) + (this->Attributes.empty() ? 0 : 1) + (iso ? 1 : 0) > 1)
  {
    throw InvalidData("there are several of a cut function, an iso-surface and attributes of the "
                      "boundary; integrate over one of them at a time.");
  }
  return this->CutFunction ? OverCutFunction : iso ? OverIsoSurface : OverBoundary;
}

void vtkHighOrderIntegrate::ResetReport()
{
  this->ToleranceMet = false;
  this->UnresolvedArea = 0.0;
  std::fill_n(this->MinimumPoint, 3, std::numeric_limits<double>::quiet_NaN());
  std::fill_n(this->MaximumPoint, 3, std::numeric_limits<double>::quiet_NaN());
}

std::vector<ImplicitPolynomial> vtkHighOrderIntegrate::ClipsFor(vtkDataObject* /*mesh*/)
{
  std::vector<ImplicitPolynomial> clips;
  for (const auto& function : this->ClipFunctions)
  {
    std::ranges::copy(IntegralClipsOf(function), std::back_inserter(clips));
  }
  return clips;
}

std::vector<SurfacePatch> vtkHighOrderIntegrate::PatchesFor(vtkDataObject* mesh)
{
  const std::vector<ImplicitPolynomial> clips = this->ClipsFor(mesh);
  std::vector<SurfacePatch> patches = IntegralPatchesOf(this->CutFunction);
  for (SurfacePatch& patch : patches)
  {
    std::ranges::copy(clips, std::back_inserter(patch.clips));
  }
  return patches;
}

bool vtkHighOrderIntegrate::Make(vtkDataObject* mesh, vtkTable* output)
{
  const int over = this->Chosen();
  const auto model = this->ModelOf(mesh);
  if (over != OverBoundary)
  {
    model->RequireSolids("an integral over a cut");
  }
  const Field* const field = FieldOrNull(*model, ChosenName(this, this->FieldName));
  const IntegralEffort effort{ this->Tolerance,
    this->Seconds != 0.0 ? this->Seconds : std::numeric_limits<double>::infinity() };
  this->UpdateProgress(0.2);
  const auto clips =
    over == OverCutFunction ? std::vector<ImplicitPolynomial>() : this->ClipsFor(mesh);
  const auto patches =
    over == OverCutFunction ? this->PatchesFor(mesh) : std::vector<SurfacePatch>();
  std::optional<IsoValueSurface> iso;
  if (over == OverIsoSurface)
  {
    const Field* const ofIso = FieldOrNull(*model, this->IsoFieldName);
    if (ofIso == nullptr)
    {
      throw InvalidData("there is no field to take an iso-surface of.");
    }
    iso.emplace(*ofIso, this->IsoComponent, this->IsoValue);
  }
  const SurfaceDomain domain = over == OverCutFunction ? DomainOfPatches(patches, {}, *model)
    : iso                                              ? DomainOfCut(*iso, clips, *model)
          : DomainOfBoundary(this->Attributes, clips, *model);
  const SurfaceIntegral found = domain.integrate(field, effort, std::nullopt);
  std::vector<IntegralRow> rows = RowsOf({ model->GetMesh(), field, nullptr }, found);
  std::string doubts;
  StatisticsRequest request{ this->Norms, this->Extremes, this->StatisticsClasses,
    this->CorrelateWith, effort, this->Tolerance != kDefaultTolerance };
  if (!request.IsEmpty())
  {
    if (field == nullptr)
    {
      throw InvalidData(
        "the grid has no field; norms, extremes and statistics are those of a field.");
    }
    this->UpdateProgress(0.5);
    const SurfaceStatistics more = FindStatistics(*model, field->name, domain, found, request);
    rows.insert(rows.end(), more.rows.begin(), more.rows.end());
    for (std::size_t k = 0; k < more.histogram.size(); ++k)
    {
      rows.push_back({ "Class " + std::to_string(k + 1), more.histogram[k].part });
    }
    for (int d = 0; d < 3 && more.extremes; ++d)
    {
      this->MinimumPoint[d] = more.extremes->extremes.minimum.x[d];
      this->MaximumPoint[d] = more.extremes->extremes.maximum.x[d];
    }
    for (const std::string& note : more.notes)
    {
      doubts += note + "\n";
    }
  }
  this->UpdateProgress(0.9);
  ToTable(rows, output);
  this->ToleranceMet = found.met;
  this->UnresolvedArea = found.unresolved;
  for (const std::string& doubt : DoubtsOf(found, this->Tolerance))
  {
    doubts += doubt + "\n";
  }
  if (!doubts.empty())
  {
    vtkWarningMacro(<< doubts);
  }
  return true;
}
