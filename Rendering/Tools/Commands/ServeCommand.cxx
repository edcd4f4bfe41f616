// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Command.h"
#include "Base/CommandWords.h"
#include "Base/Output.h"
#include "Base/Report.h"
#include "Picture/RenderOptions.h"
#include "Picture/ShownWords.h"
#include "Serve/Serving.h"

#include <memory>
#include <string>

namespace pixelexact
{
void AddServeCommand(CLI::App& program, const CommonOptions& common, Action& action)
{
  struct Options
  {
    RenderOptions render;
    ServingOptions serving;
  };
  const auto options = std::make_shared<Options>();
  CLI::App& command = AddCommand(program, "serve",
    "Show a cut in browsers, with render's options: a page with the exact picture, its values and "
    "controls",
    [options, &common, &action, &program]
    {
      action = [options, &common, &program]
      { Serve(options->render, options->serving, PrepareWords(program, common.words)); };
    });
  options->render.AddTo(command);
  Bind(command, "--address", options->serving.address);
  Bind(command, "--port", options->serving.port);
  Bind(command, "--views", options->serving.views);
  Bind(command, "--until-input-ends", options->serving.untilInputEnds);
}
} // namespace pixelexact
