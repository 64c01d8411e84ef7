#include "engine/batch/database.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <cmath>
#include <limits>

#include "engine/output/error.hpp"

namespace pliant::batch {

namespace {

constexpr int patience = 10'000;  // waiting time for other readers and writers [ms]

int flags_of(Database::Mode mode) {
  switch (mode) {
    case Database::Mode::create:
      return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    case Database::Mode::write:
      return SQLITE_OPEN_READWRITE;
    case Database::Mode::read:
      return SQLITE_OPEN_READONLY;
  }
  return 0;
}

}  // namespace

Database::Database(const std::filesystem::path& path, Mode mode)
    : path_(path), handle_(nullptr, &sqlite3_close) {
  sqlite3* handle = nullptr;
  const int result = sqlite3_open_v2(path.c_str(), &handle, flags_of(mode), nullptr);
  handle_.reset(handle);
  if (result != SQLITE_OK) fail();
  sqlite3_busy_timeout(handle, patience);
}

void Database::execute(const char* sql) {
  if (sqlite3_exec(handle_.get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

Statement Database::prepare(std::string_view sql) {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(handle_.get(), sql.data(), static_cast<int>(sql.size()), &statement,
                         nullptr) != SQLITE_OK) {
    fail();
  }
  return {*this, statement};
}

void Database::fail() const {
  throw OutputError(path_,
                    fmt::format("the ledger cannot be used: {}", sqlite3_errmsg(handle_.get())),
                    "check the disk and the permissions of the folder");
}

Statement::Statement(Database& database, sqlite3_stmt* statement)
    : database_(database), statement_(statement, &sqlite3_finalize) {}

void Statement::check(int result) {
  if (result != SQLITE_OK) database_.fail();
}

Statement& Statement::bind(std::string_view text) {
  check(sqlite3_bind_text(statement_.get(), ++bound_, text.data(), static_cast<int>(text.size()),
                          SQLITE_TRANSIENT));
  return *this;
}

Statement& Statement::bind(std::int64_t number) {
  check(sqlite3_bind_int64(statement_.get(), ++bound_, number));
  return *this;
}

Statement& Statement::bind(double number) {
  ++bound_;
  check(std::isnan(number) ? sqlite3_bind_null(statement_.get(), bound_)
                           : sqlite3_bind_double(statement_.get(), bound_, number));
  return *this;
}

Statement& Statement::bind(std::optional<std::int64_t> number) {
  if (number) return bind(*number);
  check(sqlite3_bind_null(statement_.get(), ++bound_));
  return *this;
}

bool Statement::next() {
  const int result = sqlite3_step(statement_.get());
  if (result == SQLITE_ROW) return true;
  if (result != SQLITE_DONE) database_.fail();
  return false;
}

void Statement::run() {
  while (next()) {
  }
}

std::string Statement::text(int column) const {
  const auto* text = sqlite3_column_text(statement_.get(), column);
  return text == nullptr ? "" : reinterpret_cast<const char*>(text);
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

double Statement::number(int column) const {
  return is_null(column) ? std::numeric_limits<double>::quiet_NaN()
                         : sqlite3_column_double(statement_.get(), column);
}

bool Statement::is_null(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}

Transaction::Transaction(Database& database, const char* begin) : database_(database) {
  database_.execute(begin);
}

void Transaction::commit() {
  database_.execute("COMMIT");
  is_open_ = false;
}

// A rollback fails only if SQLite has already rolled back.
Transaction::~Transaction() {
  if (!is_open_) return;
  try {
    database_.execute("ROLLBACK");
  } catch (const OutputError&) {
    is_open_ = false;
  }
}

}  // namespace pliant::batch
