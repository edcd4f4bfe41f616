// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderComparison
 * @brief   how far linear cut-surfaces are from the exact picture, pixel by pixel
 *
 * Port 0 takes a grid that carries high-order coefficients, or composite data of such grids; port 1
 * any number of polygonal surfaces with a point array of the field's name, made by whatever
 * pipeline: vtkHighOrderLinearCut, vtkCutter behind vtkHighOrderSubdivide or
 * vtkHighOrderLinearResample, somebody else's. The camera's rays are cast at the exact cut-surface
 * and at each linear one, whose corners' values are interpolated linearly, as a rasteriser does.
 *
 * The output is a table with a row for each surface. Counts are pixels:
 * Surface, its number; Triangles; Shown, to which the exact picture gives a value; Missing, of
 * these, without one in the linear picture; Invented, with one where there is nothing; LargestError
 * and MeanError, of those with a value in both, and ErrorAtShare, which so many of the shown do not
 * exceed (a missing value counts as infinite), over the exact picture's range; WrongColors, whose
 * colour is another one; and, where there are contour values, ContourPixels, ContourMissed,
 * ContourDisplaced, ContourInvented, ContourFarthest (in pixels; see
 * Trace/Compare/PictureErrors.h).
 */

#ifndef vtkHighOrderComparison_h
#define vtkHighOrderComparison_h

#include "PixelExactRenderingModule.h"
#include "vtkTableAlgorithm.h"

#include <memory> // for the model
#include <string> // for the field's name

class vtkCamera;
class vtkImplicitFunction;

namespace pixelexact
{
class ContourList;
class GridModel;
struct SeenCut;
} // namespace pixelexact

class PIXELEXACTRENDERING_EXPORT vtkHighOrderComparison : public vtkTableAlgorithm
{
public:
  static vtkHighOrderComparison* New();
  vtkTypeMacro(vtkHighOrderComparison, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Includes the cut function's and the camera's.
  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * The linear surfaces' port.
   */
  void AddSurfaceConnection(vtkAlgorithmOutput* surface);
  void RemoveAllSurfaces();
  ///@}

  ///@{
  /**
   * The function whose zeros are the cut-surface; there must be one.
   */
  void SetCutFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetCutFunction();
  ///@}

  ///@{
  /**
   * Where from the surfaces are seen. Null, the default: all of the grid, in parallel, along
   * the normal of a plane, and of other surfaces from (1, 1, 1).
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  ///@}

  ///@{
  /**
   * Pixels across and up. Default 1000 each.
   */
  vtkSetVector2Macro(Size, int);
  vtkGetVector2Macro(Size, int);
  ///@}

  ///@{
  /**
   * The field; empty, the default: the first one. A name that the grid lacks is an error.
   */
  vtkSetMacro(FieldName, std::string);
  vtkGetMacro(FieldName, std::string);
  ///@}

  ///@{
  /**
   * Which component of a field, from 0, or -1, the default: the value of a scalar, the magnitude
   * of a vector.
   */
  vtkSetMacro(Component, int);
  vtkGetMacro(Component, int);
  ///@}

  ///@{
  /**
   * Colours of the map, which spans the values of the exact picture. Default 256.
   */
  vtkSetClampMacro(NumberOfColors, int, 1, 1000000);
  vtkGetMacro(NumberOfColors, int);
  ///@}

  ///@{
  /**
   * Which part of the shown pixels ErrorAtShare is about. Default 0.99.
   */
  vtkSetClampMacro(Share, double, 0.001, 1.0);
  vtkGetMacro(Share, double);
  ///@}

  ///@{
  /**
   * Values of contours; none by default. They must be finite.
   */
  void SetContourValue(int i, double value);
  void SetNumberOfContours(int number);
  void GenerateContourValues(int number, double rangeStart, double rangeEnd);
  ///@}

protected:
  vtkHighOrderComparison();
  ~vtkHighOrderComparison() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHighOrderComparison(const vtkHighOrderComparison&) = delete;
  void operator=(const vtkHighOrderComparison&) = delete;

  /// Throws Error. False where it was aborted.
  bool Compare(vtkDataObject* grid, vtkInformationVector* surfaces, vtkTable* output);

  std::unique_ptr<pixelexact::SeenCut> Cut;
  int Size[2] = { 1000, 1000 };
  std::string FieldName;
  int Component = -1;
  int NumberOfColors = 256;
  double Share = 0.99;
  std::unique_ptr<pixelexact::ContourList> Contours;
  std::unique_ptr<pixelexact::GridModel> Model;
};

#endif
