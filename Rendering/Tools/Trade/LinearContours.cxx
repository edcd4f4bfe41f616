// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/LinearContours.h"

#include "Surfaces/VtkLinearSurface.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

namespace pixelexact
{
vtkSmartPointer<vtkContourFilter> MakeLinearContours(
  vtkPolyData* surface, const Layer& layer, std::span<const double> isoValues)
{
  vtkDataArray* const values = surface->GetPointData()->GetArray(layer.field->name.c_str());
  if (values == nullptr)
  {
    return nullptr;
  }
  vtkNew<vtkPolyData> input;
  input->CopyStructure(surface);
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetNumberOfValues(values->GetNumberOfTuples());
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    scalars->SetValue(i, ValueAt(values, i, layer.component));
  }
  input->GetPointData()->SetScalars(scalars);
  vtkNew<vtkContourFilter> contours;
  contours->SetInputData(input);
  for (std::size_t k = 0; k < isoValues.size(); ++k)
  {
    contours->SetValue(static_cast<int>(k), isoValues[k]);
  }
  return contours;
}
} // namespace pixelexact
