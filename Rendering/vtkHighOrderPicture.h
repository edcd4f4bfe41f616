// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderPicture
 * @brief   what a vtkHighOrderMapper shows, as an image, without a window or OpenGL
 *
 * A source of images: the cut that an actor with a vtkHighOrderMapper shows, seen through a camera,
 * alone and complete. It needs no display. Pixels are those of a window of the same size, up to the
 * light: here it is one headlight, as a renderer makes it where there is none. The camera's
 * clipping range is not looked at, and neither are other actors.
 *
 * The output's scalars are `Color` (RGBA, straight alpha, transparent where there is no cut), lower
 * left pixel first, so that writers of images take it as it is. Beside it are `Verdict` (0 nothing,
 * 1 exact, 2 unknown), `Position`, with contours `Contour`, and with AllBuffers all arrays of
 * vtkHighOrderMapper::GetBuffers. Where something is wrong there is an error and an empty image;
 * what is set and has no effect is warned of.
 *
 * The last picture is kept: another lookup table colours it anew, and traces nothing.
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
   * What is shown: an actor whose mapper is a vtkHighOrderMapper; its matrix, opacity and property
   * count as in windows. There must be one.
   */
  void SetActor(vtkActor* actor);
  vtkActor* GetActor();
  ///@}

  ///@{
  /**
   * Where from; there must be one. ViewAlong places it.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  ///@}

  ///@{
  /**
   * Places the camera, which is made where there is none, so that what is cut fills most of a
   * picture of Size, as the command-line program's --view does: `towardsViewer` points from it to
   * the camera and need not be of unit length. It is looked for in small pictures, which are traced
   * at once; where there is none, all of the actor is seen. Without `viewUp` z points up, or y
   * where one looks along z.
   */
  void ViewAlong(const double towardsViewer[3], const double viewUp[3]);
  void ViewAlong(const double towardsViewer[3]);
  ///@}

  ///@{
  /**
   * Pixels across and up, at least one each. Default 1000 each.
   */
  vtkSetVector2Macro(Size, int);
  vtkGetVector2Macro(Size, int);
  ///@}

  ///@{
  /**
   * Above 1: of each Stride x Stride pixels the middle one is traced, bit for bit as in the whole
   * picture, and all of them show it. 1 by default. Refused with what is of each pixel: contours
   * and edges.
   */
  vtkSetClampMacro(Stride, int, 1, 64);
  vtkGetMacro(Stride, int);
  ///@}

  ///@{
  /**
   * Whether the output has all that is known of the pixels. Off by default.
   */
  vtkSetMacro(AllBuffers, bool);
  vtkGetMacro(AllBuffers, bool);
  vtkBooleanMacro(AllBuffers, bool);
  ///@}

  /**
   * How often rays were traced.
   */
  vtkIdType GetNumberOfTraces();

  /**
   * Includes that of actor, mapper, input and camera.
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
