// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderComparison
 * @brief   how far linear cut-surfaces are from the exact picture, pixel by pixel
 *
 * Port 0 takes a grid with high-order coefficients, or composite data of such grids. Port 1 takes
 * any number of polygonal surfaces with a point array of the field's name, from any pipeline:
 * vtkHighOrderLinearCut, or vtkCutter after vtkHighOrderSubdivide or vtkHighOrderLinearResample, or
 * others. The camera's rays are cast at the exact cut-surface and at each linear one, whose
 * corners' values are interpolated linearly, as a rasteriser does.
 *
 * The output is a table with a row for each surface. Counts are pixels. Columns: Surface, its
 * number; Triangles; Shown, pixels with a value in the exact picture; Missing, of these, pixels
 * without a value in the linear picture; Invented, pixels with a value where the exact picture
 * shows nothing; LargestError and MeanError, over pixels with a value in both, relative to the
 * exact picture's range; ErrorAtShare, the error that the given share of the shown pixels does not
 * exceed (a missing value counts as infinite); WrongColors, pixels with another colour. With
 * contour values there are also ContourPixels, ContourMissed, ContourDisplaced, ContourInvented and
 * ContourFarthest (in pixels; see Trace/Compare/PictureErrors.h).
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

  /// Includes the times of cut function and camera.
  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * The port of the linear surfaces.
   */
  void AddSurfaceConnection(vtkAlgorithmOutput* surface);
  void RemoveAllSurfaces();
  ///@}

  ///@{
  /**
   * The function whose zeros are the cut-surface; required.
   */
  void SetCutFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetCutFunction();
  ///@}

  ///@{
  /**
   * The camera of the pictures. Null, the default: a parallel view of the whole grid, along the
   * normal of a plane, or from (1, 1, 1) for other surfaces.
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
   * The field; empty, the default: the first one. A name that the grid lacks is an error.
   */
  vtkSetMacro(FieldName, std::string);
  vtkGetMacro(FieldName, std::string);
  ///@}

  ///@{
  /**
   * The component of the field, from 0, or -1, the default: the value of a scalar, the magnitude of
   * a vector.
   */
  vtkSetMacro(Component, int);
  vtkGetMacro(Component, int);
  ///@}

  ///@{
  /**
   * Number of colours of the map, which spans the values of the exact picture. The default is 256.
   */
  vtkSetClampMacro(NumberOfColors, int, 1, 1000000);
  vtkGetMacro(NumberOfColors, int);
  ///@}

  ///@{
  /**
   * The share of the shown pixels for ErrorAtShare. The default is 0.99.
   */
  vtkSetClampMacro(Share, double, 0.001, 1.0);
  vtkGetMacro(Share, double);
  ///@}

  ///@{
  /**
   * Values of contours, which must be finite; the default is none.
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

  /// Throws Error. Returns false if it was aborted.
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
