#include "engine/output/hdf5/hdf5.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <system_error>

namespace pliant::hdf5 {
namespace {

/// HDF5 reports the error number of a failed system call only in the text of its error stack.
herr_t look_for_reason(unsigned, const H5E_error2_t* entry, void* target) {
  auto& failure = *static_cast<Failure*>(target);
  const std::string_view text = entry->desc ? entry->desc : "";
  if (failure.reason.empty()) failure.reason = text;
  constexpr std::string_view marker = "errno = ";
  if (const auto found = text.find(marker); found != text.npos)
    std::sscanf(text.data() + found + marker.size(), "%d", &failure.error_number);
  return 0;
}

Failure last_failure(std::string_view doing) {
  Failure failure{.doing = std::string(doing), .reason = {}, .error_number = 0};
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, look_for_reason, &failure);
  H5Eclear2(H5E_DEFAULT);
  if (failure.error_number != 0)
    failure.reason = std::generic_category().message(failure.error_number);
  return failure;
}

Handle text_type(std::string_view text) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "describe text");
  checked(H5Tset_size(type, std::max<std::size_t>(text.size(), 1)), "describe text");
  checked(H5Tset_strpad(type, H5T_STR_NULLPAD), "describe text");
  checked(H5Tset_cset(type, H5T_CSET_UTF8), "describe text");
  return type;
}

/// A zero-padded text of fixed length with the type `type`, as `read` returns it.
template <class Read>
std::string fixed_text(hid_t type, const std::string& doing, Read read) {
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0)
    throw Failure{.doing = doing, .reason = "it is no text of fixed length", .error_number = 0};
  std::string text(H5Tget_size(type), '\0');
  checked(read(text.data()), doing);
  text.resize(text.find_last_not_of('\0') + 1);
  return text;
}

Handle scalar_space() { return {H5Screate(H5S_SCALAR), H5Sclose, "describe a scalar"}; }

void create_attribute(hid_t object, const std::string& name, hid_t type, hid_t space,
                      const void* value) {
  const auto doing = "write attribute " + name;
  const Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose, doing);
  checked(H5Awrite(attribute, type, value), doing);
}

herr_t add_name(hid_t, const char* name, const H5L_info_t*, void* target) {
  static_cast<std::vector<std::string>*>(target)->emplace_back(name);
  return 0;
}

}  // namespace

Failure Failure::system(std::string doing, int error_number) {
  return {std::move(doing), std::generic_category().message(error_number), error_number};
}

OutputError Failure::on(const std::filesystem::path& path) const {
  return {path, fmt::format("cannot {}: {}", doing, reason), remedy_for(error_number)};
}

hid_t checked(hid_t returned, std::string_view doing) {
  if (returned < 0) throw last_failure(doing);
  return returned;
}

void silence() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

Handle creation_of(hid_t property_class) {
  Handle properties(H5Pcreate(property_class), H5Pclose, "describe an object");
  checked(H5Pset_obj_track_times(properties, false), "leave time stamps out");
  return properties;
}

bool exists(hid_t parent, const std::string& name) {
  return checked(H5Lexists(parent, name.c_str(), H5P_DEFAULT), "look for " + name) > 0;
}

std::vector<std::string> names(hid_t group) {
  std::vector<std::string> found;
  checked(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, add_name, &found), "list a group");
  return found;
}

Handle create_group(hid_t parent, const std::string& name) {
  const auto properties = creation_of(H5P_GROUP_CREATE);
  return {H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT), H5Gclose,
          "create " + name};
}

Handle open_group(hid_t parent, const std::string& name) {
  return {H5Gopen2(parent, name.c_str(), H5P_DEFAULT), H5Gclose, "open " + name};
}

void write_attribute(hid_t object, const std::string& name, std::string_view text) {
  create_attribute(object, name, text_type(text), scalar_space(), text.empty() ? "" : text.data());
}

void write_attribute(hid_t object, const std::string& name, const std::vector<int>& values) {
  const hsize_t size = values.size();
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose, "describe an attribute");
  create_attribute(object, name, H5T_NATIVE_INT, space, values.data());
}

void write_attribute(hid_t object, const std::string& name, int value) {
  create_attribute(object, name, H5T_NATIVE_INT, scalar_space(), &value);
}

void overwrite_attribute(hid_t object, const std::string& name, int value) {
  const auto doing = "write attribute " + name;
  const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, doing);
  checked(H5Awrite(attribute, H5T_NATIVE_INT, &value), doing);
}

int read_attribute(hid_t object, const std::string& name) {
  const auto doing = "read attribute " + name;
  const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, doing);
  int value = 0;
  checked(H5Aread(attribute, H5T_NATIVE_INT, &value), doing);
  return value;
}

bool has_attribute(hid_t object, const std::string& name) {
  return checked(H5Aexists(object, name.c_str()), "look for attribute " + name) > 0;
}

std::string read_text_attribute(hid_t object, const std::string& name) {
  const auto doing = "read attribute " + name;
  const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, doing);
  const Handle type(H5Aget_type(attribute), H5Tclose, doing);
  return fixed_text(type, doing, [&](char* text) { return H5Aread(attribute, type, text); });
}

std::string read_text(hid_t parent, const std::string& name) {
  const auto doing = "read " + name;
  const Handle dataset(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose, doing);
  const Handle type(H5Dget_type(dataset), H5Tclose, doing);
  return fixed_text(type, doing, [&](char* text) {
    return H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text);
  });
}

void write_text(hid_t parent, const std::string& name, std::string_view text) {
  const auto doing = "write " + name;
  const auto type = text_type(text);
  const Handle dataset(H5Dcreate2(parent, name.c_str(), type, scalar_space(), H5P_DEFAULT,
                                  creation_of(H5P_DATASET_CREATE), H5P_DEFAULT),
                       H5Dclose, doing);
  const auto* begin = text.empty() ? "" : text.data();
  checked(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, begin), doing);
}

GrowingArray GrowingArray::create(hid_t parent, const std::string& name, hid_t type, int components,
                                  hsize_t chunk_rows) {
  const auto doing = "create " + name;
  const int rank = components > 0 ? 2 : 1;
  const auto width = static_cast<hsize_t>(components);
  const std::array<hsize_t, 2> none = {0, width}, most = {H5S_UNLIMITED, width},
                               chunk = {chunk_rows, width};
  const Handle space(H5Screate_simple(rank, none.data(), most.data()), H5Sclose, doing);
  const auto properties = creation_of(H5P_DATASET_CREATE);
  checked(H5Pset_chunk(properties, rank, chunk.data()), doing);
  return GrowingArray(
      name, {H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT),
             H5Dclose, doing});
}

GrowingArray GrowingArray::open(hid_t parent, const std::string& name) {
  return GrowingArray(name,
                      {H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose, "open " + name});
}

std::vector<hsize_t> GrowingArray::shape() const {
  const Handle space(H5Dget_space(dataset_), H5Sclose, "measure " + name_);
  std::vector<hsize_t> shape(
      static_cast<std::size_t>(checked(H5Sget_simple_extent_ndims(space), "measure " + name_)));
  checked(H5Sget_simple_extent_dims(space, shape.data(), nullptr), "measure " + name_);
  return shape;
}

hsize_t GrowingArray::rows() const { return shape()[0]; }

int GrowingArray::components() const {
  const auto size = shape();
  return size.size() > 1 ? static_cast<int>(size[1]) : 0;
}

Handle GrowingArray::type() const {
  const Handle stored(H5Dget_type(dataset_), H5Tclose, "open " + name_);
  return {H5Tget_native_type(stored, H5T_DIR_ASCEND), H5Tclose, "open " + name_};
}

void GrowingArray::append(const void* values, hid_t type, hsize_t count) {
  if (count == 0) return;
  const auto doing = "write " + name_;
  auto size = shape();
  std::vector<hsize_t> first(size.size(), 0), part = size;
  first[0] = size[0];
  part[0] = count;
  size[0] += count;
  checked(H5Dset_extent(dataset_, size.data()), doing);
  const Handle in_file(H5Dget_space(dataset_), H5Sclose, doing);
  checked(H5Sselect_hyperslab(in_file, H5S_SELECT_SET, first.data(), nullptr, part.data(), nullptr),
          doing);
  const auto rank = static_cast<int>(part.size());
  const Handle in_memory(H5Screate_simple(rank, part.data(), nullptr), H5Sclose, doing);
  checked(H5Dwrite(dataset_, type, in_memory, in_file, H5P_DEFAULT, values), doing);
}

void GrowingArray::truncate(hsize_t rows) {
  auto size = shape();
  size[0] = std::min(size[0], rows);
  checked(H5Dset_extent(dataset_, size.data()), "shorten " + name_);
}

void GrowingArray::read(void* values) const {
  checked(H5Dread(dataset_, type(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "read " + name_);
}

void GrowingArray::read(void* values, hid_t type, hsize_t first, hsize_t count) const {
  const auto doing = "read " + name_;
  auto size = shape();
  if (first > size[0] || count > size[0] - first)
    throw Failure{.doing = doing, .reason = "it has too few rows", .error_number = 0};
  if (count == 0) return;
  std::vector<hsize_t> start(size.size(), 0);
  start[0] = first;
  size[0] = count;
  const Handle in_file(H5Dget_space(dataset_), H5Sclose, doing);
  checked(H5Sselect_hyperslab(in_file, H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr),
          doing);
  const Handle in_memory(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr),
                         H5Sclose, doing);
  checked(H5Dread(dataset_, type, in_memory, in_file, H5P_DEFAULT, values), doing);
}

std::vector<double> read_column(hid_t parent, const std::string& name) {
  const auto array = GrowingArray::open(parent, name);
  std::vector<double> values(array.rows());
  array.read(values.data(), 0, values.size());
  return values;
}

}  // namespace pliant::hdf5
