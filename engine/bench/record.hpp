#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/bench/row.hpp"

/// The content of files of `pliant bench --save`: the figures of a program, each with those of the
/// machine at that time.
namespace pliant::bench {

/// One measurement of a row and of the machine at that time.
struct RecordedSample {
  double rate = 0;       ///< [particle-stages/s]
  double fma_peak = 0;   ///< [flop/s]
  double triad = 0;      ///< [bytes/s]
  double hand_over = 0;  ///< [s]; 0 on one thread
};

struct RecordedRow {
  std::string name;  ///< see `Row::name`
  std::int64_t particles = 0;
  int threads = 1;
  std::vector<RecordedSample> samples;
};

/// All rows measured on one machine.
struct Record {
  std::vector<std::string> machine;  ///< lines that describe it
  std::vector<RecordedRow> rows;
};

Record record_of(const std::vector<std::string>& machine, const std::vector<Row>& rows);

std::string json_of(const Record& record);

/// `source` names the text in messages. Throws InputError.
Record parse_record(const std::string& text, const std::string& source);
Record read_record(const std::filesystem::path& file);

}  // namespace pliant::bench
