#include "engine/report/byte_streams.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/engine/report/page_content.hpp"

namespace pliant::test {
namespace {

using report::append_numbers;
using report::base64;
using report::deflated;

// The test vectors of RFC 4648, section 10.
TEST(byte_streams, base64_is_that_of_the_rfc) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(byte_streams, deflated_bytes_are_inflated_by_zlib) {
  const std::string bytes(1000, 'x');
  EXPECT_LT(deflated(bytes).size(), 30u);
  EXPECT_EQ(inflated(deflated(bytes)), bytes);
  EXPECT_EQ(inflated(deflated("")), "");
}

TEST(byte_streams, any_numbers_are_read_back) {
  std::mt19937 chance(1);
  std::uniform_int_distribution<int> any(0, 65535);
  std::vector<std::uint16_t> first = {0, 65535, 0, 32768, 1}, second = {65535, 0, 32767, 0, 1};
  for (int i = 0; i < 300; ++i) {
    first.push_back(static_cast<std::uint16_t>(any(chance)));
    second.push_back(static_cast<std::uint16_t>(first.back() + i % 7));
  }
  const std::vector<std::uint32_t> vertices = {0, 2147483647, 5, 4, 4};
  std::string bytes;
  append_numbers(bytes, first, {});
  const auto size_of_first = bytes.size();
  append_numbers(bytes, second, first);
  EXPECT_EQ(bytes[size_of_first], 1) << "predicted from the frame before";
  append_numbers(bytes, vertices);
  NumberReader reader(bytes);
  const std::vector<std::uint32_t> wide_first(first.begin(), first.end());
  EXPECT_EQ(reader.next(first.size(), 2), wide_first);
  EXPECT_EQ(reader.next(second.size(), 2, wide_first),
            std::vector<std::uint32_t>(second.begin(), second.end()));
  EXPECT_EQ(reader.next(vertices.size(), 4), vertices);
  EXPECT_TRUE(reader.at_end());
}

}  // namespace
}  // namespace pliant::test
