#include "engine/batch/ledger.hpp"

#include <array>
#include <chrono>

namespace pliant::batch {

namespace {

constexpr auto file_name = "batch.sqlite";

constexpr std::array<std::string_view, 4> words = {"pending", "running", "done", "failed"};

// Write-ahead logging allows `pliant batch status` to read while the batch writes. If a loss of
// power reverts a commit, a run only has to be checked again.
constexpr auto schema = R"(
PRAGMA journal_mode = WAL;
PRAGMA synchronous = NORMAL;
BEGIN IMMEDIATE;
CREATE TABLE IF NOT EXISTS batch (key TEXT PRIMARY KEY, value TEXT);
CREATE TABLE IF NOT EXISTS run (
  name TEXT PRIMARY KEY, status TEXT NOT NULL DEFAULT 'pending', attempts INTEGER NOT NULL DEFAULT 0,
  exit_status INTEGER, message TEXT NOT NULL DEFAULT '', started REAL, ended REAL,
  wall_seconds REAL, processor_seconds REAL, peak_memory INTEGER);
CREATE TABLE IF NOT EXISTS parameter (
  run TEXT REFERENCES run, key TEXT, value TEXT, PRIMARY KEY (run, key));
CREATE TABLE IF NOT EXISTS measurement (
  run TEXT REFERENCES run, name TEXT, unit TEXT, value REAL, PRIMARY KEY (run, name));
CREATE TABLE IF NOT EXISTS version (
  run TEXT REFERENCES run, name TEXT, version TEXT, PRIMARY KEY (run, name));
COMMIT;
)";

}  // namespace

double now() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

RunStatus status_of(std::string_view word) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == word) return static_cast<RunStatus>(i);
  }
  return RunStatus::pending;
}

std::string_view word_of(RunStatus status) { return words[static_cast<std::size_t>(status)]; }

bool Ledger::exists(const std::filesystem::path& folder) {
  std::error_code unreadable;
  return std::filesystem::exists(folder / file_name, unreadable);
}

Ledger::Ledger(const std::filesystem::path& folder, Use use)
    : database_(folder / file_name,
                use == Use::write ? Database::Mode::create : Database::Mode::read) {
  if (use == Use::write) database_.execute(schema);
}

void Ledger::set(std::string_view key, std::string_view value) {
  database_.prepare("INSERT OR REPLACE INTO batch VALUES (?, ?)").bind(key).bind(value).run();
}

std::optional<std::string> Ledger::get(std::string_view key) {
  Statement select = database_.prepare("SELECT value FROM batch WHERE key = ?");
  return select.bind(key).next() ? std::optional(select.text(0)) : std::nullopt;
}

void Ledger::add(const std::vector<Assignment>& runs) {
  Transaction transaction(database_);
  for (const Assignment& run : runs) {
    const std::string name = name_of(run);
    database_.prepare("INSERT OR IGNORE INTO run (name) VALUES (?)").bind(name).run();
    for (const auto& [key, value] : run) {
      database_.prepare("INSERT OR IGNORE INTO parameter VALUES (?, ?, ?)")
          .bind(name)
          .bind(key)
          .bind(value)
          .run();
    }
  }
  transaction.commit();
}

void Ledger::reset_running() {
  database_.execute("UPDATE run SET status = 'pending' WHERE status = 'running'");
}

void Ledger::start(const std::string& run) {
  database_
      .prepare(
          "UPDATE run SET status = 'running', attempts = attempts + 1, started = ?, "
          "ended = NULL WHERE name = ?")
      .bind(now())
      .bind(run)
      .run();
}

void Ledger::end(const std::string& run, RunStatus status, const Outcome& outcome) {
  Transaction transaction(database_);
  put_end(run, status, now(), outcome);
  transaction.commit();
}

void Ledger::put(const RunRow& row) {
  Transaction transaction(database_);
  database_.prepare("UPDATE run SET attempts = ?, started = ? WHERE name = ?")
      .bind(row.attempts)
      .bind(row.started)
      .bind(row.name)
      .run();
  put_end(row.name, row.status, row.ended, row.outcome);
  transaction.commit();
}

void Ledger::put_end(const std::string& run, RunStatus status, double ended,
                     const Outcome& outcome) {
  database_
      .prepare(
          "UPDATE run SET status = ?, exit_status = ?, message = ?, ended = ?, "
          "wall_seconds = ?, processor_seconds = ?, peak_memory = ? WHERE name = ?")
      .bind(word_of(status))
      .bind(outcome.exit_status)
      .bind(outcome.message)
      .bind(ended)
      .bind(outcome.wall_seconds)
      .bind(outcome.processor_seconds)
      .bind(outcome.peak_memory)
      .bind(run)
      .run();
  put_details(run, outcome);
}

void Ledger::put_details(const std::string& run, const Outcome& outcome) {
  for (const Outcome::Measurement& one : outcome.measurements) {
    database_.prepare("INSERT OR REPLACE INTO measurement VALUES (?, ?, ?, ?)")
        .bind(run)
        .bind(one.name)
        .bind(one.unit)
        .bind(one.value)
        .run();
  }
  for (const auto& [name, version] : outcome.versions) {
    database_.prepare("INSERT OR REPLACE INTO version VALUES (?, ?, ?)")
        .bind(run)
        .bind(name)
        .bind(version)
        .run();
  }
}

std::vector<RunRow> Ledger::rows() {
  const Transaction one_moment(database_, "BEGIN");
  std::vector<RunRow> rows;
  // The program may have been killed before it had created the tables, which are created all at
  // once.
  Statement tables = database_.prepare("SELECT 1 FROM sqlite_master WHERE name = 'run'");
  if (!tables.next()) return rows;
  Statement select = database_.prepare(
      "SELECT name, status, attempts, exit_status, message, started, ended, wall_seconds, "
      "processor_seconds, peak_memory FROM run ORDER BY rowid");
  while (select.next()) {
    RunRow row;
    row.name = select.text(0);
    row.status = status_of(select.text(1));
    row.attempts = select.integer(2);
    if (!select.is_null(3)) row.outcome.exit_status = select.integer(3);
    row.outcome.message = select.text(4);
    row.started = select.number(5);
    row.ended = select.number(6);
    row.outcome.wall_seconds = select.number(7);
    row.outcome.processor_seconds = select.number(8);
    row.outcome.peak_memory = select.integer(9);
    rows.push_back(std::move(row));
  }
  std::map<std::string, RunRow*> by_name;
  for (RunRow& row : rows) by_name[row.name] = &row;
  get_details(by_name);
  return rows;
}

void Ledger::get_details(std::map<std::string, RunRow*>& by_name) {
  Statement parameters = database_.prepare("SELECT run, key, value FROM parameter ORDER BY rowid");
  while (parameters.next()) {
    by_name.at(parameters.text(0))->parameters.emplace_back(parameters.text(1), parameters.text(2));
  }
  Statement measurements =
      database_.prepare("SELECT run, name, unit, value FROM measurement ORDER BY rowid");
  while (measurements.next()) {
    by_name.at(measurements.text(0))
        ->outcome.measurements.push_back(
            {measurements.text(1), measurements.text(2), measurements.number(3)});
  }
  Statement versions = database_.prepare("SELECT run, name, version FROM version ORDER BY rowid");
  while (versions.next()) {
    by_name.at(versions.text(0))->outcome.versions.emplace_back(versions.text(1), versions.text(2));
  }
}

}  // namespace pliant::batch
