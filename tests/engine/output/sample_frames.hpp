#pragma once

#include <filesystem>
#include <functional>

#include "engine/output/results/frame.hpp"
#include "engine/output/results/result_file.hpp"
#include "tests/engine/output/file_content.hpp"

namespace pliant::test {

/// Frame `number` of a made-up run with `least` particles or up to half as many more: velocity in
/// the plane, stress, density, a body and a number; every value tells frame, particle, component. A
/// surface of triangles, too, in four frames of five.
Frame sample_frame(int number, int least);

RunDescription sample_run();

/// Writes frames [begin, end) and, before each, three rows of history "extent".
void write_frames(ResultFile& file, int begin, int end, int least);

/// How many frames a file holds by the count that VTKHDF readers go by, after comparing each with
/// the sample frame. Throws std::runtime_error at the first difference.
int whole_frames(const FileContent& content, int least);

}  // namespace pliant::test
