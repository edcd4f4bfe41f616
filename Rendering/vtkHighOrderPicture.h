// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderPicture
 * @brief   the picture of a vtkHighOrderMapper as an image, without a window or OpenGL
 *
 * An image source: the complete picture of the cut of an actor with a vtkHighOrderMapper, through a
 * camera, without other actors. It needs no display. Pixels equal those of a window of the same
 * size, except for the light: here it is one headlight, as a renderer's default. Ignores the
 * camera's clipping range.
 *
 * The output's scalars are `Color` (RGBA, straight alpha, transparent where there is no cut), lower
 * left pixel first, which image writers accept directly. Further arrays are `Verdict` (0 nothing, 1
 * exact, 2 unknown), `Position`, with contours `Contour`, and with AllBuffers all arrays of
 * vtkHighOrderMapper::GetBuffers. After an error the image is empty. Settings without effect give a
 * warning.
 *
 * Keeps the last picture: a changed lookup table recolours it and traces nothing.
 */

#ifndef vtkHighOrderPicture_h
#define vtkHighOrderPicture_h

#include "PixelExactRenderingModule.h"
#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h" // for actor and camera

#include <memory> // for the implementation

class vtkActor;
class vtkCamera;

class PIXELEXACTRENDERING_EXPORT vtkHighOrderPicture : public vtkImageAlgorithm
{
public:
  static vtkHighOrderPicture* New();
  vtkTypeMacro(vtkHighOrderPicture, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * An actor whose mapper is a vtkHighOrderMapper; its matrix, opacity and property apply as in
   * windows. Required.
   */
  void SetActor(vtkActor* actor);
  vtkActor* GetActor();
  ///@}

  ///@{
  /**
   * The camera; required. ViewAlong places it.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  ///@}

  ///@{
  /**
   * Places the camera, which is created if there is none, so that the cut fills most of a picture
   * of Size, as the command-line program's --view does. `towardsViewer` points from the cut to the
   * camera and need not have unit length. The cut is found in small pictures, which are traced
   * immediately; without a visible cut, the camera shows the whole actor. Without `viewUp`, z
   * points up, or y if the camera looks along z.
   */
  void ViewAlong(const double towardsViewer[3], const double viewUp[3]);
  void ViewAlong(const double towardsViewer[3]);
  ///@}

  ///@{
  /**
   * Pixels across and up, at least one each. The default is 1000 each.
   */
  vtkSetVector2Macro(Size, int);
  vtkGetVector2Macro(Size, int);
  ///@}

  ///@{
  /**
   * Above 1: of each block of Stride x Stride pixels the middle one is traced, bit for bit as in
   * the whole picture, and all pixels of the block show it. The default is 1. Contours and edges
   * need each pixel and are refused.
   */
  vtkSetClampMacro(Stride, int, 1, 64);
  vtkGetMacro(Stride, int);
  ///@}

  ///@{
  /**
   * Adds all arrays of the pixels to the output. The default is off.
   */
  vtkSetMacro(AllBuffers, bool);
  vtkGetMacro(AllBuffers, bool);
  vtkBooleanMacro(AllBuffers, bool);
  ///@}

  /**
   * Count of traces.
   */
  vtkIdType GetNumberOfTraces();

  /**
   * Includes the times of actor, mapper, input and camera.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkHighOrderPicture();
  ~vtkHighOrderPicture() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHighOrderPicture(const vtkHighOrderPicture&) = delete;
  void operator=(const vtkHighOrderPicture&) = delete;

  vtkSmartPointer<vtkActor> Actor;
  vtkSmartPointer<vtkCamera> Camera;
  int Size[2] = { 1000, 1000 };
  int Stride = 1;
  bool AllBuffers = false;

  struct Internals;
  std::unique_ptr<Internals> Data;
};

#endif
