// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderCertifier.h"

#include "Conversion/SourceMesh.h"
#include "Core/Base/Error.h"
#include "Core/Element/Validity.h"
#include "HighOrderArrays.h"
#include "HighOrderModel.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <map>

vtkStandardNewMacro(vtkHighOrderCertifier);

namespace
{
using namespace pixelexact;

constexpr unsigned char kNoElement = 255;

/// Two arrays of bounds, NaN to begin with.
class CellBounds
{
public:
  CellBounds(const std::string& lower, const std::string& upper, int components, vtkIdType cells)
    : Lower(Make(lower, components, cells))
    , Upper(Make(upper, components, cells))
  {
  }
  void Set(vtkIdType cell, int component, const CertifiedRange& range)
  {
    if (range.finite)
    {
      Lower->SetTypedComponent(cell, component, range.outer.lower);
      Upper->SetTypedComponent(cell, component, range.outer.upper);
    }
  }
  void AddTo(vtkCellData* data) const
  {
    data->AddArray(Lower);
    data->AddArray(Upper);
  }

private:
  static vtkSmartPointer<vtkDoubleArray> Make(
    const std::string& name, int components, vtkIdType cells)
  {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName(name.c_str());
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(cells);
    array->Fill(std::nan(""));
    return array;
  }
  vtkSmartPointer<vtkDoubleArray> Lower;
  vtkSmartPointer<vtkDoubleArray> Upper;
};

/// The cell of each element.
std::vector<vtkIdType> CellsOf(vtkUnstructuredGrid* grid, const HighOrderModel& model)
{
  // A plain grid's conversion may have left out cells.
  const bool same = HasHighOrderArrays(grid);
  // A part of a grid is numbered as in the whole.
  std::map<std::int64_t, vtkIdType> ofNumber;
  vtkDataArray* numbers = same ? nullptr : grid->GetCellData()->GetArray(kSourceCells);
  for (vtkIdType cell = 0; numbers != nullptr && cell < grid->GetNumberOfCells(); ++cell)
  {
    ofNumber.emplace(static_cast<std::int64_t>(numbers->GetComponent(cell, 0)), cell);
  }
  std::vector<vtkIdType> cells;
  cells.reserve(static_cast<std::size_t>(model.GetMesh().Elements()));
  for (int e = 0; e < model.GetMesh().Elements(); ++e)
  {
    const std::int64_t number = model.SourceCells()[static_cast<std::size_t>(e)];
    cells.push_back(same ? e : (numbers != nullptr ? ofNumber.at(number) : number));
  }
  return cells;
}
} // namespace

vtkHighOrderCertifier::vtkHighOrderCertifier()
  : MeshFilter(MeshScope::PartByBlock)
{
}

vtkHighOrderCertifier::~vtkHighOrderCertifier() = default;

void vtkHighOrderCertifier::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FieldName: " << this->FieldName << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumBoxes: " << this->MaximumBoxes << "\n";
}

bool vtkHighOrderCertifier::Make(vtkDataObject* input, vtkDataObject* output)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(input);
  const auto model = this->ModelOf(grid);
  const Mesh& mesh = model->GetMesh();
  const auto cells = CellsOf(grid, *model);
  const vtkIdType count = grid->GetNumberOfCells();
  const RangeEffort effort{ this->Tolerance, this->MaximumBoxes };
  const Field* field = this->FieldName.empty() ? nullptr : &model->GetField(this->FieldName);
  // Parts of the work, of about the same length each.
  const double parts = 2.0 + (field ? field->values.components : 0);
  double done = 0.0;
  const auto next = [&]() -> RangeProgress
  {
    const double from = done / parts;
    done += 1.0;
    return [this, from, parts](double part) { this->UpdateProgress(from + part / parts); };
  };

  const auto validity = ValidityOf(mesh, effort, next());
  const auto jacobian = ElementRanges(mesh, { Quantity::Jacobian }, effort, next());
  vtkNew<vtkUnsignedCharArray> verdict;
  verdict->SetName("Verdict");
  verdict->SetNumberOfValues(count);
  verdict->FillValue(kNoElement);
  CellBounds bounds("JacobianLower", "JacobianUpper", 1, count);
  for (std::size_t e = 0; e < cells.size(); ++e)
  {
    verdict->SetValue(cells[e], static_cast<unsigned char>(validity[e].validity));
    // Both ranges are valid; the search for the sign may have a tighter end at zero.
    CertifiedRange both = jacobian[e];
    both.outer = Intersect(both.outer, validity[e].jacobian.outer);
    bounds.Set(cells[e], 0, both);
  }
  output->ShallowCopy(grid);
  vtkCellData* data = vtkUnstructuredGrid::SafeDownCast(output)->GetCellData();
  data->AddArray(verdict);
  bounds.AddTo(data);
  if (field)
  {
    const int components = field->values.components;
    CellBounds values(this->FieldName + "_lower", this->FieldName + "_upper", components, count);
    for (int c = 0; c < components; ++c)
    {
      const auto ranges = ElementRanges(mesh, { Quantity::Component, field, c }, effort, next());
      for (std::size_t e = 0; e < cells.size(); ++e)
      {
        values.Set(cells[e], c, ranges[e]);
      }
    }
    values.AddTo(data);
  }
  return true;
}
