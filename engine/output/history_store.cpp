#include "engine/output/history_store.hpp"

#include <stdexcept>

namespace pliant {
namespace {

constexpr auto group_name = "measurements";
constexpr hsize_t chunk_rows = 512;

/// Room in the group's header for so many links: adding one then rewrites the header in place,
/// which a dying process does whole or not at all.
constexpr unsigned expected_histories = 64, expected_name_length = 48;

hdf5::Handle create_roomy_group(hid_t file) {
  const auto properties = hdf5::creation_of(H5P_GROUP_CREATE);
  hdf5::checked(H5Pset_est_link_info(properties, expected_histories, expected_name_length),
                "create measurements");
  hdf5::checked(H5Pset_link_phase_change(properties, expected_histories, 0), "create measurements");
  return {H5Gcreate2(file, group_name, H5P_DEFAULT, properties, H5P_DEFAULT), H5Gclose,
          "create measurements"};
}

}  // namespace

HistoryStore::HistoryStore(hid_t file) {
  if (!hdf5::exists(file, group_name)) {
    group_ = create_roomy_group(file);
    return;
  }
  group_ = hdf5::open_group(file, group_name);
  for (const auto& name : hdf5::names(group_)) {
    auto& history = histories_[name];
    history.stored_time = hdf5::GrowingArray::open(group_, name + "/time");
    history.stored_value = hdf5::GrowingArray::open(group_, name + "/value");
    history.stored = static_cast<std::int64_t>(history.stored_value.rows());
  }
}

void HistoryStore::append(const std::string& name, const std::string& unit, double time,
                          double value) {
  if (name.empty() || name.find_first_of("/.") != std::string::npos)
    throw std::invalid_argument("measurement name '" + name + "' is empty or contains '/' or '.'");
  auto& history = histories_[name];
  history.unit = unit;
  history.time.push_back(time);
  history.value.push_back(value);
}

void HistoryStore::create(const std::string& name, History& history) {
  const auto group = hdf5::create_group(group_, name);
  history.stored_time = hdf5::GrowingArray::create(group, "time", H5T_NATIVE_DOUBLE, 0, chunk_rows);
  hdf5::write_attribute(history.stored_time.id(), "unit", "s");
  history.stored_value =
      hdf5::GrowingArray::create(group, "value", H5T_NATIVE_DOUBLE, 0, chunk_rows);
  hdf5::write_attribute(history.stored_value.id(), "unit", history.unit);
}

void HistoryStore::flush() {
  for (auto& [name, history] : histories_) {
    if (history.value.empty()) continue;
    if (!history.stored_value.valid()) create(name, history);
    history.stored_time.append(history.time.data(), history.time.size());
    history.stored_value.append(history.value.data(), history.value.size());
    history.stored += static_cast<std::int64_t>(history.value.size());
    history.time.clear();
    history.value.clear();
  }
}

void HistoryStore::truncate(const std::map<std::string, std::int64_t>& rows) {
  for (auto history = histories_.begin(); history != histories_.end();) {
    const auto kept = rows.find(history->first);
    if (kept == rows.end() || kept->second == 0) {
      hdf5::checked(H5Ldelete(group_, history->first.c_str(), H5P_DEFAULT), "shorten measurements");
      history = histories_.erase(history);
      continue;
    }
    const auto count = std::min(kept->second, history->second.stored);
    history->second.stored_time.truncate(static_cast<hsize_t>(count));
    history->second.stored_value.truncate(static_cast<hsize_t>(count));
    history->second.stored = count;
    ++history;
  }
}

std::map<std::string, std::int64_t> HistoryStore::rows() const {
  std::map<std::string, std::int64_t> rows;
  for (const auto& [name, history] : histories_)
    rows[name] = history.stored + static_cast<std::int64_t>(history.value.size());
  return rows;
}

std::uint64_t HistoryStore::bytes_held_back() const {
  std::uint64_t bytes = 0;
  for (const auto& [name, history] : histories_)
    bytes += 2 * sizeof(double) * (history.value.size() + chunk_rows);
  return bytes;
}

}  // namespace pliant
