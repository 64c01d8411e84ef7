#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

/// The part of SQLite that this program needs.
namespace pliant::batch {

class Statement;

/// An open database file. All functions throw OutputError that names the file.
class Database {
 public:
  enum class Mode { create, write, read };

  Database(const std::filesystem::path& path, Mode mode);

  void execute(const char* sql);
  Statement prepare(std::string_view sql);
  [[noreturn]] void fail() const;

 private:
  std::filesystem::path path_;
  std::unique_ptr<sqlite3, int (*)(sqlite3*)> handle_;
};

/// A prepared statement; each `?` is a value, to be bound in order.
class Statement {
 public:
  Statement(Database& database, sqlite3_stmt* statement);

  Statement& bind(std::string_view text);
  Statement& bind(std::int64_t number);
  Statement& bind(double number);  ///< NaN is stored as no value
  Statement& bind(std::optional<std::int64_t> number);

  /// Moves to the next row; false if there is none.
  bool next();
  void run();

  std::string text(int column) const;
  std::int64_t integer(int column) const;
  double number(int column) const;  ///< NaN without a value
  bool is_null(int column) const;

 private:
  void check(int result);

  Database& database_;
  std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> statement_;
  int bound_ = 0;
};

/// All changes to the database during its life take effect together in `commit`, or not at all.
class Transaction {
 public:
  /// `begin` is the SQL statement; "BEGIN" is enough for reading.
  explicit Transaction(Database& database, const char* begin = "BEGIN IMMEDIATE");
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();

  void commit();

 private:
  Database& database_;
  bool is_open_ = true;
};

}  // namespace pliant::batch
