// SPDX-License-Identifier: BSD-3-Clause
#ifndef TimeSeries_h
#define TimeSeries_h

#include "PixelExactFiltersModule.h"

#include <string>
#include <vector>

// Assigns files of grids to time steps. Throws Error, naming the file, for lists that cannot be
// read.
namespace pixelexact
{
/// A file of a grid that may have several.
struct GridPart
{
  std::string file;
  std::string list{}; ///< the file that names it; empty: the user did
  /// The part's name in a collection (group, part and name); empty where no collection names it.
  std::string label{};
  /// Among what the collection lists at this time: pieces of one .pvtu file have the same number.
  int entry = 0;
  std::size_t step = 0; ///< of a file that has several, counted from 0
};

struct TimeStep
{
  double time = 0.0;
  std::vector<GridPart> parts;
  bool isTimed =
    false; ///< the file states the time; else it is the step's number or a collection's
};

/// The steps of a collection (.pvd) by ascending time, its parts in the order of the file.
PIXELEXACTFILTERS_EXPORT std::vector<TimeStep> ReadCollection(const std::string& file);

/// One step per file, at the times 0, 1, 2...
PIXELEXACTFILTERS_EXPORT std::vector<TimeStep> NumberFiles(const std::vector<std::string>& files);

/// Whether a file's suffix is that of VTK's HDF format.
PIXELEXACTFILTERS_EXPORT bool IsVtkHdfName(const std::string& file);

/// As NumberFiles, for files of VTK's HDF format, which may have steps of their own: all steps by
/// ascending time. Throws Error where only some of the files have times.
PIXELEXACTFILTERS_EXPORT std::vector<TimeStep> ListHdfSteps(const std::vector<std::string>& files);

/// The pieces of a parallel file (.pvtu).
PIXELEXACTFILTERS_EXPORT std::vector<GridPart> ReadPieces(const GridPart& part);

/// The suffix in lower case, with its point.
PIXELEXACTFILTERS_EXPORT std::string LowerSuffix(const std::string& file);
} // namespace pixelexact
#endif
