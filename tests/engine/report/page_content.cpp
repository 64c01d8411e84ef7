#include "tests/engine/report/page_content.hpp"

#include <zlib.h>

#include <stdexcept>

#include "tests/engine/output/temporary_folder.hpp"

namespace pliant::test {
namespace {

std::string between(const std::string& text, const std::string& begin, const std::string& end,
                    std::size_t& from) {
  const auto first = text.find(begin, from);
  if (first == text.npos) return {};
  const auto last = text.find(end, first + begin.size());
  from = last;
  return text.substr(first + begin.size(), last - first - begin.size());
}

}  // namespace

PageContent content_of_page(const std::filesystem::path& page) {
  PageContent content{.text = text_of(page), .run = {}, .frames = {}};
  std::size_t at = 0;
  content.run = nlohmann::json::parse(
      between(content.text, R"(<script type="application/json" id="run">)", "</script>", at));
  for (std::size_t f = 0; f < content.run.value("times", nlohmann::json::array()).size(); ++f)
    content.frames.push_back(
        inflated(from_base64(between(content.text, R"(class="frame">)", "</script>", at))));
  return content;
}

std::string from_base64(std::string_view text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(letters.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<char>(bits >> count & 0xFF));
  }
  return bytes;
}

std::string inflated(const std::string& bytes) {
  std::string text(1 << 20, '\0');
  uLongf size = text.size();
  if (uncompress(reinterpret_cast<Bytef*>(text.data()), &size,
                 reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()) != Z_OK)
    throw std::runtime_error("no zlib stream");
  text.resize(size);
  return text;
}

std::vector<std::uint32_t> NumberReader::next(std::size_t count, std::size_t planes,
                                              const std::vector<std::uint32_t>& before) {
  const bool follows = bytes_.at(at_++) == 1;
  std::vector<std::uint32_t> values(count);
  std::uint32_t last = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t code = 0;
    for (std::size_t plane = 0; plane < planes; ++plane)
      code |=
          static_cast<std::uint32_t>(static_cast<unsigned char>(bytes_.at(at_ + plane * count + i)))
          << (8 * plane);
    const std::uint32_t difference = code % 2 == 0 ? code / 2 : ~(code / 2);
    last = ((follows ? before.at(i) : last) + difference) & (planes == 2 ? 0xFFFFU : 0xFFFFFFFFU);
    values[i] = last;
  }
  at_ += planes * count;
  return values;
}

}  // namespace pliant::test
