#pragma once

#include <hdf5.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/output/error.hpp"

/// The part of HDF5 that results and checkpoints need, with owners for its identifiers.
namespace pliant::hdf5 {

/// Why a call failed. Classes that own a file convert it to an OutputError with the name of the
/// file.
struct Failure {
  std::string doing;   ///< "write Points"
  std::string reason;  ///< text of the operating system, or else of HDF5
  int error_number = 0;

  static Failure system(std::string doing, int error_number);
  OutputError on(const std::filesystem::path& path) const;
};

/// Returns what an HDF5 call returned; throws Failure if that is negative.
hid_t checked(hid_t returned, std::string_view doing);

/// Stops HDF5 from printing its error stack; needed once for each thread. Exceptions contain it.
void silence();

/// Owns an HDF5 identifier and closes it.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);

  Handle() = default;
  /// Takes ownership of `id`; throws Failure if it is negative.
  Handle(hid_t id, Close close, std::string_view doing) : id_(checked(id, doing)), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }
  bool valid() const { return id_ >= 0; }

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// The HDF5 type of a C++ type.
template <class T>
hid_t type_of();
template <>
inline hid_t type_of<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
inline hid_t type_of<float>() {
  return H5T_NATIVE_FLOAT;
}
template <>
inline hid_t type_of<std::int32_t>() {
  return H5T_NATIVE_INT32;
}
template <>
inline hid_t type_of<std::int64_t>() {
  return H5T_NATIVE_INT64;
}
template <>
inline hid_t type_of<std::uint8_t>() {
  return H5T_NATIVE_UINT8;
}

/// A real number in a file: `bytes` is 4 or 8.
inline hid_t real_type(int bytes) { return bytes == 4 ? type_of<float>() : type_of<double>(); }

/// Properties of an object without time stamps, so that equal runs write equal files.
Handle creation_of(hid_t property_class);

bool exists(hid_t parent, const std::string& name);
std::vector<std::string> names(hid_t group);  ///< in alphabetical order

Handle create_group(hid_t parent, const std::string& name);
Handle open_group(hid_t parent, const std::string& name);

void write_attribute(hid_t object, const std::string& name, std::string_view text);
void write_attribute(hid_t object, const std::string& name, const std::vector<int>& values);
void write_attribute(hid_t object, const std::string& name, int value);
void overwrite_attribute(hid_t object, const std::string& name, int value);
int read_attribute(hid_t object, const std::string& name);

bool has_attribute(hid_t object, const std::string& name);
std::string read_text_attribute(hid_t object, const std::string& name);

/// A scalar dataset of text.
std::string read_text(hid_t parent, const std::string& name);
void write_text(hid_t parent, const std::string& name, std::string_view text);

/// Rows of equal size that grow at the end: [row] or [row][component].
class GrowingArray {
 public:
  GrowingArray() = default;
  /// `components` = 0 makes a plain [row].
  static GrowingArray create(hid_t parent, const std::string& name, hid_t type, int components,
                             hsize_t chunk_rows);
  static GrowingArray open(hid_t parent, const std::string& name);

  hsize_t rows() const;
  int components() const;  ///< 0 for a plain [row]
  Handle type() const;
  hid_t id() const { return dataset_; }
  bool valid() const { return dataset_.valid(); }

  /// Values are converted to the type of the array.
  template <class T>
  void append(const T* values, hsize_t count) {
    append(values, type_of<T>(), count);
  }
  void truncate(hsize_t rows);
  void read(void* values) const;  ///< all rows
  /// Rows [first, first + count), converted. Throws Failure if there are fewer.
  template <class T>
  void read(T* values, hsize_t first, hsize_t count) const {
    read(values, type_of<T>(), first, count);
  }

 private:
  explicit GrowingArray(std::string name, Handle dataset)
      : name_(std::move(name)), dataset_(std::move(dataset)) {}
  std::vector<hsize_t> shape() const;
  void append(const void* values, hid_t type, hsize_t count);
  void read(void* values, hid_t type, hsize_t first, hsize_t count) const;

  std::string name_;
  Handle dataset_;
};

/// All values of a plain [row]. Throws Failure.
std::vector<double> read_column(hid_t parent, const std::string& name);

}  // namespace pliant::hdf5
