#include "engine/report/packed_frames.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/report/byte_streams.hpp"

namespace pliant::report {
namespace {

constexpr double levels = 65535;
constexpr std::size_t most_frames = 300, least_frames = 25;
/// Without these bits, positions have 13: 8000 steps across the box, more than the pixels of a
/// screen.
constexpr int spare_bits = 3;

/// The points of one frame, surface first.
using Content = std::vector<FramePoints>;
using Numbers = std::vector<std::uint16_t>;

Content content_of(const RunReader& run, std::size_t frame, const std::vector<Scalar>& scalars) {
  Content content;
  FramePoints particles = run.particles(frame, scalars);
  if (run.corners() > 0) content.push_back(run.surface(frame, scalars, particles));
  content.push_back(std::move(particles));
  return content;
}

std::vector<std::size_t> chosen_frames(std::size_t count, std::size_t every) {
  std::vector<std::size_t> chosen;
  chosen.reserve(count / every + 2);
  for (std::size_t f = 0; f < count; f += every) chosen.push_back(f);
  if (count > 0 && chosen.back() != count - 1) chosen.push_back(count - 1);
  return chosen;
}

/// Extends the range to a value, if that is finite.
void widen(std::array<double, 2>& range, double value) {
  if (!std::isfinite(value)) return;
  range = {std::min(range[0], value), std::max(range[1], value)};
}

class Packer {
 public:
  Packer(const RunReader& run, const std::vector<Scalar>& scalars, const Thinning& thinning)
      : run_(run) {
    packed_.thinning = thinning;
    packed_.scalars.assign(scalars.begin(), scalars.begin() + std::ptrdiff_t(thinning.scalars));
    frames_ = chosen_frames(run.frames().size(), thinning.every_frame);
    if (run.corners() > 0) packed_.sets.push_back({.kind = "surface", .corners = run.corners()});
    packed_.sets.push_back({.kind = "particles"});
    before_.resize(packed_.sets.size());
    measure();
  }

  /// Empty if it would have more than `limit` bytes.
  std::optional<PackedFrames> operator()(std::size_t limit) {
    std::size_t sum = 0;
    for (std::size_t f = 0; f < frames_.size(); ++f) {
      packed_.times.push_back(run_.frames()[frames_[f]].time);
      packed_.frames.push_back(base64(deflated(bytes_of(f))));
      sum += packed_.frames.back().size();
      // Frames are similar: a few of them show whether all will fit.
      const bool hopeless =
          f >= 5 && double(sum) / double(f + 1) * double(frames_.size()) > 1.2 * double(limit);
      if (sum > limit || hopeless) return {};
    }
    return std::move(packed_);
  }

 private:
  void measure() {
    constexpr double most = std::numeric_limits<double>::max();
    std::array<std::array<double, 2>, 3> box;
    box.fill({most, -most});
    packed_.range.assign(packed_.scalars.size(), {most, -most});
    for (const auto frame : frames_) {
      for (const FramePoints& points : content_of(run_, frame, packed_.scalars)) {
        for (std::size_t i = 0; i < points.position.size(); ++i)
          widen(box[i % 3], double{points.position[i]});
        for (std::size_t s = 0; s < points.values.size(); ++s) {
          for (const float value : points.values[s]) widen(packed_.range[s], double{value});
        }
      }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (box[axis][0] > box[axis][1]) box[axis] = {0, 0};
      packed_.origin[axis] = box[axis][0];
      packed_.sides[axis] = box[axis][1] - box[axis][0];
    }
    for (auto& range : packed_.range) {
      if (range[0] > range[1]) range = {0, 0};
    }
  }

  std::uint16_t level_of(double share) const {
    const double step = double(1 << packed_.thinning.shift);
    const double bounded = std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.0;
    return static_cast<std::uint16_t>(
        std::min(std::round(bounded * levels / step), std::floor(levels / step)));
  }

  std::vector<Numbers> numbers_of(const FramePoints& points, std::size_t every) const {
    std::vector<Numbers> numbers(3 + points.values.size());
    for (auto& array : numbers) array.reserve(points.count() / every + 1);
    const double size = std::max({packed_.sides[0], packed_.sides[1], packed_.sides[2], 1e-300});
    for (std::size_t i = 0; i < points.count(); i += every) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        numbers[axis].push_back(
            level_of((double{points.position[3 * i + axis]} - packed_.origin[axis]) / size));
      for (std::size_t s = 0; s < points.values.size(); ++s) {
        const auto [low, high] = packed_.range[s];
        numbers[3 + s].push_back(
            high > low ? level_of((double{points.values[s][i]} - low) / (high - low)) : 0);
      }
    }
    return numbers;
  }

  std::string bytes_of(std::size_t f) {
    const Content content = content_of(run_, frames_[f], packed_.scalars);
    std::string bytes;
    for (std::size_t s = 0; s < content.size(); ++s) {
      PackedSet& set = packed_.sets[s];
      const std::size_t every = set.corners > 0 ? 1 : packed_.thinning.every_particle;
      auto numbers = numbers_of(content[s], every);
      auto& before = before_[s];
      before.numbers.resize(numbers.size());
      for (std::size_t i = 0; i < numbers.size(); ++i)
        append_numbers(bytes, numbers[i], before.numbers[i]);
      set.points.push_back(numbers[0].size());
      before.numbers = std::move(numbers);
      if (set.corners == 0) continue;
      const auto& vertex = content[s].vertex;
      set.pieces.push_back(vertex.size() / std::size_t(set.corners));
      set.same.push_back(f > 0 && vertex == before.vertex);
      if (!set.same.back()) append_numbers(bytes, vertex);
      before.vertex = vertex;
    }
    return bytes;
  }

  struct Before {
    std::vector<Numbers> numbers;
    std::vector<std::uint32_t> vertex;
  };

  const RunReader& run_;
  PackedFrames packed_;
  std::vector<std::size_t> frames_;
  std::vector<Before> before_;  ///< [set] the frame before
};

/// Thins a little more, starting with what is least visible.
void thin(Thinning& thinning, std::size_t frames) {
  if (thinning.shift == 0)
    thinning.shift = spare_bits;
  else if (thinning.scalars > 3)
    thinning.scalars = 3;
  else if (thinning.scalars > 1)
    thinning.scalars -= 1;
  else if (frames / (2 * thinning.every_frame) >= least_frames)
    thinning.every_frame *= 2;
  else
    thinning.every_particle *= 2;
}

}  // namespace

PackedFrames pack(const RunReader& run, const std::vector<Scalar>& scalars, std::size_t limit) {
  const std::size_t frames = run.frames().size();
  Thinning thinning{.scalars = scalars.size()};
  while (frames / thinning.every_frame > most_frames) thinning.every_frame *= 2;
  for (;;) {
    if (auto packed = Packer(run, scalars, thinning)(limit)) return std::move(*packed);
    thin(thinning, frames);
    // If the surface itself is too large, only frames are left to remove.
    if (thinning.every_particle > 64) {
      thinning.every_particle = 64;
      thinning.every_frame *= 2;
      if (thinning.every_frame > 2 * frames)
        return Packer(run, scalars, thinning)(std::numeric_limits<std::size_t>::max()).value();
    }
  }
}

}  // namespace pliant::report
