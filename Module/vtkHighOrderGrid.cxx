// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderGrid.h"

#include "CompositeParts.h"
#include "Core/Base/Error.h"
#include "Core/Location/Locator.h"
#include "Core/Location/Sample.h"
#include "HighOrderArrays.h"
#include "HighOrderModel.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <sstream>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkHighOrderGrid);

namespace
{
using namespace pixelexact;

void OrderRange(const Expansion& expansion, int range[2])
{
  range[0] = 0;
  range[1] = -1;
  for (int e = 0; e < expansion.Elements(); ++e)
  {
    const auto& order = expansion.SpaceOf(e).order;
    const auto [low, high] = std::ranges::minmax(order);
    range[0] = e == 0 ? low : std::min<int>(range[0], low);
    range[1] = std::max<int>(range[1], high);
  }
}

/// PrintSelf lists so many fields on lines of their own.
constexpr std::size_t kMaxPrintedFields = 4;

/// The highest polynomial order of any direction.
int HighestOrder(const Space& space)
{
  // The third order of a tensor space makes room for the factors of the collapse.
  const auto count = space.form == Form::Tensor ? 2 : 3;
  return *std::max_element(space.order.begin(), space.order.begin() + count);
}

/// "3", or "2 to 4".
std::string OrderText(const std::array<int, 2>& range)
{
  return std::to_string(range[0]) +
    (range[1] > range[0] ? " to " + std::to_string(range[1]) : std::string());
}

void Extend(std::array<int, 2>& range, int order)
{
  range = { std::min(range[0], order), std::max(range[1], order) };
}

constexpr std::array<int, 2> kNoOrders{ std::numeric_limits<int>::max(), -1 };

/// `isPlane`: the solids stand for faces.
std::string ShapeName(Shape shape, bool isPlane, bool several)
{
  std::string name = Name(shape);
  if (isPlane)
  {
    name = shape == Shape::Prism ? "triangle" : "quadrilateral";
  }
  const bool isGreek = name.ends_with("hedron");
  return several ? (isGreek ? name.substr(0, name.size() - 2) + "a" : name + "s") : name;
}

/// "32 hexahedra of order 3, 4 prisms of order 2 to 4". `isPlane`: the solids stand for faces.
std::string CellsText(const Mesh& mesh, bool isPlane)
{
  struct OfShape
  {
    int count = 0;
    std::array<int, 2> orders = kNoOrders;
  };
  std::array<OfShape, kShapeCount> shapes;
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    OfShape& shape = shapes[static_cast<std::size_t>(mesh.ShapeOf(e))];
    ++shape.count;
    Extend(shape.orders, HighestOrder(mesh.map.SpaceOf(e)));
  }
  std::ostringstream text;
  for (std::size_t s = 0; s < shapes.size(); ++s)
  {
    if (shapes[s].count > 0)
    {
      text << (text.tellp() > 0 ? ", " : "") << shapes[s].count << ' '
           << ShapeName(static_cast<Shape>(s), isPlane, shapes[s].count > 1) << " of order "
           << OrderText(shapes[s].orders);
    }
  }
  if (isPlane && mesh.Elements() > 0)
  {
    text << (mesh.isShell ? "; a surface in space" : "; a plane mesh, stored as a slab");
  }
  return text.tellp() > 0 ? text.str() : "0";
}

/// Rounds to 6 digits, which a stream prints, downwards or upwards.
double Rounded(double number, bool upwards)
{
  if (number == 0.0 || !std::isfinite(number))
  {
    return number;
  }
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(number))) - 5.0);
  return (upwards ? std::ceil(number / unit) : std::floor(number / unit)) * unit;
}

void PrintBox(ostream& os, const Vec3& lower, const Vec3& upper)
{
  for (int d = 0; d < 3; ++d)
  {
    os << (d > 0 ? ", " : "") << "xyz"[d] << ' ' << lower[d] << " to " << upper[d];
  }
  os << "\n";
}

/// The same with a box that contains the given one.
void PrintOutwards(ostream& os, Box3 box)
{
  for (int d = 0; d < 3; ++d)
  {
    box.lower[d] = Rounded(box.lower[d], false);
    box.upper[d] = Rounded(box.upper[d], true);
  }
  PrintBox(os, box.lower, box.upper);
}

std::string FieldText(const Field& field)
{
  const int components = field.values.components;
  std::array<int, 2> orders = kNoOrders;
  for (int e = 0; e < field.values.Elements(); ++e)
  {
    Extend(orders, HighestOrder(field.values.SpaceOf(e)));
  }
  return (components == 1 ? "scalar" : std::to_string(components) + " components") +
    (orders[1] < 0 ? std::string() : ", order " + OrderText(orders));
}

/// The first fields with their components and orders, the names of all others on one line.
void PrintFields(ostream& os, vtkIndent indent, const HighOrderModel& model)
{
  const std::span<const Field> fields = model.Fields();
  const auto listed = std::min(fields.size(), kMaxPrintedFields);
  for (const Field& field : fields.first(listed))
  {
    os << indent << "Field " << field.name << ": " << FieldText(field) << "\n";
  }
  const auto others = fields.subspan(listed);
  if (others.empty() && model.Definitions().empty())
  {
    return;
  }
  os << indent << "Other fields:";
  const char* before = " ";
  for (const Field& field : others)
  {
    os << std::exchange(before, ", ") << field.name;
  }
  for (const auto& [name, text] : model.Definitions())
  {
    os << std::exchange(before, ", ") << name << " = " << text;
  }
  os << "\n";
}

int RequireElement(const HighOrderModel& model, vtkIdType element)
{
  if (element < 0 || element >= model.GetMesh().Elements())
  {
    throw InvalidData("there is no element " + std::to_string(element) + "; the grid has " +
      std::to_string(model.GetMesh().Elements()) + ", numbered from 0.");
  }
  return static_cast<int>(element);
}
} // namespace

vtkHighOrderGrid::vtkHighOrderGrid() = default;
vtkHighOrderGrid::~vtkHighOrderGrid() = default;

void vtkHighOrderGrid::PrintSelf(ostream& os, vtkIndent indent)
{
  try
  {
    const auto model = this->GetModel();
    const Mesh& mesh = model->GetMesh();
    const bool isPlane = this->GetFieldData()->HasArray(kSlab) != 0;
    os << indent << "Cells: " << CellsText(mesh, isPlane) << "\n";
    const double* points = this->GetBounds();
    PrintBox(os << indent << "Points: ", { points[0], points[2], points[4] },
      { points[1], points[3], points[5] });
    if (mesh.Elements() > 0)
    {
      PrintOutwards(os << indent << "Proven box: ", model->GetLocator().Bounds());
    }
    if (this->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()))
    {
      os << indent << "Time: " << this->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP())
         << "\n";
    }
    PrintFields(os, indent, *model);
  }
  catch (const Error& error)
  {
    os << indent << "Cells: " << this->GetNumberOfCells() << "\n"
       << indent << "Coefficients: " << error.what() << "\n";
  }
}

std::shared_ptr<HighOrderModel> vtkHighOrderGrid::GetModel()
{
  if (!this->Model || !this->Model->IsCurrent(this))
  {
    // The old model stays alive until the new one exists, which may share its locator, but not
    // after a failure.
    const auto stale = std::move(this->Model);
    this->Model = HighOrderModel::From(this);
  }
  return this->Model;
}

bool vtkHighOrderGrid::IsHighOrder(vtkUnstructuredGrid* grid)
{
  return HasHighOrderArrays(grid);
}

bool vtkHighOrderGrid::IsSurfaceInSpace(vtkDataObject* data)
{
  if (auto* const composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    try
    {
      const auto parts = PartsOf(composite);
      return !parts.empty() && IsShell(parts.front().grid);
    }
    catch (const Error&)
    {
      return false; // of what is no grid
    }
  }
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(data);
  return grid != nullptr && IsShell(grid);
}

std::string vtkHighOrderGrid::CheckCoefficients(vtkUnstructuredGrid* grid)
{
  if (!grid)
  {
    return "there is no grid.";
  }
  try
  {
    HighOrderModel::From(grid);
    return {};
  }
  catch (const Error& error)
  {
    return error.what();
  }
}

int vtkHighOrderGrid::GetNumberOfHighOrderFields()
{
  try
  {
    return static_cast<int>(this->GetModel()->Fields().size());
  }
  catch (const Error& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
}

std::string vtkHighOrderGrid::GetHighOrderFieldName(int index)
{
  try
  {
    const auto model = this->GetModel();
    const auto fields = model->Fields();
    if (index < 0 || index >= static_cast<int>(fields.size()))
    {
      throw InvalidData("there is no high-order field number " + std::to_string(index) +
        "; the grid has " + std::to_string(fields.size()) + ".");
    }
    return fields[index].name;
  }
  catch (const Error& error)
  {
    vtkErrorMacro(<< error.what());
    return {};
  }
}

int vtkHighOrderGrid::GetHighOrderFieldComponents(const std::string& name)
{
  try
  {
    return this->GetModel()->GetField(name).values.components;
  }
  catch (const Error& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
}

void vtkHighOrderGrid::GetGeometryOrderRange(int range[2])
{
  range[0] = 0;
  range[1] = -1;
  try
  {
    OrderRange(this->GetModel()->GetMesh().map, range);
  }
  catch (const Error& error)
  {
    vtkErrorMacro(<< error.what());
  }
}

void vtkHighOrderGrid::GetFieldOrderRange(const std::string& name, int range[2])
{
  range[0] = 0;
  range[1] = -1;
  try
  {
    OrderRange(this->GetModel()->GetField(name).values, range);
  }
  catch (const Error& error)
  {
    vtkErrorMacro(<< error.what());
  }
}

bool vtkHighOrderGrid::MapForward(vtkIdType element, const double xi[3], double x[3])
{
  try
  {
    const auto model = this->GetModel();
    const Vec3 at(xi[0], xi[1], xi[2]);
    Vec3 world;
    pixelexact::MapForward(
      model->GetMesh(), RequireElement(*model, element), { &at, 1 }, { &world, 1 });
    for (int d = 0; d < 3; ++d)
    {
      x[d] = world[d];
    }
    return true;
  }
  catch (const Error& error)
  {
    vtkErrorMacro(<< error.what());
    return false;
  }
}

bool vtkHighOrderGrid::EvaluateField(
  const std::string& name, vtkIdType element, const double xi[3], vtkDoubleArray* values)
{
  try
  {
    const auto model = this->GetModel();
    const Field& field = model->GetField(name);
    const int e = RequireElement(*model, element);
    values->SetNumberOfComponents(field.values.components);
    values->SetNumberOfTuples(1);
    const Vec3 at(xi[0], xi[1], xi[2]);
    EvaluateAt(model->GetMesh(), field, e, { &at, 1 },
      { values->GetPointer(0), static_cast<std::size_t>(field.values.components) }, {});
    values->Modified();
    return true;
  }
  catch (const Error& error)
  {
    vtkErrorMacro(<< error.what());
    return false;
  }
}
