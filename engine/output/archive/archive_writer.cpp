#include <algorithm>
#include <stdexcept>

#include "engine/output/archive/archive.hpp"
#include "engine/output/archive/archive_format.hpp"
#include "engine/output/atomic_file.hpp"
#include "engine/output/hdf5/commit_driver.hpp"
#include "engine/output/hdf5/hdf5.hpp"

namespace pliant {
namespace {

using hdf5::checked;
using hdf5::Handle;

constexpr hsize_t chunk_size = 131072;  ///< entries for each checksum

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

}  // namespace

struct ArchiveWriter::File {
  std::filesystem::path path;
  TemporaryFile temporary;
  Handle file;

  explicit File(const std::filesystem::path& final_path) : path(final_path), temporary(path) {
    hdf5::silence();
    try {
      // in this format, every block has a checksum
      file = hdf5::create_committed(temporary.path(), H5F_LIBVER_V110);
      hdf5::write_attribute(file, archive::format_attribute, archive::format);
    } catch (const hdf5::Failure& failure) {
      throw failure.on(path);
    }
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (file.valid()) hdf5::abandon(file);
  }

  /// Runs `change`; if it fails, the file is removed.
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

}  // namespace pliant
