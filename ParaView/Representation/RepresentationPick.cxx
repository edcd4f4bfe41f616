// SPDX-License-Identifier: BSD-3-Clause
#include "RepresentationInternals.h"
#include "vtkHighOrderPicker.h"
#include "vtkHighOrderProbe.h"
#include "vtkPixelExactRepresentation.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <limits>
#include <sstream>
#include <utility>

// What is known of a pixel: vtkHighOrderPicker asked for this representation's actor alone.

namespace
{
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// An interval proven to hold a scalar field's value at a point; NaN where there is none.
std::array<double, 2> EnclosureAt(vtkDataObject* grid, const char* field, const double x[3])
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(x);
  vtkNew<vtkPolyData> where;
  where->SetPoints(points);
  vtkNew<vtkHighOrderProbe> probe;
  probe->SetInputData(where);
  probe->SetSourceData(grid);
  probe->AddField(field);
  probe->EnclosuresOn();
  probe->Update();
  vtkPointData* found = vtkDataSet::SafeDownCast(probe->GetOutputDataObject(0))->GetPointData();
  const std::string name = field;
  vtkDataArray* lower = found->GetArray((name + "_lower").c_str());
  vtkDataArray* upper = found->GetArray((name + "_upper").c_str());
  if (lower == nullptr || upper == nullptr || lower->GetNumberOfComponents() != 1)
  {
    return { kNothing, kNothing };
  }
  return { lower->GetComponent(0, 0), upper->GetComponent(0, 0) };
}
} // namespace

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetPickedPixel(int x, int y)
{
  this->Data->PickedPixel = { x, y };
}

//------------------------------------------------------------------------------
double* vtkPixelExactRepresentation::GetPicked()
{
  Internals& my = *this->Data;
  my.Picked.fill(kNothing);
  my.Picked[0] = 0.0;
  my.Picked[1] = -1.0;
  my.PickedText.clear();
  if (my.Renderer == nullptr || my.PickedPixel[0] < 0 || my.PickedPixel[1] < 0 ||
    !my.Actor->GetVisibility())
  {
    return my.Picked.data();
  }
  vtkNew<vtkHighOrderPicker> picker;
  picker->PickFromListOn();
  picker->AddPickList(my.Actor);
  picker->Pick(my.PickedPixel[0], my.PickedPixel[1], 0.0, my.Renderer);
  if (picker->GetVerdict() == 0)
  {
    return my.Picked.data();
  }
  my.Picked[0] = picker->GetVerdict();
  my.Picked[1] = static_cast<double>(picker->GetElement());
  std::copy_n(picker->GetXi(), 3, &my.Picked[2]);
  my.Picked[5] = picker->GetValue();
  std::copy_n(picker->GetMapperPosition(), 3, &my.Picked[8]);
  std::ostringstream text;
  text.precision(17);
  if (picker->GetVerdict() != 1)
  {
    my.PickedText = "the element could not be decided";
    return my.Picked.data();
  }
  text << "element " << picker->GetElement() << ", xi (" << my.Picked[2] << ", " << my.Picked[3]
       << ", " << my.Picked[4] << ")";
  if (const std::string field = picker->GetFieldName(); !field.empty())
  {
    const auto enclosure = EnclosureAt(my.Delivered, field.c_str(), &my.Picked[8]);
    std::copy_n(enclosure.data(), 2, &my.Picked[6]);
    text << ", " << field << " = " << my.Picked[5];
    if (enclosure[0] <= enclosure[1])
    {
      text << " in [" << enclosure[0] << ", " << enclosure[1] << "]";
    }
  }
  my.PickedText = text.str();
  return my.Picked.data();
}

//------------------------------------------------------------------------------
const char* vtkPixelExactRepresentation::GetPickedText()
{
  this->GetPicked();
  return this->Data->PickedText.c_str();
}

//------------------------------------------------------------------------------
std::string vtkPixelExactRepresentation::TextAt(int x, int y)
{
  auto* processes = vtkMultiProcessController::GetGlobalController();
  if (processes != nullptr && processes->GetNumberOfProcesses() > 1)
  {
    return {};
  }
  const std::array<int, 2> before = std::exchange(this->Data->PickedPixel, { x, y });
  std::string text = this->GetPickedText();
  this->Data->PickedPixel = before;
  // In lines, for a view may be narrow.
  for (const char* part : { " xi (", "), ", " in [" })
  {
    const std::size_t at = text.find(part);
    if (at != std::string::npos)
    {
      text[text.find(' ', at)] = '\n';
    }
  }
  return text;
}

//------------------------------------------------------------------------------
const char* vtkPixelExactRepresentation::GetPointerText()
{
  return this->Data->Notes.PointerText().c_str();
}

//------------------------------------------------------------------------------
vtkIdType vtkPixelExactRepresentation::GetNumberOfUnknownPixels()
{
  return this->Data->Mapper->GetNumberOfUnknownPixels();
}
