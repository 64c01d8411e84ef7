#include "engine/case/blade_track.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/engine/case/written_case.hpp"
#include "tests/engine/output/temporary_folder.hpp"

namespace pliant::test {
namespace {

std::string track_file(const TemporaryFolder& folder, const std::string& text) {
  const std::string file = (folder / "track.csv").string();
  std::ofstream(file) << text;
  return file;
}

CutCase tracked(const TemporaryFolder& folder, const std::string& text, int dimension) {
  CutCase cut;
  cut.track.file = track_file(folder, text);
  load_track(cut, dimension);
  return cut;
}

TEST(blade_track, is_linear_between_its_rows) {
  const TemporaryFolder folder;
  const CutCase cut = tracked(folder,
                              "time,x1,y1,z1,x2,y2,z2\n0.5,0,0,0,0,0,1\r\n\n1,2,0,0,2,4,1\n"
                              "2,2,8,0,2,8,1\n",
                              3);
  EXPECT_EQ(cut.start, 0.5);
  EXPECT_EQ(cut.end, 2);
  EXPECT_EQ(edge_of(cut, 0).to, (Vector{0, 0, 1}));
  EXPECT_EQ(edge_of(cut, 0.75).from, (Vector{1, 0, 0}));
  EXPECT_EQ(edge_of(cut, 0.75).to, (Vector{1, 2, 1}));
  EXPECT_EQ(edge_of(cut, 1.25).from, (Vector{2, 2, 0}));
  EXPECT_EQ(edge_of(cut, 3).from, (Vector{2, 8, 0}));
}

TEST(blade_track, turns_the_edge_by_quaternions_of_any_length) {
  const TemporaryFolder folder;
  CutCase cut;
  cut.edge = VectorExpression{0., 0., 2.};
  cut.track.file = track_file(folder,
                              "time,x,y,z,qw,qx,qy,qz\n0,1,1,1,1,0,0,0\n"
                              "1,1,1,1,3,3,0,0\n2,1,1,1,0,0,1,0\n");
  load_track(cut, 3);
  const Vector ends[] = {{1, 1, 3}, {1, -1, 1}, {1, 1, -1}};
  for (int t = 0; t < 3; ++t) {
    for (int a = 0; a < 3; ++a) EXPECT_NEAR(edge_of(cut, t).to[a], ends[t][a], 1e-15) << t << a;
  }
}

TEST(blade_track, edge_may_turn_by_formulas) {
  CutCase cut;
  cut.from = {1, 0, 0};
  cut.path = {Expression("2*t"), 0., 0.};
  cut.edge = VectorExpression{0., Expression("t"), 1.};
  EXPECT_EQ(edge_of(cut, 3).from, (Vector{7, 0, 0}));
  EXPECT_EQ(edge_of(cut, 3).to, (Vector{7, 3, 1}));
}

std::string fault(const std::string& text, int dimension = 2) {
  const TemporaryFolder folder;
  try {
    tracked(folder, text, dimension);
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    return message.substr(message.find("track.csv"));
  }
  return "none";
}

TEST(blade_track, that_cannot_be_followed_is_refused_with_its_line) {
  EXPECT_EQ(fault("t,x,y\n"),
            "track.csv:1: not the track of a blade in 2D; its first line must be `time,x,y`");
  EXPECT_EQ(fault("time,x,y\n0,1,2\n1,1\n"),
            "track.csv:3: 2 columns, where the header has 3; give a value for each column");
  EXPECT_EQ(fault("time,x,y\n0,1,a\n"),
            "track.csv:2: column 3 must be a finite number, got `a`; give a number");
  EXPECT_EQ(fault("time,x,y\n1,1,2\n1,1,3\n"),
            "track.csv:3: t = 1 comes after t = 1; sort the rows by time");
  EXPECT_EQ(fault("time,x,y\n1,1,2\n"),
            "track.csv: a track needs two times or more, and has 1; add rows");
  EXPECT_EQ(fault("time,x,y,z,qw,qx,qy,qz\n", 3),
            "track.csv:1: quaternions turn the edge of the case, which has none; give the key "
            "edge");
  EXPECT_EQ(fault("time,x,y\n", 3),
            "track.csv:1: not the track of a blade in 3D; its first line must be "
            "`time,x1,y1,z1,x2,y2,z2` or `time,x,y,z,qw,qx,qy,qz`");
}

TEST(blade_track, takes_the_place_of_from_path_and_end) {
  const TemporaryFolder folder;
  const std::string body = R"(method = "point_based"
dimension = 2
discretisation = { spacing = 0.125 }
time = { end = 1 }
[[body]]
name = "block"
material = { model = "neo_hookean", density = 1, youngs_modulus = 1, poissons_ratio = 0.3 }
geometry = { shape = "box", lower = [0, 0], upper = [1, 1] }
[[cut]]
name = "blade"
)";
  const std::string file = track_file(folder, "time,x,y\n0,0.5,-0.1\n0.5,0.5,1\n");
  const Case settings = tests::read_text(body + "track = \"" + file + "\"\n");
  EXPECT_EQ(settings.cuts[0].end, 0.5);
  EXPECT_NE(tests::complaint(body).find("cut \"blade\" lacks the key `from`; give from, path and "
                                        "end, or a track"),
            std::string::npos);
  EXPECT_NE(tests::complaint(body + "track = \"nowhere.csv\"\n")
                .find("nowhere.csv: cannot be read; check the path"),
            std::string::npos);
}

}  // namespace
}  // namespace pliant::test
