// SPDX-License-Identifier: BSD-3-Clause
#include "RepresentationInternals.h"
#include "vtkHighOrderPicker.h"
#include "vtkHighOrderProbe.h"
#include "vtkPixelExactRepresentation.h"

#include "vtkCamera.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

// Picking. Each process calls vtkHighOrderPicker for its part, with this representation's actor
// alone.

namespace
{
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// An interval that is proven to contain a scalar field's value at a point; NaN where there is
/// none.
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

/// An end of an interval, rounded outward to `digits` where these do not distinguish all doubles.
/// Values near the limits of doubles are not rounded.
double RoundedOutward(double end, int digits, bool isUpper)
{
  const double unit = std::pow(10.0, std::floor(std::log10(std::fabs(end))) + 1 - digits);
  const double units = end / unit;
  if (!std::isnormal(unit) || !std::isfinite(units) ||
    digits >= std::numeric_limits<double>::max_digits10)
  {
    return end;
  }
  return unit * (isUpper ? std::floor(units) + 1.0 : std::ceil(units) - 1.0);
}

/// The depth of a point in front of the camera.
double DepthOf(const double x[3], vtkCamera* camera)
{
  double away[3];
  vtkMath::Subtract(x, camera->GetPosition(), away);
  return vtkMath::Dot(away, camera->GetDirectionOfProjection());
}

/// A process' result: verdict and depth.
using Finding = std::array<double, 2>;

/// The process whose result is nearest to the camera, -1 where there is none. Where parts meet,
/// several processes have the point: a certain result precedes, then the first process, whose
/// elements come first in the whole mesh.
int NearestOf(const std::vector<Finding>& all)
{
  // Relative to the depth. Hits of one surface differ by rounding and by the last Newton step.
  constexpr double kSame = 1e-12;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Finding& one : all)
  {
    nearest = one[0] != 0.0 ? std::min(nearest, one[1]) : nearest;
  }
  int best = -1;
  for (std::size_t p = 0; p < all.size(); ++p)
  {
    const bool isThere = all[p][0] != 0.0 && all[p][1] <= nearest + kSame * std::fabs(nearest);
    const bool isSurer = best >= 0 && all[p][0] == 1.0 && all[best][0] != 1.0;
    if (isThere && (best < 0 || isSurer))
    {
      best = static_cast<int>(p);
    }
  }
  return best;
}
} // namespace

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::Internals::PickedPoint::Clear()
{
  numbers.fill(kNothing);
  numbers[0] = 0.0;
  numbers[1] = -1.0;
  text.clear();
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::Internals::Describe(
  vtkHighOrderPicker* picker, PickedPoint& point)
{
  point.numbers[0] = picker->GetVerdict();
  point.numbers[1] = static_cast<double>(picker->GetElement());
  std::copy_n(picker->GetXi(), 3, &point.numbers[2]);
  point.numbers[5] = picker->GetValue();
  std::copy_n(picker->GetMapperPosition(), 3, &point.numbers[8]);
  if (picker->GetVerdict() != 1)
  {
    point.text = "the element could not be decided";
    return;
  }
  std::ostringstream text;
  text.precision(point.digits);
  text << "element " << picker->GetElement() << ", xi (" << point.numbers[2] << ", "
       << point.numbers[3] << ", " << point.numbers[4] << ")";
  if (const std::string field = picker->GetFieldName(); !field.empty())
  {
    const auto enclosure = EnclosureAt(Delivered, field.c_str(), &point.numbers[8]);
    std::copy_n(enclosure.data(), 2, &point.numbers[6]);
    text << ", " << field
         << (Interpolated.contains(field) ? " (interpolated, not the formula)" : "") << " = "
         << point.numbers[5];
    if (enclosure[0] <= enclosure[1])
    {
      text << " in [" << RoundedOutward(enclosure[0], point.digits, false) << ", "
           << RoundedOutward(enclosure[1], point.digits, true) << "]";
    }
  }
  point.text = text.str();
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::Internals::Pick(int x, int y, PickedPoint& point)
{
  point.Clear();
  vtkNew<vtkHighOrderPicker> picker;
  Finding own{ 0.0, 0.0 };
  if (Renderer != nullptr && x >= 0 && y >= 0 && Actor->GetVisibility())
  {
    picker->PickFromListOn();
    picker->AddPickList(Actor);
    picker->Pick(x, y, 0.0, Renderer);
    own = { static_cast<double>(picker->GetVerdict()),
      DepthOf(picker->GetPickPosition(), Renderer->GetActiveCamera()) };
  }
  if (!HasSeveralProcesses())
  {
    if (own[0] != 0.0)
    {
      Describe(picker, point);
    }
    return;
  }
  auto* processes = vtkMultiProcessController::GetGlobalController();
  std::vector<Finding> all(static_cast<std::size_t>(processes->GetNumberOfProcesses()));
  processes->AllGather(own.data(), all.front().data(), static_cast<vtkIdType>(own.size()));
  const int nearest = NearestOf(all);
  if (nearest < 0)
  {
    return;
  }
  vtkMultiProcessStream stream;
  if (processes->GetLocalProcessId() == nearest)
  {
    Describe(picker, point);
    for (const double number : point.numbers)
    {
      stream << number;
    }
    stream << point.text;
  }
  processes->Broadcast(stream, nearest);
  if (processes->GetLocalProcessId() != nearest)
  {
    for (double& number : point.numbers)
    {
      stream >> number;
    }
    stream >> point.text;
  }
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::AfterRender()
{
  Internals& my = *this->Data;
  // Scripts query the first process only, so results are gathered here, where all processes run.
  // Selections render more often, and not for the user.
  if (!Internals::HasSeveralProcesses() || !this->GetVisibility() || my.Renderer == nullptr ||
    my.Renderer->GetSelector() != nullptr)
  {
    return;
  }
  const vtkIdType own = my.Actor->GetVisibility() ? my.Mapper->GetNumberOfUnknownPixels() : 0;
  vtkMultiProcessController::GetGlobalController()->AllReduce(
    &own, &my.UnknownPixels, 1, vtkCommunicator::SUM_OP);
  // Negates the lower end, so that one maximum gives both ends.
  const std::array range = my.OwnVisibleRange();
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  const bool any = range[0] <= range[1];
  const std::array ends{ any ? -range[0] : kNone, any ? range[1] : kNone };
  std::array<double, 2> largest;
  vtkMultiProcessController::GetGlobalController()->AllReduce(
    ends.data(), largest.data(), 2, vtkCommunicator::MAX_OP);
  my.SeenByAll =
    largest[1] > kNone ? std::array{ -largest[0], largest[1] } : std::array{ 1.0, -1.0 };
  if (my.PickedPixel[0] >= 0 && my.PickedPixel[1] >= 0)
  {
    my.Pick(my.PickedPixel[0], my.PickedPixel[1], my.Picked);
  }
}

//------------------------------------------------------------------------------
std::array<double, 2> vtkPixelExactRepresentation::Internals::OwnVisibleRange()
{
  if (!Actor->GetVisibility())
  {
    return { 1.0, -1.0 };
  }
  const double* const range = Mapper->GetSeenRange();
  return { range[0], range[1] };
}

//------------------------------------------------------------------------------
double* vtkPixelExactRepresentation::GetVisibleRange()
{
  Internals& my = *this->Data;
  my.VisibleRange = Internals::HasSeveralProcesses() ? my.SeenByAll : my.OwnVisibleRange();
  return my.VisibleRange.data();
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetPickedPixel(int x, int y)
{
  this->Data->PickedPixel = { x, y };
  this->Data->Picked.Clear();
}

//------------------------------------------------------------------------------
double* vtkPixelExactRepresentation::GetPicked()
{
  Internals& my = *this->Data;
  if (!Internals::HasSeveralProcesses())
  {
    my.Pick(my.PickedPixel[0], my.PickedPixel[1], my.Picked);
  }
  return my.Picked.numbers.data();
}

//------------------------------------------------------------------------------
const char* vtkPixelExactRepresentation::GetPickedText()
{
  this->GetPicked();
  return this->Data->Picked.text.c_str();
}

//------------------------------------------------------------------------------
const char* vtkPixelExactRepresentation::PickAt(int x, int y)
{
  Internals& my = *this->Data;
  my.Pick(x, y, my.Pointed);
  return my.Pointed.text.c_str();
}

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::SetPointerSource(std::function<std::string(int, int)> source)
{
  this->Data->PointerSource = std::move(source);
}

//------------------------------------------------------------------------------
std::string vtkPixelExactRepresentation::TextAt(int x, int y)
{
  Internals& my = *this->Data;
  std::string text = my.PointerSource ? my.PointerSource(x, y) : this->PickAt(x, y);
  // Breaks the text into lines, because a view may be narrow.
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
  return Internals::HasSeveralProcesses() ? this->Data->UnknownPixels
                                          : this->Data->Mapper->GetNumberOfUnknownPixels();
}
