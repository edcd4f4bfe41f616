// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/ImageSize.h"
#include "Drawing/Image.h"

#include <vtkCallbackCommand.h>
#include <vtkNew.h>

#include <array>
#include <utility>

class vtkActor2D;
class vtkImageData;
class vtkImageMapper;
class vtkRenderWindow;
class vtkRenderer;
class vtkTextActor;

namespace pixelexact
{
/// Calls a function at an event. The function object lives as long as the observed object.
template <class Function>
void Observe(vtkObject* object, unsigned long event, Function function)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(new Function(std::move(function)));
  command->SetClientDataDeleteCallback([](void* client) { delete static_cast<Function*>(client); });
  command->SetCallback(
    [](vtkObject*, unsigned long, void* client, void*) { (*static_cast<Function*>(client))(); });
  object->AddObserver(event, command);
}

/// A picture of pixels in a window.
class ShownImage
{
public:
  ShownImage();
  ~ShownImage();
  ShownImage(const ShownImage&) = delete;
  ShownImage& operator=(const ShownImage&) = delete;

  [[nodiscard]] vtkActor2D& Actor() const { return *Shown; }
  /// `left`: its place in the window, in pixels.
  void Set(const Image& image, int left);

private:
  vtkNew<vtkImageData> Data;
  vtkNew<vtkImageMapper> Mapper;
  vtkNew<vtkActor2D> Shown;
};

/// The parts of a window from the left: the figure, whose picture VTK draws, and the panel.
class ViewLayout
{
public:
  ViewLayout();
  ~ViewLayout();
  ViewLayout(const ViewLayout&) = delete;
  ViewLayout& operator=(const ViewLayout&) = delete;

  [[nodiscard]] vtkRenderWindow& Window() const { return *Shown; }
  /// The renderer of the picture in the figure.
  [[nodiscard]] vtkRenderer& Picture() const { return *Inner; }
  /// Adds a renderer over the picture.
  void AddOver(vtkRenderer& renderer);

  /// Places a picture in the window; `corner`: the lower left one, in pixels.
  void PlacePicture(const std::array<int, 2>& corner, int width, int height);
  /// The figure around the picture, from the window's lower left corner.
  void SetFigure(const Image& image) { Figure.Set(image, 0); }
  /// `left`: the image's place in the window, in pixels.
  void SetPanel(const Image& image, int left) { Panel.Set(image, left); }
  /// Shows or hides the keys, over the picture's upper left corner.
  void TurnHelp();

  [[nodiscard]] std::array<int, 2> Size() const;
  /// The size of a figure without --size: that of render, or less on a small screen.
  [[nodiscard]] static ImageSize LargestFigure();
  /// Whether a position of the window, in pixels from below, is in the picture.
  [[nodiscard]] bool IsInPicture(const std::array<int, 2>& at) const;

private:
  vtkNew<vtkRenderWindow> Shown;
  vtkNew<vtkRenderer> Back; ///< figure and panel
  vtkNew<vtkRenderer> Inner;
  vtkRenderer* Over = nullptr;
  vtkNew<vtkTextActor> Help;
  ShownImage Figure;
  ShownImage Panel;
};
} // namespace pixelexact
