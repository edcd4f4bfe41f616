// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderLayer
 * @brief   a cut-surface of a vtkHighOrderMapper with an appearance of its own
 *
 * Settings that are not set are the mapper's: field, lookup table, lights. The same rays meet all
 * layers of a mapper. If the nearest surface lies outside the mesh the next one shows, and layers
 * behind translucent ones show through in depth order.
 */

#ifndef vtkHighOrderLayer_h
#define vtkHighOrderLayer_h

#include "PixelExactRenderingModule.h"
#include "vtkObject.h"

#include "vtkSmartPointer.h" // for the surface and the table

#include <memory> // for contours
#include <string> // for the field's name

namespace pixelexact
{
class ContourList;
} // namespace pixelexact

class vtkHighOrderSurface;
class vtkImplicitFunction;
class vtkScalarsToColors;

class PIXELEXACTRENDERING_EXPORT vtkHighOrderLayer : public vtkObject
{
public:
  static vtkHighOrderLayer* New();
  vtkTypeMacro(vtkHighOrderLayer, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Values of SetComponent.
   */
  enum
  {
    BY_LOOKUP_TABLE = -2,
    MAGNITUDE = -1
  };

  ///@{
  /**
   * The surface: a function as in vtkHighOrderMapper::SetCutFunction, or a vtkHighOrderSurface. A
   * layer needs exactly one of them. Setting one removes the other; setting null does not remove
   * the other.
   */
  void SetCutFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetCutFunction();
  void SetSurface(vtkHighOrderSurface* surface);
  vtkHighOrderSurface* GetSurface();
  ///@}

  ///@{
  /**
   * The field. Empty (the default): the mapper's.
   */
  virtual void SetFieldName(const char* name);
  vtkGetCharFromStdStringMacro(FieldName);
  ///@}

  ///@{
  /**
   * A component, counted from 0; MAGNITUDE; or BY_LOOKUP_TABLE (the default), which uses the lookup
   * table's VectorMode and VectorComponent.
   */
  vtkSetMacro(Component, int);
  vtkGetMacro(Component, int);
  ///@}

  ///@{
  /**
   * The colours, over the table's own range. Null (the default): the mapper's table and range.
   */
  void SetLookupTable(vtkScalarsToColors* table);
  vtkScalarsToColors* GetLookupTable();
  ///@}

  ///@{
  /**
   * Off: every exact pixel gets the layer's Color. The default is on.
   */
  vtkSetMacro(ScalarVisibility, bool);
  vtkGetMacro(ScalarVisibility, bool);
  vtkBooleanMacro(ScalarVisibility, bool);
  vtkSetVector3Macro(Color, double);
  vtkGetVector3Macro(Color, double);
  ///@}

  ///@{
  /**
   * Draws contours (the default is on): those of these values, if there are any (see
   * vtkHighOrderMapper::SetContourValue), in the mapper's ContourColor, or else the mapper's
   * contours.
   */
  vtkSetMacro(ContourVisibility, bool);
  vtkGetMacro(ContourVisibility, bool);
  vtkBooleanMacro(ContourVisibility, bool);
  void SetContourValue(int i, double value);
  double GetContourValue(int i);
  void SetNumberOfContours(int number);
  int GetNumberOfContours();
  void GenerateContourValues(int number, double lower, double upper);
  ///@}

  ///@{
  /**
   * Above 0: replaces these values by this number of round values, strictly inside the range of the
   * layer's colours, as vtkHighOrderMapper::SetContourCount. 0, the default: the values above.
   */
  vtkSetClampMacro(ContourCount, int, 0, 10000);
  vtkGetMacro(ContourCount, int);
  ///@}

  ///@{
  /**
   * Opacity, 0 to 1 (the default), multiplied by the actor's.
   */
  vtkSetClampMacro(Opacity, double, 0.0, 1.0);
  vtkGetMacro(Opacity, double);
  ///@}

  ///@{
  /**
   * Computes values in single precision, with an error of some roundings of a float. The default is
   * off.
   */
  vtkSetMacro(SinglePrecision, bool);
  vtkGetMacro(SinglePrecision, bool);
  vtkBooleanMacro(SinglePrecision, bool);
  ///@}

  ///@{
  /**
   * Lighting: the renderer's lights illuminate the layer, with the actor's property. The default is
   * on. LightFlat: they also illuminate planes, which otherwise show unlit colours. The default is
   * off.
   */
  vtkSetMacro(Lighting, bool);
  vtkGetMacro(Lighting, bool);
  vtkBooleanMacro(Lighting, bool);
  vtkSetMacro(LightFlat, bool);
  vtkGetMacro(LightFlat, bool);
  vtkBooleanMacro(LightFlat, bool);
  ///@}

  ///@{
  /**
   * Draws the layer. The default is on.
   */
  vtkSetMacro(Visibility, bool);
  vtkGetMacro(Visibility, bool);
  vtkBooleanMacro(Visibility, bool);
  ///@}

  /**
   * Includes the times of function, surface and table.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkHighOrderLayer();
  ~vtkHighOrderLayer() override;

  vtkSmartPointer<vtkImplicitFunction> CutFunction;
  vtkSmartPointer<vtkHighOrderSurface> Surface;
  std::string FieldName;
  int Component = BY_LOOKUP_TABLE;
  vtkSmartPointer<vtkScalarsToColors> LookupTable;
  bool ScalarVisibility = true;
  double Color[3] = { 1.0, 1.0, 1.0 };
  bool ContourVisibility = true;
  int ContourCount = 0;
  double Opacity = 1.0;
  bool SinglePrecision = false;
  bool Lighting = true;
  bool LightFlat = false;
  bool Visibility = true;

private:
  vtkHighOrderLayer(const vtkHighOrderLayer&) = delete;
  void operator=(const vtkHighOrderLayer&) = delete;

  std::unique_ptr<pixelexact::ContourList> Contours;
};

#endif
