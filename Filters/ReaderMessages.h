// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReaderMessages_h
#define ReaderMessages_h

#include "PixelExactFiltersModule.h"

#include "vtkCommand.h"

#include <string>
#include <string_view>

class vtkXMLReader;

namespace pixelexact
{
/// Keeps the first thing that a reader reports instead of having it printed.
class ReaderMessages : public vtkCommand
{
public:
  static ReaderMessages* New() { return new ReaderMessages; }
  void Execute(vtkObject* caller, unsigned long event, void* data) override;
  void Watch(vtkXMLReader* reader);

  std::string first; ///< empty: none
};

/// "ERROR: In x.cxx, line 7\nvtkReader (0x5581): Cannot read." becomes "Cannot read", on one line.
PIXELEXACTFILTERS_EXPORT std::string MessageEssence(std::string_view text);
} // namespace pixelexact
#endif
