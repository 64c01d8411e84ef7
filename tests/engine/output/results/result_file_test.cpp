#include "engine/output/results/result_file.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <pliant/error.hpp>

#include <chrono>
#include <regex>
#include <thread>

#include "engine/output/error.hpp"
#include "tests/engine/output/sample_frames.hpp"
#include "tests/engine/output/temporary_folder.hpp"

namespace pliant::test {
namespace {

constexpr int particles = 700;  // 5 such frames fill several chunks of 1024

TEST(result_file, every_frame_is_found_where_the_vtkhdf_layout_says) {
  const TemporaryFolder folder;
  auto file = ResultFile::create(folder.path(), sample_run());
  write_frames(file, 0, 5, particles);
  file.close();
  const auto content = content_of(folder / "result.h5");
  EXPECT_EQ(whole_frames(content, particles), 5);
  EXPECT_EQ(content.at("/VTKHDF@Version").as<std::int32_t>(), (std::vector{2, 0}));
  EXPECT_EQ(content.at("/VTKHDF@Type").bytes, "PolyData");
  EXPECT_EQ(content.at("/VTKHDF/Steps/NumberOfParts").as<std::int64_t>(),
            std::vector<std::int64_t>(5, 1));
  EXPECT_EQ(content.at("/VTKHDF/PointData/velocity@unit").bytes, "m/s");
  EXPECT_EQ(content.at("/VTKHDF/PointData/velocity").shape[1], 3u);
  EXPECT_EQ(content.at("/VTKHDF/PointData/stress").shape[1], 6u);
  EXPECT_EQ(content.at("/VTKHDF/PointData/density").shape.size(), 1u);
  EXPECT_EQ(content.at("/run/case.toml").bytes, sample_run().resolved_case);
}

TEST(result_file, histories_hold_every_row) {
  const TemporaryFolder folder;
  auto file = ResultFile::create(folder.path(), sample_run());
  write_frames(file, 0, 2, particles);
  file.append_history("late", "1", 5, 6);
  file.close();
  const auto content = content_of(folder / "result.h5");
  EXPECT_EQ(content.at("/measurements/extent/time").as<double>(),
            (std::vector<double>{0, 0.1, 0.2, 1, 1.1, 1.2}));
  EXPECT_EQ(content.at("/measurements/extent/value").as<double>(),
            (std::vector<double>{0, 1, 2, 100, 101, 102}));
  EXPECT_EQ(content.at("/measurements/extent/value@unit").bytes, "m");
  EXPECT_EQ(content.at("/measurements/late/value").as<double>(), std::vector{6.0});
}

TEST(result_file, equal_runs_write_equal_bytes) {
  const TemporaryFolder folder;
  for (const auto* name : {"first", "second"}) {
    if (std::filesystem::exists(folder /
                                "first"))  // time stamps of HDF5 have a resolution of one second
      std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    auto file = ResultFile::create(folder / name, sample_run());
    write_frames(file, 0, 4, particles);
    file.close();
  }
  EXPECT_TRUE(text_of(folder / "first/result.h5") == text_of(folder / "second/result.h5"));
  EXPECT_EQ(text_of(folder / "first/result.xdmf"), text_of(folder / "second/result.xdmf"));
}

TEST(result_file, a_resumed_run_equals_an_uninterrupted_one) {
  const TemporaryFolder folder;
  {
    auto file = ResultFile::create(folder / "whole", sample_run());
    write_frames(file, 0, 8, particles);
  }
  for (int kept = 0; kept < 5; ++kept) {
    SCOPED_TRACE(kept);
    const auto resumed = folder / std::to_string(kept);
    ResultExtent extent;
    {
      auto file = ResultFile::create(resumed, sample_run());
      write_frames(file, 0, kept, particles);
      extent = file.flush();
      // The run continues beyond its checkpoint and measures something new.
      write_frames(file, kept, 6, particles + 5);
      file.append_history("late", "1", 5, 6);
    }
    {
      auto file = ResultFile::resume(resumed, sample_run(), extent);
      write_frames(file, kept, 8, particles);
    }
    EXPECT_EQ(
        differences(content_of(folder / "whole/result.h5"), content_of(resumed / "result.h5")),
        std::vector<std::string>());
    EXPECT_EQ(text_of(folder / "whole/result.xdmf"), text_of(resumed / "result.xdmf"));
  }
}

TEST(result_file, resuming_twice_from_one_checkpoint_is_resuming_once) {
  const TemporaryFolder folder;
  ResultExtent extent;
  {
    auto file = ResultFile::create(folder.path(), sample_run());
    write_frames(file, 0, 3, particles);
    extent = file.flush();
    write_frames(file, 3, 6, particles);
  }
  const auto whole = content_of(folder / "result.h5");
  for (int times = 0; times < 2; ++times) {
    auto file = ResultFile::resume(folder.path(), sample_run(), extent);
    write_frames(file, 3, 6, particles);
  }
  EXPECT_EQ(differences(whole, content_of(folder / "result.h5")), std::vector<std::string>());
}

TEST(result_file, rows_between_the_last_frame_and_the_checkpoint_are_kept) {
  const TemporaryFolder folder;
  ResultExtent extent;
  {
    auto file = ResultFile::create(folder.path(), sample_run());
    write_frames(file, 0, 1, particles);
    file.append_history("extent", "m", 7, 8);
    extent = file.flush();
    file.append_history("extent", "m", 9, 10);
  }
  EXPECT_EQ(extent.frames, 1);
  EXPECT_EQ(extent.history_rows, (std::map<std::string, std::int64_t>{{"extent", 4}}));
  ResultFile::resume(folder.path(), sample_run(), extent).close();
  EXPECT_EQ(content_of(folder / "result.h5").at("/measurements/extent/value").as<double>().back(),
            8);
}

TEST(result_file, has_no_name_before_the_first_frame_is_whole) {
  const TemporaryFolder folder;
  {
    auto file = ResultFile::create(folder.path(), sample_run());
    EXPECT_FALSE(std::filesystem::exists(folder / "result.h5"));
    file.append(sample_frame(0, particles));
    EXPECT_TRUE(std::filesystem::exists(folder / "result.h5"));
  }
  { auto unused = ResultFile::create(folder.path(), sample_run()); }
  EXPECT_EQ(whole_frames(content_of(folder / "result.h5"), particles), 1);
  EXPECT_FALSE(std::filesystem::exists(folder / "result.h5.partial"));
}

TEST(result_file, can_be_read_while_it_is_written) {
  const TemporaryFolder folder;
  auto file = ResultFile::create(folder.path(), sample_run());
  for (int f = 0; f < 3; ++f) {
    write_frames(file, f, f + 1, particles);
    // In a separate process: within this process HDF5 would share the open file.
    const auto child = ::fork();
    if (child == 0) {
      const auto command = "h5dump -H " + (folder / "result.h5").string() + " > /dev/null";
      ::_exit(std::system(command.c_str()) == 0 ? 0 : 1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
}

TEST(result_file, the_viewer_file_points_into_the_arrays) {
  const TemporaryFolder folder;
  auto file = ResultFile::create(folder.path(), sample_run());
  write_frames(file, 0, 3, particles);
  file.close();
  const auto xdmf = text_of(folder / "result.xdmf");
  const auto content = content_of(folder / "result.h5");
  const std::regex slab(R"(Dimensions="(\d+)( \d)?">result\.h5:([^|]+)\|(\d+)( 0)?:1)");
  int slabs = 0;
  for (std::sregex_iterator match(xdmf.begin(), xdmf.end(), slab), end; match != end; ++match) {
    ++slabs;
    const auto& shape = content.at((*match)[3].str()).shape;
    EXPECT_LE(std::stoul((*match)[4]) + std::stoul((*match)[1]), shape[0]) << (*match)[3];
    EXPECT_EQ((*match)[2].matched, shape.size() == 2) << (*match)[3];
  }
  EXPECT_EQ(slabs, 3 * (2 + 5));
}

TEST(result_file, a_second_run_is_kept_out_of_the_folder) {
  const TemporaryFolder folder;
  const auto file = ResultFile::create(folder.path(), sample_run());
  EXPECT_THROW(ResultFile::create(folder.path(), sample_run()), OutputError);
}

TEST(result_file, resuming_needs_all_that_the_checkpoint_counted) {
  const TemporaryFolder folder;
  {
    auto file = ResultFile::create(folder.path(), sample_run());
    write_frames(file, 0, 2, particles);
  }
  EXPECT_THROW(ResultFile::resume(folder.path(), sample_run(), {3, {}}), OutputError);
  EXPECT_THROW(ResultFile::resume(folder.path(), sample_run(), {2, {{"extent", 7}}}), OutputError);
  EXPECT_THROW(ResultFile::resume(folder.path(), sample_run(), {2, {{"unknown", 1}}}), OutputError);
  EXPECT_THROW(ResultFile::resume(folder / "elsewhere", sample_run(), {2, {}}), OutputError);
  EXPECT_EQ(whole_frames(content_of(folder / "result.h5"), particles), 2);
}

TEST(result_file, of_another_run_is_not_resumed_and_not_changed) {
  const TemporaryFolder folder;
  {
    auto file = ResultFile::create(folder.path(), sample_run());
    write_frames(file, 0, 2, particles);
  }
  const auto before = text_of(folder / "result.h5");
  RunDescription another = sample_run();
  another.identity = "fedcba9876543210";
  EXPECT_THROW(ResultFile::resume(folder.path(), another, {1, {}}), InputError);
  EXPECT_TRUE(text_of(folder / "result.h5") == before);
}

TEST(result_file, a_foreign_or_cut_file_is_not_resumed) {
  const TemporaryFolder folder;
  {
    auto file = ResultFile::create(folder.path(), sample_run());
    write_frames(file, 0, 2, particles);
  }
  std::filesystem::resize_file(folder / "result.h5", 50000);
  EXPECT_THROW(ResultFile::resume(folder.path(), sample_run(), {2, {}}), OutputError);
  std::ofstream(folder / "result.h5") << "not HDF5 at all";
  EXPECT_THROW(ResultFile::resume(folder.path(), sample_run(), {2, {}}), OutputError);
  EXPECT_EQ(text_of(folder / "result.h5"), "not HDF5 at all");
}

TEST(result_file, a_closed_file_takes_no_more) {
  const TemporaryFolder folder;
  auto file = ResultFile::create(folder.path(), sample_run());
  file.append(sample_frame(0, particles));
  file.close();
  file.close();
  EXPECT_THROW(file.append(sample_frame(1, particles)), std::logic_error);
  EXPECT_THROW(file.append_history("extent", "m", 0, 0), std::logic_error);
  EXPECT_THROW(file.flush(), std::logic_error);
}

TEST(result_file, frames_that_contradict_the_earlier_ones_are_refused) {
  const TemporaryFolder folder;
  auto file = ResultFile::create(folder.path(), sample_run());
  file.append(sample_frame(0, particles));
  auto fewer_fields = sample_frame(1, particles);
  fewer_fields.fields.pop_back();
  EXPECT_THROW(file.append(fewer_fields), std::invalid_argument);
  auto short_field = sample_frame(1, particles);
  std::get<std::vector<double>>(short_field.fields[0].values).pop_back();
  EXPECT_THROW(file.append(short_field), std::invalid_argument);
  EXPECT_THROW(file.append(Frame{}), std::invalid_argument);
  file.append(sample_frame(1, particles));
  file.close();
  EXPECT_EQ(whole_frames(content_of(folder / "result.h5"), particles), 2);
}

}  // namespace
}  // namespace pliant::test
