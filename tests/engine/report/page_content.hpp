#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace pliant::test {

/// Content of a page of a report, decoded in the same way as by its scripts.
struct PageContent {
  std::string text;
  nlohmann::json run;
  std::vector<std::string> frames;  ///< inflated
};

PageContent content_of_page(const std::filesystem::path& page);

/// RFC 4648.
std::string from_base64(std::string_view text);
std::string inflated(const std::string& bytes);

/// Reads one array after another, as page/decode.js does.
class NumberReader {
 public:
  explicit NumberReader(std::string bytes) : bytes_(std::move(bytes)) {}

  std::vector<std::uint32_t> next(std::size_t count, std::size_t planes,
                                  const std::vector<std::uint32_t>& before = {});
  bool at_end() const { return at_ == bytes_.size(); }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

}  // namespace pliant::test
