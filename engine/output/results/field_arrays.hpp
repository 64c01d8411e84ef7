#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "engine/output/hdf5/hdf5.hpp"
#include "engine/output/results/frame.hpp"

namespace pliant {

/// A field as stored in the file.
struct StoredField {
  std::string name;
  int components;
  bool integer;
  int bytes;  ///< of one component
};

/// Rows in a chunk of fields whose first frame has `rows` rows. The chunk of the largest field must
/// fit into HDF5's cache of 1 MiB.
inline hsize_t chunk_rows_for(std::size_t rows) { return std::clamp<hsize_t>(rows, 1024, 16384); }

/// Rows in a chunk of arrays with one row for each frame.
inline constexpr hsize_t frame_chunk_rows = 256;

StoredField describe(const std::string& name, const hdf5::GrowingArray& array);

/// Throws std::invalid_argument if a field does not have `rows` values, or has a name that HDF5
/// cannot use.
void check_fields(const std::vector<FrameField>& fields, std::size_t rows);

/// Datasets of one group, one for each field, that grow together: [row] or [row][component], with
/// the attribute `unit`. Real numbers have `real_bytes` bytes. Vectors in 2D get a third component.
/// Throws hdf5::Failure.
class FieldArrays {
 public:
  void create(hid_t group, const std::vector<FrameField>& fields, int real_bytes,
              hsize_t chunk_rows);
  void open(hid_t group);

  /// Throws std::invalid_argument if `fields` differ from those of the file.
  void append(const std::vector<FrameField>& fields, hsize_t rows);
  void truncate(hsize_t rows);

  const std::vector<StoredField>& fields() const { return fields_; }  ///< in alphabetical order

 private:
  void require_same(const std::vector<const FrameField*>& sorted) const;

  std::vector<StoredField> fields_;
  std::vector<hdf5::GrowingArray> values_;  ///< [field] of fields_
};

}  // namespace pliant
