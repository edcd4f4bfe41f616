// SPDX-License-Identifier: BSD-3-Clause
#include "View/DraggedShape.h"

#include "Base/Numbers.h"
#include "Trace/Surfaces/ConvexBody.h"
#include "Trace/Surfaces/Plane.h"
#include "Trace/Surfaces/Quadric.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vtkBoundingBox.h>
#include <vtkBoxRepresentation.h>
#include <vtkBoxWidget2.h>
#include <vtkImplicitCylinderRepresentation.h>
#include <vtkImplicitCylinderWidget.h>
#include <vtkImplicitPlaneRepresentation.h>
#include <vtkImplicitPlaneWidget2.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkSphereRepresentation.h>
#include <vtkSphereWidget2.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Opacity of widgets. They must be drawn to be picked, but the cut itself is visible.
constexpr double kUnseen = 0.01;

/// Replaces roundings that dragging leaves by 0; `size` is the magnitude of the numbers.
std::vector<double> Clean(std::vector<double> numbers, double size)
{
  std::ranges::transform(
    numbers, numbers.begin(), [size](double number) { return WithoutRoundings(number, size); });
  return numbers;
}

/// The option with its numbers: "--sphere=0,0,0.5,1".
std::string Worded(
  const char* option, std::vector<double> numbers, const std::vector<double>& more = {})
{
  numbers.insert(numbers.end(), more.begin(), more.end());
  return fmt::format("{}={}", option, fmt::join(numbers, ","));
}

class DraggedPlane final : public DraggedShape
{
public:
  explicit DraggedPlane(const Plane& plane)
  {
    const Vec3 normal = plane.Normal({});
    Cut->SetOrigin(plane.Point().x, plane.Point().y, plane.Point().z);
    Cut->SetNormal(normal.x, normal.y, normal.z);
    Control->SetRepresentation(Shape);
  }
  void Place(const double* bounds) override
  {
    Shape->SetPlaceFactor(1.0);
    std::array<double, 6> box{};
    std::copy_n(bounds, 6, box.begin());
    Shape->PlaceWidget(box.data());
    // Puts the widget's arrow near the middle of the mesh.
    std::array<double, 3> middle{};
    vtkBoundingBox(bounds).GetCenter(middle.data());
    Cut->ProjectPoint(middle.data(), middle.data());
    Shape->SetOrigin(middle.data());
    Shape->SetNormal(Cut->GetNormal());
    Shape->OutlineTranslationOff();
    Shape->ScaleEnabledOff();
    Shape->TubingOff();
    Shape->DrawPlaneOn();
    Shape->GetPlaneProperty()->SetOpacity(kUnseen);
    Shape->GetSelectedPlaneProperty()->SetOpacity(kUnseen);
    Placed = true;
    Size = vtkBoundingBox(bounds).GetDiagonalLength();
  }
  [[nodiscard]] vtkAbstractWidget& Widget() override { return *Control; }
  [[nodiscard]] std::shared_ptr<const Surface> Now() const override
  {
    const auto [origin, normal] = OriginAndNormal();
    return std::make_shared<Plane>(origin, normal);
  }
  [[nodiscard]] std::string Word() const override
  {
    const auto [o, n] = OriginAndNormal();
    return Worded("--plane", Clean({ o.x, o.y, o.z }, Size), Clean({ n.x, n.y, n.z }, 1.0));
  }

private:
  [[nodiscard]] std::array<Vec3, 2> OriginAndNormal() const
  {
    if (Placed)
    {
      Shape->GetPlane(Cut);
    }
    const double* o = Cut->GetOrigin();
    const double* n = Cut->GetNormal();
    return { Vec3(o[0], o[1], o[2]), Vec3(n[0], n[1], n[2]) };
  }
  bool Placed = false;
  double Size = 0.0; ///< of the mesh
  vtkNew<vtkPlane> Cut;
  vtkNew<vtkImplicitPlaneRepresentation> Shape;
  vtkNew<vtkImplicitPlaneWidget2> Control;
};

/// The left button moves the sphere, the right one changes its radius.
class DraggedSphere final : public DraggedShape
{
public:
  explicit DraggedSphere(const std::vector<double>& numbers)
    : Given(numbers)
  {
    Control->SetRepresentation(Shape);
  }
  void Place(const double* /*bounds*/) override
  {
    std::array<double, 6> box{};
    for (std::size_t d = 0; d < 3; ++d)
    {
      box[2 * d] = Given[d] - Given[3];
      box[2 * d + 1] = Given[d] + Given[3];
    }
    Shape->SetPlaceFactor(1.0);
    Shape->PlaceWidget(box.data());
    Shape->SetCenter(Given.data());
    Shape->SetRadius(Given[3]);
    Shape->HandleVisibilityOff();
    Shape->HandleTextOff();
    Shape->RadialLineOff();
    Shape->SetRepresentationToSurface();
    Shape->GetSphereProperty()->SetOpacity(kUnseen);
    Shape->GetSelectedSphereProperty()->SetOpacity(kUnseen);
  }
  [[nodiscard]] vtkAbstractWidget& Widget() override { return *Control; }
  [[nodiscard]] std::shared_ptr<const Surface> Now() const override
  {
    const double* c = Shape->GetCenter();
    return std::make_shared<Quadric>(MakeSphere(Vec3(c[0], c[1], c[2]), Shape->GetRadius()));
  }
  [[nodiscard]] std::string Word() const override
  {
    const double* c = Shape->GetCenter();
    const double radius = Shape->GetRadius();
    return Worded("--sphere", Clean({ c[0], c[1], c[2] }, radius), { radius });
  }

private:
  std::vector<double> Given;
  vtkNew<vtkSphereRepresentation> Shape;
  vtkNew<vtkSphereWidget2> Control;
};

/// The arrow turns its axis, the wall changes its radius, the middle moves it.
class DraggedCylinder final : public DraggedShape
{
public:
  explicit DraggedCylinder(const std::vector<double>& numbers)
    : Given(numbers)
  {
    Control->SetRepresentation(Shape);
  }
  void Place(const double* bounds) override
  {
    std::array<double, 6> box{};
    std::copy_n(bounds, 6, box.begin());
    Size = vtkBoundingBox(bounds).GetDiagonalLength();
    Shape->SetPlaceFactor(1.0);
    Shape->SetMinRadius(0.001);
    Shape->SetMaxRadius(10.0);
    Shape->SetOutsideBounds(1);
    Shape->SetConstrainToWidgetBounds(0);
    Shape->PlaceWidget(box.data());
    Shape->SetCenter(Given.data());
    Shape->SetAxis(&Given[3]);
    Shape->SetRadius(Given[6]);
    Shape->OutlineTranslationOff();
    Shape->ScaleEnabledOff();
    Shape->TubingOff();
    Shape->DrawCylinderOn();
    Shape->GetCylinderProperty()->SetOpacity(kUnseen);
    Shape->GetSelectedCylinderProperty()->SetOpacity(kUnseen);
  }
  [[nodiscard]] vtkAbstractWidget& Widget() override { return *Control; }
  [[nodiscard]] std::shared_ptr<const Surface> Now() const override
  {
    const std::vector<double> n = Numbers();
    return std::make_shared<Quadric>(
      MakeCylinder(Vec3(n[0], n[1], n[2]), Vec3(n[3], n[4], n[5]), n[6]));
  }
  [[nodiscard]] std::string Word() const override
  {
    const std::vector<double> n = Numbers();
    std::vector<double> more = Clean({ n[3], n[4], n[5] }, 1.0);
    more.push_back(n[6]);
    return Worded("--cylinder", Clean({ n[0], n[1], n[2] }, Size), more);
  }

private:
  [[nodiscard]] std::vector<double> Numbers() const
  {
    const double* c = Shape->GetCenter();
    const double* a = Shape->GetAxis();
    return { c[0], c[1], c[2], a[0], a[1], a[2], Shape->GetRadius() };
  }
  std::vector<double> Given;
  double Size = 0.0; ///< of the mesh
  vtkNew<vtkImplicitCylinderRepresentation> Shape;
  vtkNew<vtkImplicitCylinderWidget> Control;
};

/// Handles on the faces move these; the middle one moves the box.
class DraggedBox final : public DraggedShape
{
public:
  explicit DraggedBox(const std::vector<double>& numbers)
    : Given(numbers)
  {
    Control->SetRepresentation(Shape);
  }
  void Place(const double* /*bounds*/) override
  {
    std::array<double, 6> box{};
    for (std::size_t d = 0; d < 3; ++d)
    {
      box[2 * d] = std::min(Given[d], Given[d + 3]);
      box[2 * d + 1] = std::max(Given[d], Given[d + 3]);
    }
    Shape->SetPlaceFactor(1.0);
    Shape->PlaceWidget(box.data());
    // --box is aligned with the axes.
    Control->RotationEnabledOff();
    Shape->GetOutlineProperty()->SetColor(0.0, 0.0, 0.0);
  }
  [[nodiscard]] vtkAbstractWidget& Widget() override { return *Control; }
  [[nodiscard]] std::shared_ptr<const Surface> Now() const override
  {
    const std::vector<double> n = Numbers();
    return std::make_shared<ConvexBody>(MakeBox(Vec3(n[0], n[1], n[2]), Vec3(n[3], n[4], n[5])));
  }
  [[nodiscard]] std::string Word() const override
  {
    const std::vector<double> n = Numbers();
    const double size =
      std::fabs(*std::ranges::max_element(n, {}, [](double x) { return std::fabs(x); }));
    return Worded("--box", Clean(n, size));
  }

private:
  [[nodiscard]] std::vector<double> Numbers() const
  {
    // Uses the box itself, because GetBounds includes the handles.
    vtkNew<vtkPolyData> faces;
    Shape->GetPolyData(faces);
    vtkBoundingBox box;
    for (vtkIdType k = 0; k < 8; ++k)
    {
      box.AddPoint(faces->GetPoint(k));
    }
    const double* low = box.GetMinPoint();
    const double* high = box.GetMaxPoint();
    return { low[0], low[1], low[2], high[0], high[1], high[2] };
  }
  std::vector<double> Given;
  vtkNew<vtkBoxRepresentation> Shape;
  vtkNew<vtkBoxWidget2> Control;
};
} // namespace

std::unique_ptr<DraggedShape> MakeDragged(
  const Surface& surface, const SurfaceOptions::Described& given)
{
  if (const auto* plane = dynamic_cast<const Plane*>(&surface))
  {
    return std::make_unique<DraggedPlane>(*plane);
  }
  if (given.option == "--sphere")
  {
    return std::make_unique<DraggedSphere>(given.numbers);
  }
  if (given.option == "--cylinder")
  {
    return std::make_unique<DraggedCylinder>(given.numbers);
  }
  if (given.option == "--box")
  {
    return std::make_unique<DraggedBox>(given.numbers);
  }
  return nullptr;
}
} // namespace pixelexact
