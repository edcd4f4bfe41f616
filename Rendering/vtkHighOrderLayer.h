// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHighOrderLayer
 * @brief   a cut-surface of a vtkHighOrderMapper with a look of its own
 *
 * What is not set is the mapper's: field, lookup table, lights. Several layers of one mapper are
 * seen by the same rays: where the nearest surface lies outside of the mesh the next one shows, and
 * translucent ones let those behind show through, in the right order.
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
   * Which components of a vector field make the value: see SetComponent.
   */
  enum
  {
    BY_LOOKUP_TABLE = -2,
    MAGNITUDE = -1
  };

  ///@{
  /**
   * The surface: a function as in vtkHighOrderMapper::SetCutFunction, or a surface that is none.
   * One of them is required, and a layer has one: to set one takes away the other; to set null
   * leaves it.
   */
  void SetCutFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetCutFunction();
  void SetSurface(vtkHighOrderSurface* surface);
  vtkHighOrderSurface* GetSurface();
  ///@}

  ///@{
  /**
   * The field to show. Empty (the default): the mapper's.
   */
  virtual void SetFieldName(const char* name);
  vtkGetCharFromStdStringMacro(FieldName);
  ///@}

  ///@{
  /**
   * A component, counted from 0; MAGNITUDE; or BY_LOOKUP_TABLE (the default): as the lookup table's
   * VectorMode and VectorComponent say.
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
   * Whether it has contours (the default is on): those of the mapper, or, where there are any, of
   * these values (see vtkHighOrderMapper::SetContourValue), in the mapper's ContourColor.
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
   * Above 0: instead of these values so many round ones, strictly inside the range of the layer's
   * colours, as vtkHighOrderMapper::SetContourCount. 0, the default: the values above.
   */
  vtkSetClampMacro(ContourCount, int, 0, 10000);
  vtkGetMacro(ContourCount, int);
  ///@}

  ///@{
  /**
   * From 0 to 1 (the default), times the actor's.
   */
  vtkSetClampMacro(Opacity, double, 0.0, 1.0);
  vtkGetMacro(Opacity, double);
  ///@}

  ///@{
  /**
   * Values in single precision: off by some roundings of a float. The default is off.
   */
  vtkSetMacro(SinglePrecision, bool);
  vtkGetMacro(SinglePrecision, bool);
  vtkBooleanMacro(SinglePrecision, bool);
  ///@}

  ///@{
  /**
   * Whether the renderer's lights shine on the layer, as the actor's property says (the default is
   * on), and whether they do where it is a plane, whose colours are shown as they are unless this
   * is on (the default is off).
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
   * Whether it is there at all. The default is on.
   */
  vtkSetMacro(Visibility, bool);
  vtkGetMacro(Visibility, bool);
  vtkBooleanMacro(Visibility, bool);
  ///@}

  /**
   * Changes with function, surface and table, too.
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
