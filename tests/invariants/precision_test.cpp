#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <ostream>

#include "engine/output/error.hpp"
#include "engine/simulation/run.hpp"
#include "tests/engine/output/file_content.hpp"
#include "tests/engine/output/temporary_folder.hpp"
#include "tests/invariants/sample_runs.hpp"

// Runs in single precision agree with those in double precision, and are as reproducible.
namespace pliant::test {
namespace {

const Settings single = {"precision=single"};

/// A short run of a case in both precisions.
struct PrecisionRun {
  const char* name;
  const char* of;
  Settings settings;
  int steps;

  Case settled(const Settings& more) const { return small_case(of, settings + more); }
  friend std::ostream& operator<<(std::ostream& out, const PrecisionRun& run) {
    return out << run.name;
  }
};

/// Runs of all methods: the remeshed ones in 2D, a ball that meets a block in 3D, an organ under
/// suction, and a disc of plain SPH.
std::vector<PrecisionRun> precision_runs() {
  std::vector<PrecisionRun> runs;
  for (const SampleRun& run : sample_runs()) {
    runs.push_back({run.name, run.of, run.settings, run.steps});
  }
  const Settings ball = {"discretisation.spacing=0.1", "body.ball.velocity=[0.1, -0.5, 0]"};
  // One step later a slot comes into contact in only one of the precisions.
  runs.push_back({"ball_on_block", "ball_on_block", ball, 16});
  runs.push_back({"liver", "liver_aspiration", {"discretisation.spacing=2.5e-3"}, 100});
  runs.push_back({"sph", "tensile_instability", {"discretisation.spacing=0.1"}, 20});
  return runs;
}

struct Precisions : testing::TestWithParam<PrecisionRun> {
  TemporaryFolder folder;

  std::unique_ptr<pliant::Solver> solver(const Settings& more, int threads = 1) const {
    return methods().make(GetParam().settled(more), {threads, kernels::widest_supported()});
  }

  void save(const pliant::Solver& solver) const {
    ArchiveWriter writer(folder / "state.h5");
    solver.save(writer);
    writer.commit();
  }
};
INSTANTIATE_TEST_SUITE_P(runs, Precisions, testing::ValuesIn(precision_runs()),
                         [](const auto& run) { return run.param.name; });

void take_steps(pliant::Solver& solver, int count) {
  for (int i = 0; i < count; ++i) solver.step(HUGE_VAL);
}

const std::vector<double>& velocity(const Frame& frame) {
  const auto at = std::ranges::find(frame.fields, "velocity", &FrameField::name);
  return std::get<std::vector<double>>(at->values);
}

/// The values of particles and ghosts, and the measurements of the case. Updates the ghosts.
std::vector<double> content(pliant::Solver& solver) {
  const Frame frame = solver.frame({.ghosts = true});
  std::vector<double> values = frame.position;
  for (const FrameField& field : frame.fields) {
    std::visit([&](const auto& of) { values.insert(values.end(), of.begin(), of.end()); },
               field.values);
  }
  const BodyIntegrals sum = solver.integrals();
  values.insert(values.end(), {sum.mass, sum.kinetic_energy, sum.strain_energy});
  return values;
}

bool have_the_same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

/// Speed of pressure waves in the stiffest body [m/s].
double wave_speed(const Case& settings) {
  double fastest = 0;
  for (const BodyCase& body : settings.bodies) {
    fastest = std::max(fastest, kernels::wave_speed_at_rest(body.material));
  }
  return fastest;
}

// The stress is rounded to K u, with the unit roundoff u and the modulus K = rho c^2: this limits
// the accuracy of the strain. Over a cell it accelerates a particle by c^2 u/h, which changes its
// velocity by c u in the time h/c of a few stages. Rounding is independent between stages: after n
// of them the error of the velocity is c u sqrt(n), times the sums over neighbours.
TEST_P(Precisions, velocities_differ_by_the_rounding_of_stress) {
  const auto in_double = solver({}), in_single = solver(single);
  take_steps(*in_double, GetParam().steps);
  take_steps(*in_single, GetParam().steps);
  EXPECT_NEAR(in_single->clock().time / in_double->clock().time, 1, 1e-5);
  const Frame a = in_double->frame({}), b = in_single->frame({});
  ASSERT_EQ(a.position.size(), b.position.size());
  const auto &u = velocity(a), &v = velocity(b);
  double largest = 0;
  for (std::size_t i = 0; i < u.size(); ++i) largest = std::max(largest, std::abs(u[i] - v[i]));
  constexpr double unit = std::numeric_limits<float>::epsilon() / 2, sums = 16;
  const double c = wave_speed(in_double->settings());
  EXPECT_LT(largest, sums * c * unit * std::sqrt(4. * GetParam().steps));
  EXPECT_GT(largest, 0) << "both ran in the same precision";
}

TEST_P(Precisions, bits_of_single_precision_do_not_depend_on_the_number_of_threads) {
  const auto one = solver(single);
  take_steps(*one, GetParam().steps);
  const std::vector<double> expected = content(*one);
  EXPECT_GT(expected.size(), 1000u);
  for (const int threads : {2, 7}) {
    const auto several = solver(single, threads);
    take_steps(*several, GetParam().steps);
    EXPECT_TRUE(have_the_same_bits(expected, content(*several))) << threads << " threads";
  }
}

TEST_P(Precisions, a_restored_solver_of_single_precision_continues_to_the_same_bits) {
  const auto whole = solver(single);
  take_steps(*whole, GetParam().steps / 2);
  save(*whole);
  const auto restored = solver(single, 2);
  restored->restore(ArchiveReader(folder / "state.h5"));
  take_steps(*whole, GetParam().steps - GetParam().steps / 2);
  take_steps(*restored, GetParam().steps - GetParam().steps / 2);
  EXPECT_TRUE(have_the_same_bits(content(*whole), content(*restored)));
}

TEST_P(Precisions, a_solver_refuses_the_fields_of_the_other_precision) {
  const auto in_double = solver({}), in_single = solver(single);
  save(*in_double);
  EXPECT_THROW(in_single->restore(ArchiveReader(folder / "state.h5")), OutputError);
}

struct Files : testing::Test {
  TemporaryFolder folder;

  void run(const Settings& more, bool resume = false) const {
    RunOptions options;
    options.folder = folder / "out";
    options.quiet = true;
    options.isa = kernels::widest_supported();
    options.resume = resume;
    const Settings quick = {"discretisation.spacing=0.1", "time.end=0.01", "output.every=0.005",
                            "output.surface=true"};
    run_case(small_case("rotating_cylinder", quick + more), options);
  }

  std::string text(const char* file) const {
    std::ifstream in(folder / "out" / file);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::size_t bytes(const FileContent& content, const std::string& path) const {
    return content.at(path).bytes.size();
  }
};

TEST_F(Files, real_numbers_of_frames_have_half_the_size_in_single_precision) {
  run({});
  const FileContent in_double = content_of(folder / "out" / "result.h5");
  run(single);
  const FileContent in_single = content_of(folder / "out" / "result.h5");
  for (const char* path : {"/VTKHDF/Points", "/VTKHDF/PointData/stress", "/surface/Points",
                           "/surface/PointData/velocity"}) {
    EXPECT_EQ(2 * bytes(in_single, path), bytes(in_double, path)) << path;
  }
  for (const char* path : {"/VTKHDF/Steps/Values", "/VTKHDF/PointData/kind"}) {
    EXPECT_EQ(bytes(in_single, path), bytes(in_double, path)) << path;
  }
  const auto single_values = in_single.at("/VTKHDF/PointData/density").as<float>();
  const auto double_values = in_double.at("/VTKHDF/PointData/density").as<double>();
  ASSERT_EQ(single_values.size(), double_values.size());
  for (std::size_t i = 0; i < single_values.size(); ++i) {
    ASSERT_NEAR(single_values[i], double_values[i], 1e-5 * double_values[i]);
  }
  for (const char* file : {"result.xdmf", "surface.xdmf"}) {
    EXPECT_NE(text(file).find(R"(NumberType="Float" Precision="4")"), std::string::npos) << file;
    EXPECT_EQ(text(file).find(R"(NumberType="Float" Precision="8")"), std::string::npos) << file;
  }
}

TEST_F(Files, state_the_precision) {
  for (const char* precision : {"single", "double"}) {
    run({std::string("precision=") + precision});
    EXPECT_EQ(nlohmann::json::parse(text("summary.json"))["precision"], precision);
    EXPECT_NE(text("case.resolved.toml").find("precision = \"" + std::string(precision) + "\""),
              std::string::npos);
  }
}

TEST_F(Files, a_checkpoint_of_the_other_precision_is_refused) {
  run({});
  EXPECT_THROW(run(single, true), InputError);
  run(single);
  EXPECT_THROW(run({}, true), InputError);
}

}  // namespace
}  // namespace pliant::test
