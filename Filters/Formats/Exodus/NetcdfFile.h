// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pixelexact
{
/// A netCDF file as plain arrays. All throw InvalidData, with the variable's name, where values are
/// missing, of another type, or beyond the end of the file. No number of the file is believed: no
/// more memory is taken than the file's own size justifies.
class NetcdfFile
{
public:
  /// Places along the first dimensions of a variable; the others are read whole.
  using Places = std::span<const std::size_t>;

  virtual ~NetcdfFile() = default;

  /// The length of a dimension; none: the file has no such dimension.
  [[nodiscard]] virtual std::optional<std::size_t> Dimension(const std::string& name) const = 0;
  /// The lengths of a variable along its dimensions; none: the file has no such variable.
  [[nodiscard]] virtual std::optional<std::vector<std::size_t>> Shape(
    const std::string& variable) const = 0;
  /// Whether a variable holds real numbers of single precision.
  [[nodiscard]] virtual bool IsSingle(const std::string& variable) const = 0;

  /// Values, the last dimension fastest. Real numbers are of single or double precision, integers
  /// of any size that the format has.
  [[nodiscard]] virtual std::vector<double> Reals(
    const std::string& variable, Places places = {}) const = 0;
  [[nodiscard]] virtual std::vector<std::int64_t> Integers(const std::string& variable) const = 0;
  /// The rows of an array of characters, each to its first zero byte.
  [[nodiscard]] virtual std::vector<std::string> Texts(const std::string& variable) const = 0;
  /// A text that describes a variable; empty: there is none.
  [[nodiscard]] virtual std::string TextAttribute(
    const std::string& variable, const std::string& name) const = 0;
};

/// Opens a file of the classic formats (versions 1, 2 and 5) or of netCDF-4, which is HDF5. Throws
/// InvalidData for other and damaged files, Unsupported for netCDF-4 without the HDF5 library.
std::unique_ptr<NetcdfFile> OpenNetcdf(const std::string& path);

/// Opens files of the classic formats.
std::unique_ptr<NetcdfFile> OpenClassicNetcdf(const std::string& path);
} // namespace pixelexact
