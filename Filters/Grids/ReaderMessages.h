// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReaderMessages_h
#define ReaderMessages_h

#include "PixelExactFiltersModule.h"

#include "vtkCommand.h"

#include <string>
#include <string_view>
#include <vector>

class vtkXMLReader;

namespace pixelexact
{
/// Keeps what a reader reports instead of having it printed.
class ReaderMessages : public vtkCommand
{
public:
  static ReaderMessages* New() { return new ReaderMessages; }
  void Execute(vtkObject* caller, unsigned long event, void* data) override;
  void Watch(vtkXMLReader* reader);

  std::string error;                 ///< the first one; empty: none
  std::vector<std::string> warnings; ///< each once
};

/// "ERROR: In x.cxx, line 7\nvtkReader (0x5581): Cannot read." becomes "Cannot read", on one line.
PIXELEXACTFILTERS_EXPORT std::string MessageEssence(std::string_view text);

/// Adds the essence of a warning, once. Left out are keys of vtkExodusIIReader, which ParaView
/// saves with what it has read by it: they say nothing of mesh or fields.
PIXELEXACTFILTERS_EXPORT void AddWarning(std::vector<std::string>& lines, std::string_view text);

/// Adds a line that is not there yet.
PIXELEXACTFILTERS_EXPORT void AddOnce(std::vector<std::string>& lines, const std::string& line);
} // namespace pixelexact
#endif
