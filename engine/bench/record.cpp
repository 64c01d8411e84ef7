#include "engine/bench/record.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

namespace pliant::bench {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view format = "pliant bench 1";

double rate_of(const Row& row, const Sample& sample) {
  return static_cast<double>(sample.particle_stages) / sample.elapsed.compared(row.threads);
}

RecordedRow row_of(const Json& json) {
  RecordedRow row{json.at("name"), json.at("particles"), json.at("threads"), {}};
  for (const Json& sample : json.at("samples")) {
    row.samples.push_back(
        {sample.at("particle_stages_per_second"), sample.at("fma_peak_flop_per_second"),
         sample.at("triad_bytes_per_second"), sample.value("hand_over_seconds", 0.0)});
  }
  return row;
}

}  // namespace

Record record_of(const std::vector<std::string>& machine, const std::vector<Row>& rows) {
  Record record{machine, {}};
  for (const Row& row : rows) {
    RecordedRow recorded{row.name(), row.samples[0].particles, row.threads, {}};
    for (const Sample& sample : row.samples) {
      recorded.samples.push_back(
          {rate_of(row, sample), sample.fma_peak, sample.triad, sample.hand_over});
    }
    record.rows.push_back(recorded);
  }
  return record;
}

std::string json_of(const Record& record) {
  Json rows = Json::array();
  for (const RecordedRow& row : record.rows) {
    Json samples = Json::array();
    for (const RecordedSample& sample : row.samples) {
      samples.push_back({{"particle_stages_per_second", sample.rate},
                         {"fma_peak_flop_per_second", sample.fma_peak},
                         {"triad_bytes_per_second", sample.triad},
                         {"hand_over_seconds", sample.hand_over}});
    }
    rows.push_back({{"name", row.name},
                    {"particles", row.particles},
                    {"threads", row.threads},
                    {"samples", samples}});
  }
  const Json json = {{"format", format}, {"machine", record.machine}, {"rows", rows}};
  return json.dump(1) + "\n";
}

Record parse_record(const std::string& text, const std::string& source) {
  const auto refuse = [&](std::string_view what) {
    return InputError(
        fmt::format("{}: {}; give a file that `pliant bench --save` wrote", source, what));
  };
  try {
    const Json json = Json::parse(text);
    if (json.at("format") != format) throw refuse("has another format than this program reads");
    Record record{json.at("machine"), {}};
    for (const Json& row : json.at("rows")) {
      record.rows.push_back(row_of(row));
      if (record.rows.back().samples.empty()) throw refuse("has a row without samples");
    }
    return record;
  } catch (const Json::exception&) {
    throw refuse("is no record of a benchmark");
  }
}

Record read_record(const std::filesystem::path& file) {
  std::ifstream stream(file);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.good() && text.empty()) {
    throw InputError(fmt::format("{}: cannot be read; give a file that `pliant bench --save` wrote",
                                 file.string()));
  }
  return parse_record(text, file.string());
}

}  // namespace pliant::bench
