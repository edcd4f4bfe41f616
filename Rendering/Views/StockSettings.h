// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

class vtkActor;
class vtkMapper;
class vtkProperty;

// What stock mappers, properties and actors let users set and a cut has no way to show. The whole
// table is in Documentation/windows.md.
namespace pixelexact
{
/// Throws Unsupported, naming the setting and the remedy, where the mapper is asked for colours
/// that are not those of a high-order field: a picture without them would show something else.
void RequireFieldColors(vtkMapper* mapper);

/// One sentence for each setting of actor, property and mapper that is not honoured and without
/// which the picture is right in all else. `translucent`: some of the cut is seen through;
/// `mapped`: the mapper's lookup table colours something.
[[nodiscard]] std::vector<std::string> SettingsWithoutEffect(
  vtkMapper* mapper, vtkActor* actor, bool translucent, bool mapped);
} // namespace pixelexact
