// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"
#include "Trace/Camera.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkFloatArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <string>

namespace pixelexact::testing
{
using Rgb = std::array<int, 3>;

/// An off-screen window with one renderer on a dark blue background.
class Window
{
public:
  static constexpr int kWidth = 320;
  static constexpr int kHeight = 240;
  static constexpr std::array<int, 4> kWhole{ 0, 0, kWidth, kHeight }; ///< as a viewport
  static constexpr Rgb kBackground{ 0, 0, 51 };

  explicit Window(int multiSamples = 0)
  {
    RenderWindow->SetOffScreenRendering(1);
    RenderWindow->SetMultiSamples(multiSamples);
    RenderWindow->SetSize(kWidth, kHeight);
    RenderWindow->AddRenderer(Renderer);
    Renderer->SetBackground(0.0, 0.0, 0.2);
  }

  /// Renders, and writes the picture to the folder of temporary files for inspection.
  void Render()
  {
    RenderWindow->Render();
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(test->test_suite_name()) + "." + test->name();
    name += "-" + std::to_string(Pictures[name]++);
    std::replace(name.begin(), name.end(), '/', '-');
    const std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) / "pixelexact-pictures";
    std::filesystem::create_directories(folder);
    vtkNew<vtkWindowToImageFilter> image;
    image->SetInput(RenderWindow);
    image->ReadFrontBufferOff();
    image->ShouldRerenderOff();
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(image->GetOutputPort());
    writer->SetFileName((folder / (name + ".png")).c_str());
    writer->Write();
    Colors->Reset();
    Depths->Reset();
  }

  /// The colour of a pixel of the window, as the last Render() left it.
  Rgb Color(int x, int y)
  {
    if (Colors->GetNumberOfTuples() == 0)
    {
      RenderWindow->GetPixelData(0, 0, kWidth - 1, kHeight - 1, 0, Colors);
    }
    const unsigned char* pixel = Colors->GetPointer(3 * (y * kWidth + x));
    return { pixel[0], pixel[1], pixel[2] };
  }

  double Depth(int x, int y)
  {
    if (Depths->GetNumberOfTuples() == 0)
    {
      RenderWindow->GetZbufferData(0, 0, kWidth - 1, kHeight - 1, Depths);
    }
    return Depths->GetValue(y * kWidth + x);
  }

  vtkNew<vtkRenderWindow> RenderWindow;
  vtkNew<vtkRenderer> Renderer;

private:
  vtkNew<vtkUnsignedCharArray> Colors;
  vtkNew<vtkFloatArray> Depths;
  static inline std::map<std::string, int> Pictures; ///< written, by test
};

/// The rays of image positions by VTK's matrices, as in OpenGL's geometry.
class VtkRays
{
public:
  VtkRays(vtkCamera* camera, int width, int height)
    : Width(width)
    , Height(height)
  {
    vtkMatrix4x4::Invert(
      camera->GetCompositeProjectionTransformMatrix(static_cast<double>(width) / height, -1.0, 1.0),
      Inverse);
  }

  [[nodiscard]] Ray At(double px, double py) const
  {
    const Vec3 near = Unproject(px, py, -1.0);
    return { near, glm::normalize(Unproject(px, py, 1.0) - near) };
  }

private:
  [[nodiscard]] Vec3 Unproject(double px, double py, double z) const
  {
    double point[4] = { 2.0 * px / Width - 1.0, 2.0 * py / Height - 1.0, z, 1.0 };
    Inverse->MultiplyPoint(point, point);
    return Vec3(point[0], point[1], point[2]) / point[3];
  }

  int Width;
  int Height;
  vtkNew<vtkMatrix4x4> Inverse;
};

/// The window depth of a point by VTK's matrices.
inline double VtkDepth(vtkCamera* camera, const Vec3& x, int width, int height)
{
  const double point[4] = { x.x, x.y, x.z, 1.0 };
  double clip[4];
  camera->GetCompositeProjectionTransformMatrix(static_cast<double>(width) / height, -1.0, 1.0)
    ->MultiplyPoint(point, clip);
  return 0.5 + 0.5 * clip[2] / clip[3];
}

/// Collects the errors of an object; without it they are printed and fail nothing.
class ErrorObserver : public vtkCommand
{
public:
  static ErrorObserver* New() { return new ErrorObserver; }
  void Execute(vtkObject*, unsigned long, void* data) override
  {
    ++Count;
    Text += static_cast<const char*>(data);
  }

  int Count = 0;
  std::string Text;
};

inline bool Contains(const std::string& text, const char* part)
{
  return text.find(part) != std::string::npos;
}
} // namespace pixelexact::testing
