#include "engine/output/archive/archive.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <chrono>
#include <cstring>
#include <fstream>
#include <limits>
#include <numeric>
#include <thread>

#include "engine/output/archive/archive_format.hpp"
#include "engine/output/error.hpp"
#include "engine/output/hdf5/hdf5.hpp"
#include "tests/engine/output/temporary_folder.hpp"

namespace pliant::test {
namespace {

template <class T>
std::vector<std::byte> bytes_of(const std::vector<T>& values) {
  std::vector<std::byte> bytes(values.size() * sizeof(T));
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

const std::vector<double> awkward = {0.0,
                                     -0.0,
                                     std::numeric_limits<double>::denorm_min(),
                                     std::numeric_limits<double>::infinity(),
                                     std::bit_cast<double>(0x7ff8'0000'dead'beefULL),  // quiet NaN
                                     std::bit_cast<double>(0xfff0'0000'0000'0001ULL),  // signalling
                                     0.1,
                                     std::numeric_limits<double>::max()};

/// The message of the OutputError that `action` throws.
template <class Action>
std::string error_of(Action action) {
  try {
    action();
  } catch (const OutputError& error) {
    return error.what();
  }
  return "no error";
}

void expect_in(const std::string& part, const std::string& text) {
  EXPECT_NE(text.find(part), text.npos) << text;
}

TEST(archive, arrays_come_back_bit_for_bit) {
  const TemporaryFolder folder;
  const std::vector<float> singles = {-0.0f, std::bit_cast<float>(0x7fc0beefu), 1e-45f};
  std::vector<std::int64_t> many(300000);  // several chunks
  std::iota(many.begin(), many.end(), std::numeric_limits<std::int64_t>::min());
  const std::vector<std::int32_t> small = {-1, 0, std::numeric_limits<std::int32_t>::max()};
  const std::vector<std::uint8_t> flags = {0, 1, 255};
  ArchiveWriter writer(folder / "a.h5");
  writer.put("body/velocity", awkward);
  writer.put("single", singles);
  writer.put("body/deeper/many", many);
  writer.put("small", small);
  writer.put("flags", flags);
  writer.put("none", std::vector<double>());
  writer.put("time", awkward[4]);
  writer.put("step", std::int64_t{1} << 60);
  writer.put("case", std::string_view("line\nzero \0 byte", 16));
  writer.put("empty", std::string_view());
  writer.commit();

  const ArchiveReader reader(folder / "a.h5");
  reader.verify();
  EXPECT_EQ(bytes_of(reader.get<double>("body/velocity")), bytes_of(awkward));
  EXPECT_EQ(bytes_of(reader.get<float>("single")), bytes_of(singles));
  EXPECT_EQ(reader.get<std::int64_t>("body/deeper/many"), many);
  EXPECT_EQ(reader.get<std::int32_t>("small"), small);
  EXPECT_EQ(reader.get<std::uint8_t>("flags"), flags);
  EXPECT_TRUE(reader.get<double>("none").empty());
  EXPECT_EQ(std::bit_cast<std::uint64_t>(reader.scalar<double>("time")), 0x7ff8'0000'dead'beefULL);
  EXPECT_EQ(reader.scalar<std::int64_t>("step"), std::int64_t{1} << 60);
  EXPECT_EQ(reader.text("case"), std::string("line\nzero \0 byte", 16));
  EXPECT_EQ(reader.text("empty"), "");
  EXPECT_EQ(reader.names("body"), (std::vector<std::string>{"deeper", "velocity"}));
  EXPECT_TRUE(reader.names("nowhere").empty());

  std::vector<double> in_place(awkward.size());
  reader.read("body/velocity", std::span<double>(in_place));
  EXPECT_EQ(bytes_of(in_place), bytes_of(awkward));
}

TEST(archive, of_another_format_is_refused_by_its_number) {
  const TemporaryFolder folder;
  ArchiveWriter writer(folder / "a.h5");
  writer.put("time", 1.0);
  writer.commit();
  for (const int other : {archive::format - 1, archive::format + 1}) {
    {
      const hdf5::Handle file(H5Fopen((folder / "a.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT),
                              H5Fclose, "open it");
      hdf5::overwrite_attribute(file, archive::format_attribute, other);
    }
    expect_in("has format " + std::to_string(other),
              error_of([&] { const ArchiveReader reader(folder / "a.h5"); }));
  }
}

TEST(archive, equal_content_makes_equal_files) {
  const TemporaryFolder folder;
  for (const auto* name : {"a.h5", "b.h5"}) {
    if (std::filesystem::exists(folder /
                                "a.h5"))  // time stamps of HDF5 have a resolution of one second
      std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    ArchiveWriter writer(folder / name);
    writer.put("x", awkward);
    writer.commit();
  }
  EXPECT_TRUE(text_of(folder / "a.h5") == text_of(folder / "b.h5"));
}

TEST(archive, appears_on_commit_only) {
  const TemporaryFolder folder;
  {
    ArchiveWriter writer(folder / "a.h5");
    writer.put("x", awkward);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.h5"));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(archive, what_is_missing_or_of_another_type_or_size_is_named) {
  const TemporaryFolder folder;
  ArchiveWriter writer(folder / "a.h5");
  writer.put("group/x", awkward);
  writer.commit();
  const ArchiveReader reader(folder / "a.h5");
  EXPECT_TRUE(reader.has("group/x"));
  EXPECT_FALSE(reader.has("group/y"));
  EXPECT_FALSE(reader.has("other/x"));
  expect_in("has no 'other/x'", error_of([&] { reader.get<double>("other/x"); }));
  expect_in("'group/x' in another type", error_of([&] { reader.get<float>("group/x"); }));
  std::vector<double> small(3);
  expect_in("8 entries of 'group/x' where 3 are expected",
            error_of([&] { reader.read("group/x", std::span<double>(small)); }));
}

TEST(archive, foreign_files_are_refused_with_path_and_remedy) {
  const TemporaryFolder folder;
  const auto open = [&](const std::string& name) {
    return error_of([&] { const ArchiveReader reader(folder / name); });
  };
  expect_in("absent.h5: does not exist", open("absent.h5"));
  std::ofstream(folder / "text.h5") << "not HDF5 at all";
  expect_in("text.h5: is not a checkpoint", open("text.h5"));
  std::ofstream(folder / "empty.h5");
  expect_in("empty.h5: is not a checkpoint", open("empty.h5"));
  expect_in("; ", open("empty.h5"));
}

TEST(archive, every_cut_of_a_file_is_found_damaged) {
  const TemporaryFolder folder;
  ArchiveWriter writer(folder / "whole.h5");
  writer.put("x", awkward);
  writer.put("y", std::vector<double>(5000, 1.0));
  writer.commit();
  const auto whole = text_of(folder / "whole.h5");
  for (std::size_t size = 0; size < whole.size(); size += 1009) {
    std::ofstream(folder / "cut.h5", std::ios::binary) << whole.substr(0, size);
    const auto read = [&] {
      const ArchiveReader reader(folder / "cut.h5");
      reader.verify();
    };
    EXPECT_THROW(read(), OutputError) << size;
  }
}

TEST(archive, no_changed_byte_goes_unnoticed_in_an_array) {
  const TemporaryFolder folder;
  std::vector<double> values(4000);
  std::iota(values.begin(), values.end(), 0.5);
  ArchiveWriter writer(folder / "whole.h5");
  writer.put("x", values);
  writer.commit();
  const auto whole = text_of(folder / "whole.h5");
  const auto begin = whole.find(std::string(reinterpret_cast<const char*>(values.data()), 64));
  ASSERT_NE(begin, whole.npos);
  for (std::size_t i = begin; i < begin + values.size() * sizeof(double); i += 1237) {
    auto damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 4);
    std::ofstream(folder / "damaged.h5", std::ios::binary) << damaged;
    const ArchiveReader reader(folder / "damaged.h5");
    EXPECT_THROW(reader.verify(), OutputError) << i;
    expect_in("is damaged", error_of([&] { reader.get<double>("x"); }));
  }
}

}  // namespace
}  // namespace pliant::test
