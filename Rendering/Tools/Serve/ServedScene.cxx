// SPDX-License-Identifier: BSD-3-Clause
#include "Serve/ServedScene.h"

#include "Base/Command.h"
#include "Base/CommandWords.h"
#include "Base/Report.h"
#include "Serve/ServedInput.h"

#include <vtkUnstructuredGrid.h>

namespace pixelexact
{
std::shared_ptr<CLI::App> ParseRender(const std::vector<std::string>& words, RenderOptions& options)
{
  CommonOptions ignored;
  return ParseCommand(words,
    [&](CLI::App& command)
    {
      options.AddTo(command);
      AddCommonOptions(command, ignored);
    });
}

ServedScene::ServedScene(
  const std::vector<std::string>& words, const std::string& picture, ServedInput& input)
  : Program(ParseRender(words, options_))
{
  options_.Check(picture);
  const ShotOptions asked = options_.OfPicture();
  Stopwatch watch;
  std::vector<std::string> expressions = asked.surfaces.Fields();
  expressions.push_back(asked.field);
  shot_ = Prepare(asked, input.Get(asked.input, expressions), watch);
}

ServedScene::~ServedScene() = default;
} // namespace pixelexact
