// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderComparison.h"

#include "ContourList.h"
#include "Core/Base/Error.h"
#include "Core/Location/Locator.h"
#include "HighOrderModel.h"
#include "MessageWords.h"
#include "Surfaces/SeenCut.h"
#include "Surfaces/VtkLinearSurface.h"
#include "Surfaces/VtkSurface.h"
#include "Trace/Compare/TracedPicture.h"
#include "Views/FieldChoice.h"
#include "Views/FittedView.h"
#include "Views/GridModel.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <vector>

vtkStandardNewMacro(vtkHighOrderComparison);

namespace
{
using namespace pixelexact;

/// The numbers of a linear surface.
struct Row
{
  std::int64_t triangles;
  PictureErrors errors;
};

/// Adds a column with a number of each row.
template <class Array, class Number>
void AddColumn(
  vtkTable* table, const char* name, const std::vector<Row>& rows, const Number& number)
{
  vtkNew<Array> column;
  column->SetName(name);
  for (const Row& row : rows)
  {
    column->InsertNextValue(number(row));
  }
  table->AddColumn(column);
}

void Fill(vtkTable* table, const std::vector<Row>& rows, double range)
{
  const auto count = [&](const char* name, std::int64_t PictureErrors::*member)
  {
    AddColumn<vtkTypeInt64Array>(
      table, name, rows, [member](const Row& row) { return row.errors.*member; });
  };
  const auto error = [&](const char* name, double PictureErrors::*member)
  {
    AddColumn<vtkDoubleArray>(table, name, rows,
      [member, range](const Row& row)
      { return range > 0.0 ? row.errors.*member / range : row.errors.*member; });
  };
  std::int64_t surface = 0;
  AddColumn<vtkTypeInt64Array>(
    table, "Surface", rows, [&surface](const Row& /*row*/) { return surface++; });
  AddColumn<vtkTypeInt64Array>(
    table, "Triangles", rows, [](const Row& row) { return row.triangles; });
  count("Shown", &PictureErrors::shown);
  count("Missing", &PictureErrors::missing);
  count("Invented", &PictureErrors::invented);
  error("LargestError", &PictureErrors::largest);
  error("MeanError", &PictureErrors::mean);
  error("ErrorAtShare", &PictureErrors::atShare);
  count("WrongColors", &PictureErrors::wrongBin);
  if (!rows.empty() && rows.front().errors.hasContours)
  {
    count("ContourPixels", &PictureErrors::contourPixels);
    count("ContourMissed", &PictureErrors::contourMissed);
    count("ContourDisplaced", &PictureErrors::contourDisplaced);
    count("ContourInvented", &PictureErrors::contourInvented);
    AddColumn<vtkDoubleArray>(
      table, "ContourFarthest", rows, [](const Row& row) { return row.errors.contourFarthest; });
  }
}

/// The range of the finite values at exact pixels.
std::array<double, 2> RangeOf(const Picture& picture)
{
  std::array<double, 2> range{ std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };
  for (const double value : picture.value)
  {
    if (std::isfinite(value))
    {
      range = { std::min(range[0], value), std::max(range[1], value) };
    }
  }
  return range[0] <= range[1] ? range : std::array{ 0.0, 0.0 };
}
} // namespace

vtkHighOrderComparison::vtkHighOrderComparison()
  : Cut(std::make_unique<SeenCut>())
  , Contours(std::make_unique<ContourList>())
  , Model(std::make_unique<GridModel>())
{
  this->SetNumberOfInputPorts(2);
}

vtkHighOrderComparison::~vtkHighOrderComparison() = default;

void vtkHighOrderComparison::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Cut->Print(os, indent, this->Size);
  os << indent << "FieldName: " << this->FieldName << "\n";
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "NumberOfColors: " << this->NumberOfColors << "\n";
  os << indent << "Share: " << this->Share << "\n";
  os << indent << "NumberOfContours: " << this->Contours->Size() << "\n";
}

vtkMTimeType vtkHighOrderComparison::GetMTime()
{
  return this->Cut->Latest(this->Superclass::GetMTime());
}

void vtkHighOrderComparison::AddSurfaceConnection(vtkAlgorithmOutput* surface)
{
  this->AddInputConnection(1, surface);
}

void vtkHighOrderComparison::RemoveAllSurfaces()
{
  this->SetInputConnection(1, nullptr);
}

void vtkHighOrderComparison::SetCutFunction(vtkImplicitFunction* function)
{
  if (Replace(this->Cut->function, function))
  {
    this->Modified();
  }
}

vtkImplicitFunction* vtkHighOrderComparison::GetCutFunction()
{
  return this->Cut->function;
}

void vtkHighOrderComparison::SetCamera(vtkCamera* camera)
{
  if (Replace(this->Cut->camera, camera))
  {
    this->Modified();
  }
}

vtkCamera* vtkHighOrderComparison::GetCamera()
{
  return this->Cut->camera;
}

void vtkHighOrderComparison::SetContourValue(int i, double value)
{
  if (i < 0)
  {
    vtkErrorMacro("SetContourValue: contours are counted from 0, and this is " << i);
    return;
  }
  if (this->Contours->Set(i, value))
  {
    this->Modified();
  }
}

void vtkHighOrderComparison::SetNumberOfContours(int number)
{
  if (this->Contours->Resize(number))
  {
    this->Modified();
  }
}

void vtkHighOrderComparison::GenerateContourValues(int number, double rangeStart, double rangeEnd)
{
  if (this->Contours->Generate(number, rangeStart, rangeEnd))
  {
    this->Modified();
  }
}

int vtkHighOrderComparison::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
    return 1;
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkHighOrderComparison::RequestUpdateExtent(vtkInformation* /*request*/,
  vtkInformationVector** inputVector, vtkInformationVector* /*outputVector*/)
{
  AskForWhole(inputVector[0]);
  AskForWhole(inputVector[1]);
  return 1;
}

bool vtkHighOrderComparison::Compare(
  vtkDataObject* grid, vtkInformationVector* surfaces, vtkTable* output)
{
  this->Cut->Require(this->Size);
  const auto model = this->Model->Of(grid);
  const FieldChoice chosen{ this->FieldName };
  const Field& field = chosen.In(*model);
  RequireComponent(field, this->Component);
  Scene scene{ &model->GetLocator(), {}, {} };
  scene.layers.push_back(
    { ToSurface(this->Cut->function, { scene.locator->Bounds() }), &field, this->Component });
  const pixelexact::Camera camera = CameraOfFilter(this->Cut->camera, *scene.layers.front().surface,
    scene.locator->Bounds(), this->Size[0], this->Size[1]);
  const int pictures = 1 + surfaces->GetNumberOfInformationObjects();
  int done = 0;
  const pixelexact::Progress progress = [&](double part)
  {
    this->UpdateProgress((done + part) / pictures);
    return this->GetAbortExecute() == 0;
  };
  const std::vector<double> values = this->Contours->All();
  const Picture truth = TracePicture(scene, camera, {}, values, {}, progress);
  if (truth.Size() == 0)
  {
    return false;
  }
  const std::array<double, 2> range = RangeOf(truth);
  std::vector<Row> rows;
  for (++done; done < pictures; ++done)
  {
    const auto linear = ToLinearSurface(vtkPolyData::GetData(surfaces, done - 1), field.name,
      this->Component == -1 ? kMagnitude : this->Component);
    const Picture picture = TracePicture(*linear, camera, values, progress);
    if (picture.Size() == 0)
    {
      return false;
    }
    rows.push_back({ static_cast<std::int64_t>(linear->Count()),
      pixelexact::Compare(truth, picture, { this->Share, range, this->NumberOfColors }) });
  }
  Fill(output, rows, range[1] - range[0]);
  return true;
}

int vtkHighOrderComparison::RequestData(vtkInformation* /*request*/,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* output = vtkTable::GetData(outputVector);
  try
  {
    if (!this->Compare(vtkDataObject::GetData(inputVector[0]), inputVector[1], output))
    {
      output->Initialize();
    }
    return 1;
  }
  catch (const std::exception& error) // memory may run out too
  {
    output->Initialize();
    vtkErrorMacro(<< pixelexact::Worded(error.what()));
    return 0;
  }
}
