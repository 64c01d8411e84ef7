#include "tests/engine/output/file_content.hpp"

// Later versions of HDF5 offer the functions of 1.10 under this name.
#define H5_USE_110_API
#include <hdf5.h>

namespace pliant::test {
namespace {

hid_t require(hid_t id) {
  if (id < 0) throw std::runtime_error("HDF5 cannot read this");
  return id;
}

std::vector<std::uint64_t> shape_of(hid_t space) {
  std::vector<hsize_t> shape(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
  H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  return {shape.begin(), shape.end()};
}

std::size_t size_of(hid_t space, hid_t type) {
  return static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)) * H5Tget_size(type);
}

void add_dataset(FileContent& content, const std::string& path, hid_t dataset) {
  const hid_t space = require(H5Dget_space(dataset)), type = require(H5Dget_type(dataset));
  auto& entry = content[path];
  entry.shape = shape_of(space);
  entry.bytes.resize(size_of(space, type));
  if (!entry.bytes.empty())
    require(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, entry.bytes.data()));
  H5Tclose(type);
  H5Sclose(space);
}

void add_attributes(FileContent& content, const std::string& path, hid_t object) {
  H5O_info_t about;
  require(H5Oget_info(object, &about));
  for (hsize_t i = 0; i < about.num_attrs; ++i) {
    const hid_t attribute = require(
        H5Aopen_by_idx(object, ".", H5_INDEX_NAME, H5_ITER_INC, i, H5P_DEFAULT, H5P_DEFAULT));
    const hid_t space = H5Aget_space(attribute), type = H5Aget_type(attribute);
    char name[256];
    H5Aget_name(attribute, sizeof name, name);
    auto& entry = content[path + "@" + name];
    entry.shape = shape_of(space);
    entry.bytes.resize(size_of(space, type));
    require(H5Aread(attribute, type, entry.bytes.data()));
    H5Tclose(type);
    H5Sclose(space);
    H5Aclose(attribute);
  }
}

void add_object(FileContent& content, const std::string& path, hid_t object) {
  add_attributes(content, path, object);
  if (H5Iget_type(object) == H5I_DATASET) return add_dataset(content, path, object);
  H5G_info_t about;
  require(H5Gget_info(object, &about));
  for (hsize_t i = 0; i < about.nlinks; ++i) {
    char name[256];
    H5Lget_name_by_idx(object, ".", H5_INDEX_NAME, H5_ITER_INC, i, name, sizeof name, H5P_DEFAULT);
    const hid_t child = require(H5Oopen(object, name, H5P_DEFAULT));
    add_object(content, path + "/" + name, child);
    H5Oclose(child);
  }
}

}  // namespace

FileContent content_of(const std::filesystem::path& path) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const hid_t file = require(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
  const hid_t root = require(H5Gopen2(file, "/", H5P_DEFAULT));
  FileContent content;
  add_object(content, "", root);
  H5Gclose(root);
  H5Fclose(file);
  return content;
}

std::vector<std::string> differences(const FileContent& a, const FileContent& b) {
  std::vector<std::string> paths;
  for (const auto& [path, entry] : a)
    if (!b.contains(path) || b.at(path) != entry) paths.push_back(path);
  for (const auto& [path, entry] : b)
    if (!a.contains(path)) paths.push_back(path);
  return paths;
}

}  // namespace pliant::test
