#include <fmt/format.h>

#include "engine/output/archive/archive.hpp"
#include "engine/output/archive/archive_format.hpp"
#include "engine/output/error.hpp"
#include "engine/output/hdf5/hdf5.hpp"

namespace pliant {
namespace {

using hdf5::checked;
using hdf5::Handle;

constexpr auto damaged_remedy = "use the checkpoint before it, or run without --resume";
constexpr auto foreign_remedy =
    "give a checkpoint that this program wrote, or run without --resume";

Handle reading_unlocked() {
  Handle properties(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "describe access");
  checked(H5Pset_file_locking(properties, false, true), "leave the file unlocked");
  return properties;
}

/// An array without its values, which can then be read directly into their destination.
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
      if (checked(H5Aexists(file, archive::format_attribute), "read it") == 0)
        throw OutputError(path, "is not a checkpoint (no format number)", foreign_remedy);
      require_format(hdf5::read_attribute(file, archive::format_attribute));
    } catch (const hdf5::Failure& failure) {
      throw damaged(failure);
    }
  }

  void require_format(int found) const {
    if (found != archive::format)
      throw OutputError(
          path, fmt::format("has format {}, and this program reads {}", found, archive::format),
          "continue with the version of pliant that wrote it, or run without --resume");
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

  /// HDF5 checks only the last part of a path, and fails if an earlier part is missing.
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
