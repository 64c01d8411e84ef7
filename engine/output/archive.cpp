#include "engine/output/archive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "engine/output/atomic_file.hpp"
#include "engine/output/commit_driver.hpp"
#include "engine/output/error.hpp"
#include "engine/output/hdf5.hpp"

namespace pliant {
namespace {

using hdf5::checked;
using hdf5::Handle;

constexpr int format = 2;  ///< raised when an older program could no longer read the file
constexpr auto format_attribute = "pliant_archive_format";
constexpr hsize_t chunk_size = 131072;  ///< entries under one checksum

constexpr auto damaged_remedy = "use the checkpoint before it, or run anew";
constexpr auto foreign_remedy = "give a checkpoint that this program wrote, or run anew";

Handle reading_unlocked() {
  Handle properties(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "describe access");
  checked(H5Pset_file_locking(properties, false, true), "leave the file unlocked");
  return properties;
}

template <class T>
void write(hid_t file, const std::string& name, std::span<const T> values) {
  const auto doing = "write " + name;
  const auto type = hdf5::type_of<T>();
  const hsize_t size = values.size();
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose, doing);
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, doing);
  checked(H5Pset_create_intermediate_group(links, 1), doing);
  const auto properties = hdf5::creation_of(H5P_DATASET_CREATE);
  if (size > 0) {
    const auto chunk = std::min(size, chunk_size);
    checked(H5Pset_chunk(properties, 1, &chunk), doing);
    checked(H5Pset_fletcher32(properties), doing);
  }
  const Handle dataset(H5Dcreate2(file, name.c_str(), type, space, links, properties, H5P_DEFAULT),
                       H5Dclose, doing);
  if (size > 0)
    checked(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), doing);
}

/// Everything but the values, so that they can be read to where they belong.
struct StoredArray {
  Handle dataset, type;
  std::size_t size;

  StoredArray(hid_t parent, const std::string& name)
      : dataset(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose, "open " + name) {
    const Handle stored(H5Dget_type(dataset), H5Tclose, "open " + name);
    type = {H5Tget_native_type(stored, H5T_DIR_ASCEND), H5Tclose, "open " + name};
    const Handle space(H5Dget_space(dataset), H5Sclose, "open " + name);
    size =
        static_cast<std::size_t>(checked(H5Sget_simple_extent_npoints(space), "measure " + name));
  }

  void read(void* values, const std::string& name) const {
    if (size > 0)
      checked(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "read " + name);
  }
};

herr_t verify_object(hid_t root, const char* name, const H5O_info_t* object, void*) {
  if (object->type != H5O_TYPE_DATASET) return 0;
  try {
    const StoredArray array(root, name);
    std::vector<std::byte> values(array.size * H5Tget_size(array.type));
    array.read(values.data(), name);
    return 0;
  } catch (const hdf5::Failure&) {
    return -1;
  }
}

}  // namespace

struct ArchiveWriter::File {
  std::filesystem::path path;
  TemporaryFile temporary;
  Handle file;

  explicit File(const std::filesystem::path& final_path) : path(final_path), temporary(path) {
    hdf5::silence();
    try {
      // Every block of this format has a checksum.
      file = hdf5::create_committed(temporary.path(), H5F_LIBVER_V110);
      hdf5::write_attribute(file, format_attribute, format);
    } catch (const hdf5::Failure& failure) {
      throw failure.on(path);
    }
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (file.valid()) hdf5::abandon(file);
  }

  /// Runs `change`; when it fails, nothing of the file remains.
  template <class Change>
  void guarded(Change change) {
    if (!file.valid()) throw std::logic_error(path.string() + ": written to after it was closed");
    hdf5::silence();
    try {
      change();
    } catch (const hdf5::Failure& failure) {
      hdf5::abandon(file);
      file = Handle();
      throw failure.on(path);
    }
  }

  template <class T>
  void put(const std::string& name, std::span<const T> values) {
    guarded([&] { write(file, name, values); });
  }
};

ArchiveWriter::ArchiveWriter(const std::filesystem::path& path)
    : file_(std::make_unique<File>(path)) {}
ArchiveWriter::ArchiveWriter(ArchiveWriter&&) noexcept = default;
ArchiveWriter& ArchiveWriter::operator=(ArchiveWriter&&) noexcept = default;
ArchiveWriter::~ArchiveWriter() = default;

void ArchiveWriter::put(const std::string& name, std::span<const double> values) {
  file_->put(name, values);
}
void ArchiveWriter::put(const std::string& name, std::span<const float> values) {
  file_->put(name, values);
}
void ArchiveWriter::put(const std::string& name, std::span<const std::int32_t> values) {
  file_->put(name, values);
}
void ArchiveWriter::put(const std::string& name, std::span<const std::int64_t> values) {
  file_->put(name, values);
}
void ArchiveWriter::put(const std::string& name, std::span<const std::uint8_t> values) {
  file_->put(name, values);
}
void ArchiveWriter::put(const std::string& name, double value) {
  file_->put(name, std::span<const double>(&value, 1));
}
void ArchiveWriter::put(const std::string& name, std::int64_t value) {
  file_->put(name, std::span<const std::int64_t>(&value, 1));
}
void ArchiveWriter::put(const std::string& name, std::string_view text) {
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  file_->put(name, std::span<const std::uint8_t>(bytes));
}

void ArchiveWriter::finish() {
  file_->guarded([&] {
    hdf5::flush(file_->file);
    hdf5::sync(file_->file);
  });
  file_->file = Handle();
}

void ArchiveWriter::commit() {
  if (file_->file.valid()) finish();
  file_->temporary.publish(Durable::yes);
}

struct ArchiveReader::File {
  std::filesystem::path path;
  Handle file;

  explicit File(const std::filesystem::path& given) : path(given) {
    hdf5::silence();
    if (!std::filesystem::exists(path)) throw OutputError(path, "does not exist", "check the path");
    if (H5Fis_hdf5(path.c_str()) <= 0)
      throw OutputError(path, "is not a checkpoint (no HDF5 file)", foreign_remedy);
    try {
      file = {H5Fopen(path.c_str(), H5F_ACC_RDONLY, reading_unlocked()), H5Fclose, "open it"};
      if (checked(H5Aexists(file, format_attribute), "read it") == 0)
        throw OutputError(path, "is not a checkpoint (no format number)", foreign_remedy);
      require_format(hdf5::read_attribute(file, format_attribute));
    } catch (const hdf5::Failure& failure) {
      throw damaged(failure);
    }
  }

  void require_format(int found) const {
    if (found > format)
      throw OutputError(path, fmt::format("has format {}, this program reads {}", found, format),
                        "use the program that wrote it, or a later one");
  }

  OutputError damaged(const hdf5::Failure& failure) const {
    return {path, fmt::format("is damaged: cannot {} ({})", failure.doing, failure.reason),
            damaged_remedy};
  }

  template <class T>
  StoredArray find(const std::string& name) const {
    if (!has(name)) throw OutputError(path, fmt::format("has no '{}'", name), foreign_remedy);
    StoredArray array(file, name);
    if (H5Tequal(array.type, hdf5::type_of<T>()) <= 0)
      throw OutputError(path, fmt::format("holds '{}' in another type", name), foreign_remedy);
    return array;
  }

  /// HDF5 answers for the last part of a path only, and fails when an earlier one is missing.
  bool has(const std::string& name) const {
    for (auto slash = name.find('/'); slash != name.npos; slash = name.find('/', slash + 1))
      if (!hdf5::exists(file, name.substr(0, slash))) return false;
    return hdf5::exists(file, name);
  }

  template <class Action>
  auto reading(Action action) const {
    hdf5::silence();
    try {
      return action();
    } catch (const hdf5::Failure& failure) {
      throw damaged(failure);
    }
  }
};

ArchiveReader::ArchiveReader(const std::filesystem::path& path)
    : file_(std::make_unique<File>(path)) {}
ArchiveReader::ArchiveReader(ArchiveReader&&) noexcept = default;
ArchiveReader& ArchiveReader::operator=(ArchiveReader&&) noexcept = default;
ArchiveReader::~ArchiveReader() = default;

const std::filesystem::path& ArchiveReader::path() const { return file_->path; }

bool ArchiveReader::has(const std::string& name) const {
  return file_->reading([&] { return file_->has(name); });
}

std::vector<std::string> ArchiveReader::names(const std::string& group) const {
  return file_->reading([&] {
    if (!file_->has(group)) return std::vector<std::string>();
    return hdf5::names(hdf5::open_group(file_->file, group));
  });
}

template <class T>
std::vector<T> ArchiveReader::get(const std::string& name) const {
  return file_->reading([&] {
    const auto array = file_->template find<T>(name);
    std::vector<T> values(array.size);
    array.read(values.data(), name);
    return values;
  });
}

template <class T>
void ArchiveReader::read(const std::string& name, std::span<T> values) const {
  file_->reading([&] {
    const auto array = file_->template find<T>(name);
    if (array.size != values.size())
      throw OutputError(file_->path,
                        fmt::format("holds {} entries of '{}' where {} are expected", array.size,
                                    name, values.size()),
                        foreign_remedy);
    array.read(values.data(), name);
  });
}

template <class T>
T ArchiveReader::scalar(const std::string& name) const {
  T value = {};
  read(name, std::span<T>(&value, 1));
  return value;
}

std::string ArchiveReader::text(const std::string& name) const {
  const auto bytes = get<std::uint8_t>(name);
  return {bytes.begin(), bytes.end()};
}

void ArchiveReader::verify() const {
  file_->reading([&] {
    checked(H5Ovisit(file_->file, H5_INDEX_NAME, H5_ITER_INC, verify_object, nullptr),
            "read all of it");
  });
}

template std::vector<double> ArchiveReader::get(const std::string&) const;
template std::vector<float> ArchiveReader::get(const std::string&) const;
template std::vector<std::int32_t> ArchiveReader::get(const std::string&) const;
template std::vector<std::int64_t> ArchiveReader::get(const std::string&) const;
template std::vector<std::uint8_t> ArchiveReader::get(const std::string&) const;
template void ArchiveReader::read(const std::string&, std::span<double>) const;
template void ArchiveReader::read(const std::string&, std::span<float>) const;
template void ArchiveReader::read(const std::string&, std::span<std::int32_t>) const;
template void ArchiveReader::read(const std::string&, std::span<std::int64_t>) const;
template void ArchiveReader::read(const std::string&, std::span<std::uint8_t>) const;
template double ArchiveReader::scalar(const std::string&) const;
template std::int64_t ArchiveReader::scalar(const std::string&) const;

}  // namespace pliant
