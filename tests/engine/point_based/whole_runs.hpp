#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "engine/simulation/run.hpp"
#include "tests/engine/output/file_content.hpp"

namespace pliant::test {

/// The velocity of a body that flies, turns and deforms.
inline const std::string tumbling =
    "velocity = [\"3*y + sin(4*x)\", \"1 - 3*x\", \"2*cos(3*y)\"]\n";

/// A moving wall that holds the nodes at x = 0.
inline const std::string clamp = R"toml([[boundary]]
name = "clamp"
kind = "moving_wall"
geometry = { shape = "half_space", point = [0, 0, 0], normal = [1, 0, 0] }
velocity = [0, "0.4*cos(3*t)", 0]
)toml";

/// The content of the result file of a run to the end.
inline FileContent result_of(const Case& settings, const std::filesystem::path& folder, int threads,
                             bool resume = false) {
  RunOptions options;
  options.folder = folder;
  options.quiet = true;
  options.isa = kernels::widest_supported();
  options.threads = threads;
  options.resume = resume;
  EXPECT_EQ(run_case(settings, options), RunEnd::done);
  return content_of(folder / "result.h5");
}

}  // namespace pliant::test
