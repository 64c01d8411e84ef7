#include "engine/output/results/field_arrays.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace pliant {
namespace {

using hdf5::GrowingArray;

int stored_components(const FrameField& field) {
  return field.components == 2 ? 3 : field.components;
}

hid_t type_of(const FrameField& field) {
  return std::visit([]<class T>(const std::vector<T>&) { return hdf5::type_of<T>(); },
                    field.values);
}

bool is_integer(hid_t type) { return H5Tget_class(type) == H5T_INTEGER; }

template <class T>
std::vector<T> with_third_component(const std::vector<T>& plane) {
  std::vector<T> values(plane.size() / 2 * 3, T(0));
  for (std::size_t p = 0; p < plane.size() / 2; ++p) {
    values[3 * p] = plane[2 * p];
    values[3 * p + 1] = plane[2 * p + 1];
  }
  return values;
}

void append_values(GrowingArray& array, const FrameField& field, hsize_t rows) {
  std::visit(
      [&](const auto& values) {
        if (field.components == 2)
          array.append(with_third_component(values).data(), rows);
        else
          array.append(values.data(), rows);
      },
      field.values);
}

std::vector<const FrameField*> sorted_by_name(const std::vector<FrameField>& fields) {
  std::vector<const FrameField*> sorted;
  sorted.reserve(fields.size());
  for (const auto& field : fields) sorted.push_back(&field);
  std::ranges::sort(sorted, {}, &FrameField::name);
  return sorted;
}

}  // namespace

StoredField describe(const std::string& name, const GrowingArray& array) {
  const auto type = array.type();
  return {name, std::max(array.components(), 1), is_integer(type),
          static_cast<int>(H5Tget_size(type))};
}

void check_fields(const std::vector<FrameField>& fields, std::size_t rows) {
  for (const auto& field : fields) {
    const auto size = std::visit([](const auto& values) { return values.size(); }, field.values);
    if (field.components < 1 || size != rows * static_cast<std::size_t>(field.components))
      throw std::invalid_argument(
          fmt::format("field {} has {} values for {} points", field.name, size, rows));
    if (field.name.empty() || field.name.find_first_of("/.") != std::string::npos)
      throw std::invalid_argument(
          fmt::format("field name '{}' is empty or contains '/' or '.'", field.name));
  }
}

void FieldArrays::create(hid_t group, const std::vector<FrameField>& fields, int real_bytes,
                         hsize_t chunk_rows) {
  for (const auto* field : sorted_by_name(fields)) {
    const auto components = stored_components(*field);
    const auto given = type_of(*field),
               type = is_integer(given) ? given : hdf5::real_type(real_bytes);
    values_.push_back(GrowingArray::create(group, field->name, type,
                                           components == 1 ? 0 : components, chunk_rows));
    hdf5::write_attribute(values_.back().id(), "unit", field->unit);
    fields_.push_back(describe(field->name, values_.back()));
  }
}

void FieldArrays::open(hid_t group) {
  for (const auto& name : hdf5::names(group)) {
    values_.push_back(GrowingArray::open(group, name));
    fields_.push_back(describe(name, values_.back()));
  }
}

void FieldArrays::require_same(const std::vector<const FrameField*>& sorted) const {
  const auto same = [](const FrameField* given, const StoredField& stored) {
    const auto type = type_of(*given);
    return given->name == stored.name && stored_components(*given) == stored.components &&
           is_integer(type) == stored.integer &&
           (!stored.integer || static_cast<int>(H5Tget_size(type)) == stored.bytes);
  };
  if (!std::ranges::equal(sorted, fields_, same))
    throw std::invalid_argument("a frame has other fields than the earlier ones");
}

void FieldArrays::append(const std::vector<FrameField>& fields, hsize_t rows) {
  const auto sorted = sorted_by_name(fields);
  require_same(sorted);
  for (std::size_t i = 0; i < sorted.size(); ++i) append_values(values_[i], *sorted[i], rows);
}

void FieldArrays::truncate(hsize_t rows) {
  for (auto& array : values_) array.truncate(rows);
}

}  // namespace pliant
