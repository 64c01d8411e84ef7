#include "engine/output/results/history_store.hpp"

#include <stdexcept>

namespace pliant {
namespace {

constexpr auto group_name = "measurements";
constexpr hsize_t chunk_rows = 512;

}  // namespace

HistoryStore::HistoryStore(hid_t file) {
  if (!hdf5::exists(file, group_name)) {
    group_ = hdf5::create_group(file, group_name);
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

}  // namespace pliant
