// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

class vtkActor;
class vtkMapper;
class vtkProperty;

// Settings of stock mappers, properties and actors that have no effect on a cut.
// Documentation/windows.md has the whole table.
namespace pixelexact
{
/// Throws Unsupported, naming the setting and the remedy, if the mapper is set to colours that are
/// not those of a high-order field, because the picture would be wrong.
void RequireFieldColors(vtkMapper* mapper);

/// One sentence for each setting of actor, property and mapper that is ignored but does not make
/// the picture wrong. `mapped`: the mapper's lookup table colours something.
[[nodiscard]] std::vector<std::string> SettingsWithoutEffect(
  vtkMapper* mapper, vtkActor* actor, bool mapped);
} // namespace pixelexact
