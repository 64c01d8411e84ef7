#include "engine/batch/csv.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace pliant::test {
namespace {

using namespace batch;

TEST(csv, reads_back_what_it_wrote) {
  const CsvRow row = {"plain", "with, comma", "with \"quotes\"", "two\nlines", "", "1e-3"};
  EXPECT_EQ(read_csv(csv_line(row) + csv_line(row)), (std::vector<CsvRow>{row, row}));
}

TEST(csv, of_other_programs_is_read) {
  EXPECT_EQ(read_csv("a,b\r\n1,2\r\n\r\n3,4"),
            (std::vector<CsvRow>{{"a", "b"}, {"1", "2"}, {"3", "4"}}));
  EXPECT_EQ(read_csv(""), std::vector<CsvRow>{});
}

TEST(csv, with_an_open_quotation_is_refused) {
  EXPECT_THROW(read_csv("a,\"b\n1,2"), std::invalid_argument);
}

}  // namespace
}  // namespace pliant::test
