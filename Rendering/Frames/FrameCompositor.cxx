// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/FrameCompositor.h"

#include "Views/OpenGL.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMapper.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

namespace pixelexact
{
namespace
{
// The tags are VTK's, and its passes replace them. Passes expect straight alpha; without a pass,
// the colour is multiplied by its alpha here. texCoord is not needed, but VTK warns about a quad
// whose shader does not use it.
constexpr const char* kFragmentShader = R"(//VTK::System::Dec
//VTK::Output::Dec
//VTK::DepthPeeling::Dec
in vec2 texCoord;
uniform sampler2D frameColors;
uniform sampler2D frameDepths;
uniform ivec2 frameOrigin;
uniform int frameStep;
uniform float frameOpacity;
uniform vec2 frameOffset;
// The smaller of the differences to both neighbours; the larger one may cross an edge.
float frameSlope(ivec2 pixel, ivec2 along, float depth)
{
  ivec2 last = textureSize(frameDepths, 0) - 1;
  float after = texelFetch(frameDepths, min(pixel + along, last), 0).r;
  float before = texelFetch(frameDepths, max(pixel - along, ivec2(0)), 0).r;
  float up = after > 1.0 || pixel + along != min(pixel + along, last) ? 1.0 : abs(after - depth);
  float down = before > 1.0 || pixel - along != max(pixel - along, ivec2(0)) ? 1.0 : abs(before - depth);
  float least = min(up, down);
  return least < 1.0 ? least : 0.0;
}
void main()
{
  ivec2 framePixel = (ivec2(gl_FragCoord.xy) - frameOrigin) / frameStep;
  float frameDepth = texelFetch(frameDepths, framePixel, 0).r;
  vec4 frameColor = texelFetch(frameColors, framePixel, 0);
  frameColor.a *= frameOpacity;
  if (frameDepth > 1.0 || frameColor.a <= 0.0 || texCoord.x < -1.0)
  {
    discard;
  }
  if (frameOffset != vec2(0.0))
  {
    vec2 slope = vec2(frameSlope(framePixel, ivec2(1, 0), frameDepth),
      frameSlope(framePixel, ivec2(0, 1), frameDepth)) / float(frameStep);
    frameDepth = clamp(frameDepth + frameOffset.x * length(slope) + frameOffset.y / 65000.0, 0.0, 1.0);
  }
  gl_FragDepth = frameDepth;
  //VTK::DepthPeeling::PreColor
  gl_FragData[0] = frameColor;
  //VTK::DepthPeeling::Impl
}
)";
constexpr const char* kTag = "//VTK::DepthPeeling::Impl";
constexpr const char* kPremultiply = "gl_FragData[0].rgb *= gl_FragData[0].a;";

template <typename Function>
void ForEachPass(vtkActor* actor, const Function& function)
{
  vtkInformation* keys = actor->GetPropertyKeys();
  if (keys == nullptr || !keys->Has(vtkOpenGLRenderPass::RenderPasses()))
  {
    return;
  }
  const int count = keys->Length(vtkOpenGLRenderPass::RenderPasses());
  for (int i = 0; i < count; ++i)
  {
    function(static_cast<vtkOpenGLRenderPass*>(keys->Get(vtkOpenGLRenderPass::RenderPasses(), i)));
  }
}

void ReplaceAll(std::string& text, const std::string& from, const std::string& to)
{
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
  {
    text.replace(at, from.size(), to);
  }
}

double Dot(const std::array<double, 4>& row, const Vec3& x)
{
  return row[0] * x.x + row[1] * x.y + row[2] * x.z + row[3];
}
} // namespace

void WindowDepth(const SampleBuffers& samples, const DepthRows& rows, std::vector<float>& depth)
{
  depth.resize(samples.Size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, samples.Size(), 1U << 14U),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t i = range.begin(); i < range.end(); ++i)
      {
        const Vec3& x = samples.position[i];
        const double z = 0.5 + 0.5 * (Dot(rows.z, x) / Dot(rows.w, x));
        // The comparison gives kNoDepth for the NaN of a pixel that shows nothing.
        depth[i] = z <= 1.0 ? static_cast<float>(std::max(z, 0.0)) : kNoDepth;
      }
    });
}

FrameCompositor::FrameCompositor()
{
  BeforeDelete->SetClientData(this);
  BeforeDelete->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<FrameCompositor*>(self)->ReleaseGraphicsResources(nullptr); });
}

FrameCompositor::~FrameCompositor()
{
  ReleaseGraphicsResources(Window);
}

std::array<int, 4> FrameCompositor::Viewport(vtkRenderer* renderer)
{
  std::array<int, 4> viewport{};
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (window != nullptr)
  {
    window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport.data());
  }
  return viewport;
}

FrameCompositor::Textures& FrameCompositor::Upload(const Pixels& pixels)
{
  const auto width = static_cast<unsigned int>(pixels.width);
  const auto height = static_cast<unsigned int>(pixels.height);
  while (Sheets.size() <= static_cast<std::size_t>(pixels.sheet))
  {
    Sheets.emplace_back();
  }
  Textures& held = Sheets[static_cast<std::size_t>(pixels.sheet)];
  // VTK takes pointers to non-const data but only reads them.
  if (held.colorsVersion != pixels.colorsVersion)
  {
    held.colors->SetContext(Window);
    held.colors->Create2DFromRaw(
      width, height, 4, VTK_UNSIGNED_CHAR, const_cast<std::uint8_t*>(pixels.rgba.data()));
    held.colorsVersion = pixels.colorsVersion;
  }
  if (held.depthsVersion != pixels.depthsVersion)
  {
    held.depths->SetContext(Window);
    held.depths->Create2DFromRaw(
      width, height, 1, VTK_FLOAT, const_cast<float*>(pixels.depths.data()));
    held.depthsVersion = pixels.depthsVersion;
  }
  return held;
}

vtkOpenGLQuadHelper* FrameCompositor::Quad(vtkActor* actor, vtkMapper* mapper)
{
  std::string source = kFragmentShader;
  // Vertex and geometry shaders are the quad's own; sorting passes do not change them.
  std::string vertex;
  std::string geometry;
  ForEachPass(actor,
    [&](vtkOpenGLRenderPass* pass)
    {
      pass->PreReplaceShaderValues(vertex, geometry, source, mapper, actor);
      pass->PostReplaceShaderValues(vertex, geometry, source, mapper, actor);
    });
  // Passes compare the fragment's depth, which must be the frame's, not the quad's.
  ReplaceAll(source, "gl_FragCoord.z", "frameDepth");
  ReplaceAll(source, kTag, kPremultiply);

  std::unique_ptr<vtkOpenGLQuadHelper>& quad = Quads[source];
  if (!quad)
  {
    quad = std::make_unique<vtkOpenGLQuadHelper>(Window, nullptr, source.c_str(), "");
  }
  else
  {
    Window->GetShaderCache()->ReadyShaderProgram(quad->Program);
  }
  return quad->Program != nullptr ? quad.get() : nullptr;
}

void FrameCompositor::Draw(
  vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper, const Pixels& pixels)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (window == nullptr)
  {
    return;
  }
  if (Window != window)
  {
    ReleaseGraphicsResources(Window);
    Window = window;
    Observer = Window->AddObserver(vtkCommand::DeleteEvent, BeforeDelete);
  }
  Textures& held = Upload(pixels);
  vtkOpenGLQuadHelper* quad = Quad(actor, mapper);
  if (quad == nullptr || held.colors->GetHandle() == 0 || held.depths->GetHandle() == 0)
  {
    return;
  }
  bool sorted = false;
  ForEachPass(actor,
    [&](vtkOpenGLRenderPass* pass)
    {
      sorted = actor->IsRenderingTranslucentPolygonalGeometry();
      pass->SetShaderParameters(quad->Program, mapper, actor, quad->VAO);
    });

  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  const vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  const vtkOpenGLState::ScopedglEnableDisable cullFace(state, GL_CULL_FACE);
  const vtkOpenGLState::ScopedglDepthFunc depthFunc(state);
  const vtkOpenGLState::ScopedglDepthMask depthMask(state);
  const vtkOpenGLState::ScopedglBlendFuncSeparate blendFunc(state);
  state->vtkglDisable(GL_CULL_FACE);
  if (!sorted)
  {
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthFunc(GL_LEQUAL);
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  }

  held.colors->Activate();
  held.depths->Activate();
  const std::array<int, 4> viewport = Viewport(renderer);
  quad->Program->SetUniformi("frameColors", held.colors->GetTextureUnit());
  quad->Program->SetUniformi("frameDepths", held.depths->GetTextureUnit());
  quad->Program->SetUniform2i("frameOrigin", viewport.data());
  quad->Program->SetUniformi("frameStep", pixels.step);
  quad->Program->SetUniformf("frameOpacity", static_cast<float>(pixels.opacity));
  const float offset[2] = { static_cast<float>(pixels.offset.factor),
    static_cast<float>(pixels.offset.units) };
  quad->Program->SetUniform2f("frameOffset", offset);
  quad->Render();
  held.depths->Deactivate();
  held.colors->Deactivate();
}

void FrameCompositor::ReleaseGraphicsResources(vtkWindow* window)
{
  if (Window == nullptr || (window != nullptr && window != Window))
  {
    return;
  }
  // Another window's context may be current.
  Window->PushContext();
  Quads.clear();
  for (Textures& held : Sheets)
  {
    held.colors->ReleaseGraphicsResources(Window);
    held.depths->ReleaseGraphicsResources(Window);
  }
  Sheets.clear();
  Window->PopContext();
  Window->RemoveObserver(Observer);
  Window = nullptr;
}
} // namespace pixelexact
