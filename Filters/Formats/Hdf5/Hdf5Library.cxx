// SPDX-License-Identifier: BSD-3-Clause
// The only file that knows the HDF5 library.
#include "Formats/Hdf5/Hdf5File.h"

#include "Core/Base/Error.h"
#include "Formats/ApartProcess.h"
#include "Formats/FileText.h"

#include <hdf5.h>
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <mutex>
#include <set>
#include <tuple>
#include <utility>

namespace pixelexact
{
namespace
{
using Close = herr_t (*)(hid_t);

/// An identifier of the library, closed at the end.
class Handle
{
public:
  Handle(hid_t id, Close close)
    : Id(id)
    , CloseIt(close)
  {
  }
  ~Handle()
  {
    if (Id >= 0)
    {
      CloseIt(Id);
    }
  }
  Handle(Handle&& other) noexcept
    : Id(std::exchange(other.Id, H5I_INVALID_HID))
    , CloseIt(other.CloseIt)
  {
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle& operator=(Handle&&) = delete;

  [[nodiscard]] hid_t Get() const { return Id; }
  [[nodiscard]] bool IsValid() const { return Id >= 0; }

private:
  hid_t Id;
  Close CloseIt;
};

/// Suppresses the library's own messages on stderr during its lifetime in the thread.
class QuietLibrary
{
public:
  QuietLibrary()
  {
    if (living++ == 0)
    {
      H5Eget_auto2(H5E_DEFAULT, &function, &data);
      H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    }
  }
  ~QuietLibrary()
  {
    if (--living == 0)
    {
      H5Eset_auto2(H5E_DEFAULT, function, data);
    }
  }
  QuietLibrary(const QuietLibrary&) = delete;
  QuietLibrary& operator=(const QuietLibrary&) = delete;

private:
  static inline thread_local int living = 0;
  static inline thread_local H5E_auto2_t function = nullptr;
  static inline thread_local void* data = nullptr;
};

class LibraryFile final : public Hdf5File
{
public:
  LibraryFile(std::string name, Handle file, std::size_t bytes)
    : FileName(std::move(name))
    , File(std::move(file))
    , Bytes(bytes)
  {
  }

  [[nodiscard]] bool Has(const std::string& path) const override;
  [[nodiscard]] std::vector<std::string> Names(const std::string& group) const override;
  [[nodiscard]] Hdf5Kind KindOf(const std::string& path) const override;
  [[nodiscard]] std::vector<std::size_t> Shape(const std::string& path) const override;
  [[nodiscard]] std::size_t BytesOfValue(const std::string& path) const override;
  [[nodiscard]] std::vector<double> Reals(
    const std::string& path, std::span<const std::size_t> places) const override
  {
    return ReadSet<double>(path, H5T_NATIVE_DOUBLE, H5T_FLOAT,
      [&](const Handle& space) { SelectPlaces(space, places, path); });
  }
  [[nodiscard]] std::vector<double> Reals(
    const std::string& path, const Hdf5Rows& rows) const override
  {
    return ReadRows<double>(path, H5T_NATIVE_DOUBLE, H5T_FLOAT, rows);
  }
  [[nodiscard]] std::vector<std::int64_t> Integers(
    const std::string& path, const Hdf5Rows& rows) const override
  {
    return ReadRows<std::int64_t>(path, H5T_NATIVE_INT64, H5T_INTEGER, rows);
  }
  [[nodiscard]] std::vector<std::uint64_t> Unsigned(
    const std::string& path, const Hdf5Rows& rows) const override
  {
    return ReadRows<std::uint64_t>(path, H5T_NATIVE_UINT64, H5T_INTEGER, rows);
  }
  [[nodiscard]] std::vector<std::int64_t> Integers(const std::string& path) const override
  {
    return ReadSet<std::int64_t>(path, H5T_NATIVE_INT64, H5T_INTEGER);
  }
  [[nodiscard]] std::vector<std::uint64_t> Unsigned(const std::string& path) const override
  {
    return ReadSet<std::uint64_t>(path, H5T_NATIVE_UINT64, H5T_INTEGER);
  }
  [[nodiscard]] std::vector<std::string> Texts(const std::string& path) const override;
  [[nodiscard]] bool HasAttribute(const std::string& path, const std::string& name) const override;
  [[nodiscard]] std::vector<double> RealAttributes(
    const std::string& path, const std::string& name) const override
  {
    return ReadAttribute<double>(path, name, H5T_NATIVE_DOUBLE, H5T_FLOAT);
  }
  [[nodiscard]] std::vector<std::int64_t> IntegerAttributes(
    const std::string& path, const std::string& name) const override
  {
    return ReadAttribute<std::int64_t>(path, name, H5T_NATIVE_INT64, H5T_INTEGER);
  }
  [[nodiscard]] std::vector<std::string> TextAttributes(
    const std::string& path, const std::string& name) const override;

private:
  using Reader = std::function<herr_t(hid_t memoryType, void* values)>;
  using Selector = std::function<void(const Handle& space)>;

  [[noreturn]] void Fail(const std::string& path, const std::string& problem) const
  {
    throw InvalidData(FileName + ", " + path + ": " + problem);
  }
  [[nodiscard]] Handle OpenSet(const std::string& path) const;
  [[nodiscard]] Handle OpenAttribute(const std::string& path, const std::string& name) const;
  [[nodiscard]] std::size_t Count(
    const Handle& space, const Handle& type, const std::string& path) const;
  void SelectPlaces(
    const Handle& space, std::span<const std::size_t> places, const std::string& path) const;
  void SelectRows(const Handle& space, const Hdf5Rows& rows, const std::string& path) const;
  template <class Value>
  std::vector<Value> ReadSet(const std::string& path, hid_t memory, H5T_class_t kind,
    const Selector& select = nullptr) const;
  template <class Value>
  std::vector<Value> ReadRows(
    const std::string& path, hid_t memory, H5T_class_t kind, const Hdf5Rows& rows) const
  {
    return ReadSet<Value>(
      path, memory, kind, [&](const Handle& space) { SelectRows(space, rows, path); });
  }
  template <class Value>
  std::vector<Value> ReadAttribute(
    const std::string& path, const std::string& name, hid_t memory, H5T_class_t kind) const;
  [[nodiscard]] std::vector<std::string> ReadTexts(
    const Handle& type, const Handle& space, const std::string& path, const Reader& read) const;

  QuietLibrary Quiet;
  std::string FileName;
  Handle File;
  std::size_t Bytes; ///< of the whole file
};

bool LibraryFile::Has(const std::string& path) const
{
  // The library checks only one part of a path at a time.
  for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1))
  {
    if (H5Lexists(File.Get(), path.substr(0, end).c_str(), H5P_DEFAULT) <= 0)
    {
      return false;
    }
    if (end == std::string::npos)
    {
      return true;
    }
  }
}

std::vector<std::string> LibraryFile::Names(const std::string& group) const
{
  const Handle object(Has(group) ? H5Gopen2(File.Get(), group.c_str(), H5P_DEFAULT)
                                 : static_cast<hid_t>(H5I_INVALID_HID),
    &H5Gclose);
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* all) -> herr_t
  {
    static_cast<std::vector<std::string>*>(all)->emplace_back(name);
    return 0;
  };
  if (!object.IsValid() ||
    H5Literate(object.Get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names) < 0)
  {
    Fail(group, "there is no such group; the file is damaged or of another program.");
  }
  return names;
}

Hdf5Kind LibraryFile::KindOf(const std::string& path) const
{
  const Handle object(Has(path) ? H5Oopen(File.Get(), path.c_str(), H5P_DEFAULT)
                                : static_cast<hid_t>(H5I_INVALID_HID),
    &H5Oclose);
  if (!object.IsValid() || H5Iget_type(object.Get()) != H5I_DATASET)
  {
    return object.IsValid() && H5Iget_type(object.Get()) == H5I_GROUP ? Hdf5Kind::Group
                                                                      : Hdf5Kind::Other;
  }
  const Handle type(H5Dget_type(object.Get()), &H5Tclose);
  switch (H5Tget_class(type.Get()))
  {
    case H5T_FLOAT:
      return Hdf5Kind::Reals;
    case H5T_INTEGER:
      return H5Tget_sign(type.Get()) == H5T_SGN_NONE ? Hdf5Kind::Unsigned : Hdf5Kind::Integers;
    case H5T_STRING:
      return Hdf5Kind::Texts;
    default:
      return Hdf5Kind::Other;
  }
}

Handle LibraryFile::OpenSet(const std::string& path) const
{
  Handle set(
    Has(path) ? H5Dopen2(File.Get(), path.c_str(), H5P_DEFAULT) : H5I_INVALID_HID, &H5Dclose);
  if (!set.IsValid())
  {
    Fail(path, "there is no such data set; the file is damaged or of another program.");
  }
  return set;
}

std::vector<std::size_t> LibraryFile::Shape(const std::string& path) const
{
  const Handle set = OpenSet(path);
  const Handle space(H5Dget_space(set.Get()), &H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space.Get());
  std::vector<hsize_t> lengths(static_cast<std::size_t>(std::max(rank, 0)));
  if (rank > 0)
  {
    H5Sget_simple_extent_dims(space.Get(), lengths.data(), nullptr);
  }
  return { lengths.begin(), lengths.end() };
}

std::size_t LibraryFile::Count(
  const Handle& space, const Handle& type, const std::string& path) const
{
  // A compressed data set may be larger than the file: a thousandfold, zlib's limit.
  constexpr std::size_t kExpansion = 1032;
  const hssize_t count = H5Sget_simple_extent_npoints(space.Get());
  const std::size_t size = H5Tget_size(type.Get());
  if (count < 0 || size == 0 || static_cast<std::size_t>(count) / kExpansion > Bytes / size)
  {
    Fail(path, "it is larger than the file can hold; the file is damaged.");
  }
  return static_cast<std::size_t>(count);
}

std::size_t LibraryFile::BytesOfValue(const std::string& path) const
{
  const Handle set = OpenSet(path);
  const Handle type(H5Dget_type(set.Get()), &H5Tclose);
  return H5Tget_size(type.Get());
}

/// Restricts a data set to given places along its first directions.
void LibraryFile::SelectPlaces(
  const Handle& space, std::span<const std::size_t> places, const std::string& path) const
{
  if (places.empty())
  {
    return;
  }
  const int rank = H5Sget_simple_extent_ndims(space.Get());
  if (rank < 0 || places.size() > static_cast<std::size_t>(rank))
  {
    Fail(path, "it has fewer directions than it should; the file is damaged.");
  }
  std::vector<hsize_t> begin(static_cast<std::size_t>(rank), 0);
  std::vector<hsize_t> count(static_cast<std::size_t>(rank), 0);
  H5Sget_simple_extent_dims(space.Get(), count.data(), nullptr);
  for (std::size_t d = 0; d < places.size(); ++d)
  {
    if (places[d] >= count[d])
    {
      Fail(path, "it has fewer values than the file says; the file is damaged or cut short.");
    }
    begin[d] = places[d];
    count[d] = 1;
  }
  H5Sselect_hyperslab(space.Get(), H5S_SELECT_SET, begin.data(), nullptr, count.data(), nullptr);
}

void LibraryFile::SelectRows(
  const Handle& space, const Hdf5Rows& rows, const std::string& path) const
{
  const int rank = H5Sget_simple_extent_ndims(space.Get());
  std::vector<hsize_t> count(static_cast<std::size_t>(std::max(rank, 0)));
  if (rank < 1)
  {
    Fail(path, "it has fewer directions than it should; the file is damaged.");
  }
  std::vector<hsize_t> begin(count.size(), 0);
  H5Sget_simple_extent_dims(space.Get(), count.data(), nullptr);
  if (rows.first > count[0] || rows.count > count[0] - rows.first)
  {
    Fail(path, "it has fewer values than the file says; the file is damaged or cut short.");
  }
  begin[0] = rows.first;
  count[0] = rows.count;
  if (std::ranges::find(count, hsize_t{ 0 }) != count.end())
  {
    H5Sselect_none(space.Get());
    return;
  }
  H5Sselect_hyperslab(space.Get(), H5S_SELECT_SET, begin.data(), nullptr, count.data(), nullptr);
}

template <class Value>
std::vector<Value> LibraryFile::ReadSet(
  const std::string& path, hid_t memory, H5T_class_t kind, const Selector& select) const
{
  const Handle set = OpenSet(path);
  const Handle space(H5Dget_space(set.Get()), &H5Sclose);
  const Handle type(H5Dget_type(set.Get()), &H5Tclose);
  if (H5Tget_class(type.Get()) != kind)
  {
    Fail(path, "its numbers are of another type than they should be.");
  }
  std::size_t count = Count(space, type, path);
  if (select)
  {
    select(space);
    count = static_cast<std::size_t>(H5Sget_select_npoints(space.Get()));
  }
  std::vector<Value> values(count);
  const hsize_t length = count;
  const Handle block(H5Screate_simple(1, &length, nullptr), &H5Sclose);
  if (!values.empty() &&
    H5Dread(set.Get(), memory, block.Get(), space.Get(), H5P_DEFAULT, values.data()) < 0)
  {
    Fail(path, "it cannot be read; the file is damaged or cut short.");
  }
  return values;
}

std::vector<std::string> LibraryFile::ReadTexts(
  const Handle& type, const Handle& space, const std::string& path, const Reader& read) const
{
  if (H5Tget_class(type.Get()) != H5T_STRING)
  {
    Fail(path, "it should be text.");
  }
  const std::size_t count = Count(space, type, path);
  std::vector<std::string> texts(count);
  if (H5Tis_variable_str(type.Get()) > 0)
  {
    const Handle memory(H5Tcopy(H5T_C_S1), &H5Tclose);
    H5Tset_size(memory.Get(), H5T_VARIABLE);
    H5Tset_cset(memory.Get(), H5Tget_cset(type.Get()));
    std::vector<char*> words(count, nullptr);
    if (count > 0 && read(memory.Get(), words.data()) < 0)
    {
      Fail(path, "it cannot be read; the file is damaged or cut short.");
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      texts[i] = words[i] != nullptr ? words[i] : "";
      H5free_memory(words[i]);
    }
    return texts;
  }
  const std::size_t size = H5Tget_size(type.Get());
  std::string all(count * size, '\0');
  if (count > 0 && read(type.Get(), all.data()) < 0)
  {
    Fail(path, "it cannot be read; the file is damaged or cut short.");
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::string_view whole = std::string_view(all).substr(i * size, size);
    texts[i] = whole.substr(0, whole.find('\0'));
  }
  return texts;
}

std::vector<std::string> LibraryFile::Texts(const std::string& path) const
{
  const Handle set = OpenSet(path);
  const Handle space(H5Dget_space(set.Get()), &H5Sclose);
  const Handle type(H5Dget_type(set.Get()), &H5Tclose);
  return ReadTexts(type, space, path,
    [&set](hid_t memory, void* values)
    { return H5Dread(set.Get(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values); });
}

bool LibraryFile::HasAttribute(const std::string& path, const std::string& name) const
{
  return Has(path) && H5Aexists_by_name(File.Get(), path.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

Handle LibraryFile::OpenAttribute(const std::string& path, const std::string& name) const
{
  Handle attribute(HasAttribute(path, name)
      ? H5Aopen_by_name(File.Get(), path.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT)
      : H5I_INVALID_HID,
    &H5Aclose);
  if (!attribute.IsValid())
  {
    Fail(path, "there is no attribute " + name + "; the file is damaged or of another program.");
  }
  return attribute;
}

template <class Value>
std::vector<Value> LibraryFile::ReadAttribute(
  const std::string& path, const std::string& name, hid_t memory, H5T_class_t kind) const
{
  const Handle attribute = OpenAttribute(path, name);
  const Handle space(H5Aget_space(attribute.Get()), &H5Sclose);
  const Handle type(H5Aget_type(attribute.Get()), &H5Tclose);
  if (H5Tget_class(type.Get()) != kind)
  {
    Fail(path, "the numbers of " + name + " are of another type than they should be.");
  }
  std::vector<Value> values(Count(space, type, path));
  if (!values.empty() && H5Aread(attribute.Get(), memory, values.data()) < 0)
  {
    Fail(path, name + " cannot be read; the file is damaged or cut short.");
  }
  return values;
}

std::vector<std::string> LibraryFile::TextAttributes(
  const std::string& path, const std::string& name) const
{
  const Handle attribute = OpenAttribute(path, name);
  const Handle space(H5Aget_space(attribute.Get()), &H5Sclose);
  const Handle type(H5Aget_type(attribute.Get()), &H5Tclose);
  return ReadTexts(type, space, path + ", " + name,
    [&attribute](hid_t memory, void* values) { return H5Aread(attribute.Get(), memory, values); });
}

constexpr const char* kNotSound = "this is no sound HDF5 file; it is damaged or cut short.";

/// Reads all that a file holds, and forgets it: what the library does not survive shows. Of what it
/// cannot open it prints pages when the program ends.
class WholeFile
{
public:
  /// False: a part of the file's structure cannot be read.
  [[nodiscard]] bool Read(hid_t file)
  {
#if H5_VERSION_GE(1, 12, 0)
    return H5Ovisit(file, H5_INDEX_NAME, H5_ITER_NATIVE, &ReadObject, this, H5O_INFO_BASIC) >= 0;
#else
    return H5Ovisit(file, H5_INDEX_NAME, H5_ITER_NATIVE, &ReadObject, this) >= 0;
#endif
  }

private:
  /// Larger data sets are looked up, and not read: numbers cannot harm the library, and files of
  /// many gigabytes are not read twice.
  static constexpr std::size_t kMaxRead = std::size_t{ 256 } << 20U;

  static herr_t ReadObject(hid_t root, const char* name, const H5O_info_t* info, void* self)
  {
    auto* file = static_cast<WholeFile*>(self);
    const Handle object(H5Oopen(root, name, H5P_DEFAULT), &H5Oclose);
    if (!object.IsValid() ||
      H5Aiterate2(object.Get(), H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, &ReadAttribute, self) < 0)
    {
      return -1;
    }
    if (info->type == H5O_TYPE_DATASET)
    {
      file->ReadSet(object.Get());
    }
    return 0;
  }

  static herr_t ReadAttribute(hid_t object, const char* name, const H5A_info_t*, void* self)
  {
    const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), &H5Aclose);
    if (!attribute.IsValid())
    {
      return -1;
    }
    const Handle space(H5Aget_space(attribute.Get()), &H5Sclose);
    const Handle type(H5Aget_type(attribute.Get()), &H5Tclose);
    static_cast<WholeFile*>(self)->Take(space.Get(), type.Get(),
      [&](void* values) { return H5Aread(attribute.Get(), type.Get(), values); });
    return 0;
  }

  void ReadSet(hid_t set)
  {
    const Handle space(H5Dget_space(set), &H5Sclose);
    const Handle type(H5Dget_type(set), &H5Tclose);
    H5Dget_storage_size(set); // all of a data set's index is looked at for this
    Take(space.Get(), type.Get(),
      [&](void* values)
      { return H5Dread(set, type.Get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values); });
  }

  void Take(hid_t space, hid_t type, const std::function<herr_t(void*)>& read)
  {
    const hssize_t count = H5Sget_simple_extent_npoints(space);
    const std::size_t size = H5Tget_size(type);
    if (count <= 0 || size == 0 || static_cast<std::size_t>(count) > (kMaxRead - Taken) / size)
    {
      return; // the reader itself refuses what the file cannot hold
    }
    Taken += static_cast<std::size_t>(count) * size;
    std::vector<char> values(static_cast<std::size_t>(count) * size);
    if (read(values.data()) >= 0)
    {
      H5Dvlen_reclaim(type, space, H5P_DEFAULT, values.data());
    }
  }

  std::size_t Taken = 0;
};

Handle OpenFile(const std::string& name, std::string_view bytes, bool inMemory)
{
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), &H5Pclose);
  if (inMemory)
  {
    constexpr std::size_t kGrowth = 65536;
    H5Pset_fapl_core(access.Get(), kGrowth, false);
    // The library copies the image, and does not change what it was given.
    H5Pset_file_image(access.Get(), const_cast<char*>(bytes.data()), bytes.size());
  }
  // The library refuses an image under the name of a file that exists, and takes two of one name
  // for the same.
  static std::atomic<int> images = 0;
  const std::string opened = inMemory ? name + " in memory " + std::to_string(++images) : name;
  return { H5Fopen(opened.c_str(), H5F_ACC_RDONLY, access.Get()), &H5Fclose };
}

/// Throws InvalidData for a file that the library does not survive.
void RequireHarmless(
  const std::string& name, std::string_view bytes, bool inMemory, std::size_t size)
{
  try
  {
    RunApart(LimitsForFile(size), "the HDF5 library",
      [&]
      {
        const QuietLibrary quiet;
        const Handle file = OpenFile(name, bytes, inMemory);
        if (!file.IsValid() || !WholeFile().Read(file.Get()))
        {
          throw InvalidData(kNotSound);
        }
      });
  }
  catch (const Error& error)
  {
    throw InvalidData(name + ": " + error.what());
  }
}

/// The same for a file on disk, once until it changes.
void RequireHarmless(const std::string& path)
{
  using Version = std::tuple<dev_t, ino_t, off_t, time_t, long>;
  static std::mutex mutex;
  static std::set<Version> harmless;
  struct stat status
  {
  };
  if (stat(path.c_str(), &status) != 0)
  {
    return; // opening it fails
  }
  const Version version{ status.st_dev, status.st_ino, status.st_size, status.st_mtim.tv_sec,
    status.st_mtim.tv_nsec };
  const std::lock_guard lock(mutex);
  if (!harmless.contains(version))
  {
    RequireHarmless(path, {}, false, static_cast<std::size_t>(status.st_size));
    harmless.insert(version);
  }
}

std::unique_ptr<Hdf5File> Open(const std::string& name, std::string_view bytes, bool inMemory)
{
  const QuietLibrary quiet;
  Handle file = OpenFile(name, bytes, inMemory);
  hsize_t size = 0;
  if (!file.IsValid() || H5Fget_filesize(file.Get(), &size) < 0)
  {
    throw InvalidData(name + ": " + kNotSound);
  }
  return std::make_unique<LibraryFile>(name, std::move(file), static_cast<std::size_t>(size));
}
} // namespace

std::unique_ptr<Hdf5File> OpenHdf5(const std::string& name, std::string_view bytes)
{
  RequireHarmless(name, bytes, true, bytes.size());
  return Open(name, bytes, true);
}

std::unique_ptr<Hdf5File> OpenHdf5(const std::string& path)
{
  RequireRegularFile(path);
  RequireHarmless(path);
  return Open(path, {}, false);
}
} // namespace pixelexact
