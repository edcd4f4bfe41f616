// SPDX-License-Identifier: BSD-3-Clause
#include "Views/StockSettings.h"

#include "Core/Base/Error.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProperty.h"

#include <array>
#include <sstream>

namespace pixelexact
{
namespace
{
bool HasShaders(vtkShaderProperty* shaders)
{
  return shaders->GetNumberOfShaderReplacements() > 0 || shaders->HasVertexShaderCode() ||
    shaders->HasFragmentShaderCode() || shaders->HasGeometryShaderCode();
}

bool HasNoLogarithm(vtkMapper* mapper)
{
  return mapper->GetLookupTable()->UsingLogScale() != 0 && !(mapper->GetScalarRange()[0] > 0.0);
}

std::string LogarithmText(vtkMapper* mapper)
{
  const double* range = mapper->GetScalarRange();
  std::ostringstream text;
  text << "the lookup table's scale is logarithmic, but the range, " << range[0] << " to "
       << range[1] << ", is not above 0, and the table keeps its own: set a ScalarRange that is";
  return text.str();
}
} // namespace

void RequireFieldColors(vtkMapper* mapper)
{
  if (!mapper->GetScalarVisibility())
  {
    return;
  }
  switch (mapper->GetScalarMode())
  {
    case VTK_SCALAR_MODE_USE_CELL_DATA:
    case VTK_SCALAR_MODE_USE_CELL_FIELD_DATA:
    case VTK_SCALAR_MODE_USE_FIELD_DATA:
      throw Unsupported("ScalarMode " + std::string(mapper->GetScalarModeAsString()) +
        ": colours are those of a high-order field, not of cell or field data; "
        "SetScalarModeToDefault() and SetFieldName() choose one");
    default:
      break;
  }
  if (mapper->GetColorMode() == VTK_COLOR_MODE_DIRECT_SCALARS)
  {
    throw Unsupported("ColorModeToDirectScalars: a high-order field's values are no colours; "
                      "SetColorModeToMapScalars() maps them through the lookup table");
  }
}

std::vector<std::string> SettingsWithoutEffect(vtkMapper* mapper, vtkActor* actor, bool mapped)
{
  vtkProperty* property = actor->GetProperty();
  struct Setting
  {
    bool set;
    const char* text;
  };
  const std::array settings{
    Setting{ property->GetRepresentation() != VTK_SURFACE,
      "Representation: a cut is drawn as a surface; EdgeVisibilityOn() adds the elements' edges" },
    Setting{ property->GetInterpolation() == VTK_PBR,
      "InterpolationToPBR: a cut is lit as with InterpolationToPhong, by its exact normals" },
    Setting{ property->GetBackfaceCulling() || property->GetFrontfaceCulling(),
      "BackfaceCulling and FrontfaceCulling: both sides of a cut are drawn; clipping planes cut "
      "away what hides the rest" },
    Setting{ actor->GetBackfaceProperty() != nullptr,
      "BackfaceProperty: both sides of a cut have the actor's property" },
    Setting{ property->GetVertexVisibility() != 0, "VertexVisibility: a cut has no vertices" },
    Setting{ actor->GetTexture() != nullptr || property->GetNumberOfTextures() > 0,
      "Texture: a cut has no texture coordinates" },
    Setting{ HasShaders(actor->GetShaderProperty()),
      "ShaderProperty: a cut's pixels are not made by shaders" },
  };
  std::vector<std::string> texts;
  for (const Setting& setting : settings)
  {
    if (setting.set)
    {
      texts.emplace_back(setting.text);
    }
  }
  if (mapped && HasNoLogarithm(mapper))
  {
    texts.push_back(LogarithmText(mapper));
  }
  return texts;
}
} // namespace pixelexact
