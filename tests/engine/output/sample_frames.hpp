#pragma once

#include <filesystem>
#include <functional>

#include "engine/output/results/frame.hpp"
#include "engine/output/results/result_file.hpp"
#include "tests/engine/output/file_content.hpp"

namespace pliant::test {

/// Frame `number` of an artificial run with `least` particles or up to half as many more: velocity
/// in the plane, stress, density, a body and a number, where every value identifies frame, particle
/// and component. Four frames in five also have a surface of triangles.
Frame sample_frame(int number, int least);

RunDescription sample_run();

/// Writes frames [begin, end), and before each of them three rows of the history "extent".
void write_frames(ResultFile& file, int begin, int end, int least);

/// Number of frames in a file, by the count that VTKHDF readers use, after comparing each with the
/// sample frame. Throws std::runtime_error at the first difference.
int whole_frames(const FileContent& content, int least);

}  // namespace pliant::test
