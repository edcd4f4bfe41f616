// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pixelexact
{
/// Whether bytes begin as an HDF5 file.
inline bool IsHdf5(std::string_view bytes)
{
  return bytes.starts_with("\x89HDF\r\n");
}

/// The kind of an object in a file. Sizes of numbers and byte orders do not matter.
enum class Hdf5Kind : std::uint8_t
{
  Group,
  Reals,
  Integers, ///< with a sign
  Unsigned,
  Texts,
  Other
};

/// Consecutive rows of a data set: places along its first direction.
struct Hdf5Rows
{
  std::size_t first = 0;
  std::size_t count = 0;
};

/// An HDF5 file as plain arrays. Paths are absolute. All functions throw InvalidData, with the
/// file's name and the path, where something is missing, of another type, or damaged.
class Hdf5File
{
public:
  virtual ~Hdf5File() = default;

  [[nodiscard]] virtual bool Has(const std::string& path) const = 0;
  /// The names of what a group contains, in alphabetical order.
  [[nodiscard]] virtual std::vector<std::string> Names(const std::string& group) const = 0;
  /// The kind of a group or of a data set's values. Other for links that lead nowhere.
  [[nodiscard]] virtual Hdf5Kind KindOf(const std::string& path) const = 0;
  /// The lengths of a data set along its directions.
  [[nodiscard]] virtual std::vector<std::size_t> Shape(const std::string& path) const = 0;
  /// The bytes of one value of a data set.
  [[nodiscard]] virtual std::size_t BytesOfValue(const std::string& path) const = 0;
  /// A data set, the last direction fastest, at given places along its first directions.
  [[nodiscard]] virtual std::vector<double> Reals(
    const std::string& path, std::span<const std::size_t> places = {}) const = 0;
  /// Rows of a data set, the last direction fastest.
  [[nodiscard]] virtual std::vector<double> Reals(
    const std::string& path, const Hdf5Rows& rows) const = 0;
  [[nodiscard]] virtual std::vector<std::int64_t> Integers(
    const std::string& path, const Hdf5Rows& rows) const = 0;
  [[nodiscard]] virtual std::vector<std::uint64_t> Unsigned(
    const std::string& path, const Hdf5Rows& rows) const = 0;
  /// A whole data set.
  [[nodiscard]] virtual std::vector<std::int64_t> Integers(const std::string& path) const = 0;
  [[nodiscard]] virtual std::vector<std::uint64_t> Unsigned(const std::string& path) const = 0;
  [[nodiscard]] virtual std::vector<std::string> Texts(const std::string& path) const = 0;

  /// Attributes of the group or data set at `path`.
  [[nodiscard]] virtual bool HasAttribute(
    const std::string& path, const std::string& name) const = 0;
  [[nodiscard]] virtual std::vector<double> RealAttributes(
    const std::string& path, const std::string& name) const = 0;
  [[nodiscard]] virtual std::vector<std::int64_t> IntegerAttributes(
    const std::string& path, const std::string& name) const = 0;
  [[nodiscard]] virtual std::vector<std::string> TextAttributes(
    const std::string& path, const std::string& name) const = 0;
};

/// A file from its content in memory, which is kept alive by the caller. Throws InvalidData for
/// what is no HDF5 file, Unsupported where the build has no HDF5 library.
std::unique_ptr<Hdf5File> OpenHdf5(const std::string& name, std::string_view bytes);

/// Opens a file on disk. Only the requested data are read.
std::unique_ptr<Hdf5File> OpenHdf5(const std::string& path);
} // namespace pixelexact
