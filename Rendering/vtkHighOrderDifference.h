// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderDifference
 * @brief   how two solutions differ on a cut-surface, pixel by pixel
 *
 * Port 0 takes the first grid, port 1 the second one, of any mesh, order, solver or time. Each has
 * high-order coefficients, or is composite data of such grids. The camera's rays are cast at the
 * cut-surface. At each pixel's nearest point in either mesh, both fields are evaluated exactly,
 * each by location in its own mesh.
 *
 * The output is an image with a point for each pixel, lower left first, and these point arrays:
 * Value, the first field minus the second one, NaN where only one has a value; Value_lower and
 * Value_upper, proven to enclose it; First and Second; Side: 0 nothing, 1 both have a value, 2
 * unknown, 3 only the first, 4 only the second; Seen, the grid that Element, Xi, Position and Depth
 * belong to: 1, 2, or 0 for none; Verdict: 1 where both have a value, 2 where that is unknown.
 *
 * FieldData has numbers over the pixels in which both have a finite value: Largest, of absolute
 * values; LargestAt, its point; Mean; RootMeanSquare; FirstRootMeanSquare, of the first field's
 * values. With bounds: LargestBound, the largest error of a difference (over pixels with a finite
 * bound); Unbounded, pixels without one; LargestTrue, two numbers that are proven to enclose the
 * largest true difference. Counts of pixels: Both, OnlyFirst, OnlySecond, Unknown, NotFinite.
 */

#ifndef vtkHighOrderDifference_h
#define vtkHighOrderDifference_h

#include "PixelExactRenderingModule.h"
#include "vtkImageAlgorithm.h"

#include <memory> // for the models
#include <string> // for the fields' names

class vtkCamera;
class vtkImplicitFunction;

namespace pixelexact
{
class GridModel;
struct SeenCut;
} // namespace pixelexact

class PIXELEXACTRENDERING_EXPORT vtkHighOrderDifference : public vtkImageAlgorithm
{
public:
  static vtkHighOrderDifference* New();
  vtkTypeMacro(vtkHighOrderDifference, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Includes the times of cut function and camera.
  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * The function whose zeros are the cut-surface; required.
   */
  void SetCutFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetCutFunction();
  ///@}

  ///@{
  /**
   * The camera of the picture. Null, the default: a parallel view of the whole first grid, along
   * the normal of a plane, or from (1, 1, 1) for other surfaces.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  ///@}

  ///@{
  /**
   * Pixels across and up. The default is 1000 each.
   */
  vtkSetVector2Macro(Size, int);
  vtkGetVector2Macro(Size, int);
  ///@}

  ///@{
  /**
   * The field of the first grid; empty, the default: its first one. A name that the grid lacks is
   * an error.
   */
  vtkSetMacro(FieldName, std::string);
  vtkGetMacro(FieldName, std::string);
  ///@}

  ///@{
  /**
   * The field of the second grid, with the same number of components; empty, the default: the same
   * name.
   */
  vtkSetMacro(SecondFieldName, std::string);
  vtkGetMacro(SecondFieldName, std::string);
  ///@}

  ///@{
  /**
   * The component of the difference, from 0, or -1, the default: the difference of scalars, the
   * magnitude of a vector's difference.
   */
  vtkSetMacro(Component, int);
  vtkGetMacro(Component, int);
  ///@}

  ///@{
  /**
   * Proves bounds, which takes about ten times as long as values. The default is on.
   */
  vtkSetMacro(Bounds, bool);
  vtkGetMacro(Bounds, bool);
  vtkBooleanMacro(Bounds, bool);
  ///@}

protected:
  vtkHighOrderDifference();
  ~vtkHighOrderDifference() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHighOrderDifference(const vtkHighOrderDifference&) = delete;
  void operator=(const vtkHighOrderDifference&) = delete;

  /// Throws Error. Returns false if it was aborted.
  bool Compare(vtkDataObject* first, vtkDataObject* second, vtkImageData* output);

  std::unique_ptr<pixelexact::SeenCut> Cut;
  int Size[2] = { 1000, 1000 };
  std::string FieldName;
  std::string SecondFieldName;
  int Component = -1;
  bool Bounds = true;
  std::unique_ptr<pixelexact::GridModel> FirstModel;
  std::unique_ptr<pixelexact::GridModel> SecondModel;
};

#endif
