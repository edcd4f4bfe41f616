// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Exodus/NetcdfFile.h"

#include "Core/Base/Error.h"
#include "Formats/FileText.h"
#include "Formats/Hdf5/Hdf5File.h"

#include <array>
#include <fstream>
#include <string_view>

namespace pixelexact
{
namespace
{
/// NetCDF-4: variables are HDF5's data sets, and dimensions are data sets of their lengths.
class Netcdf4 final : public NetcdfFile
{
public:
  explicit Netcdf4(const std::string& path)
    : File(OpenHdf5(path))
  {
  }

  [[nodiscard]] std::optional<std::size_t> Dimension(const std::string& name) const override
  {
    const auto shape = Shape(name);
    return shape && !shape->empty() ? std::optional(shape->front()) : std::nullopt;
  }

  [[nodiscard]] std::optional<std::vector<std::size_t>> Shape(
    const std::string& variable) const override
  {
    const std::string path = PathOf(variable);
    return File->Has(path) ? std::optional(File->Shape(path)) : std::nullopt;
  }

  [[nodiscard]] bool IsSingle(const std::string& variable) const override
  {
    return File->BytesOfValue(PathOf(variable)) <= sizeof(float);
  }

  [[nodiscard]] std::vector<double> Reals(const std::string& variable, Places places) const override
  {
    return File->Reals(PathOf(variable), places);
  }

  [[nodiscard]] std::vector<std::int64_t> Integers(const std::string& variable) const override
  {
    return File->Integers(PathOf(variable));
  }

  [[nodiscard]] std::vector<std::string> Texts(const std::string& variable) const override
  {
    const std::string path = PathOf(variable);
    const std::vector<std::size_t> shape = File->Shape(path);
    const std::vector<std::string> letters = File->Texts(path);
    const std::size_t length = shape.empty() ? 1 : shape.back();
    std::vector<std::string> rows(length == 0 ? 0 : letters.size() / length);
    for (std::size_t row = 0; row < rows.size(); ++row)
    {
      for (std::size_t i = 0; i < length && !letters[row * length + i].empty(); ++i)
      {
        rows[row] += letters[row * length + i];
      }
    }
    return rows;
  }

  [[nodiscard]] std::string TextAttribute(
    const std::string& variable, const std::string& name) const override
  {
    const std::string path = PathOf(variable);
    const auto texts = File->HasAttribute(path, name) ? File->TextAttributes(path, name)
                                                      : std::vector<std::string>();
    return texts.empty() ? std::string() : texts.front();
  }

private:
  static std::string PathOf(const std::string& variable) { return "/" + variable; }

  std::unique_ptr<Hdf5File> File;
};
} // namespace

std::unique_ptr<NetcdfFile> OpenNetcdf(const std::string& path)
{
  RequireRegularFile(path);
  std::array<char, 8> head{};
  std::ifstream(path, std::ios::binary).read(head.data(), head.size());
  if (IsHdf5({ head.data(), head.size() }))
  {
    return std::make_unique<Netcdf4>(path);
  }
  return OpenClassicNetcdf(path);
}
} // namespace pixelexact
