#include <algorithm>

#include "engine/point_based/cutting/body_cuts.hpp"
#include "engine/point_based/forces/node_groups.hpp"

// A restart repeats the moves of the blades, which restores the cuts and the bonds.
namespace pliant::point_based {

namespace {

template <int D>
std::vector<MaterialPoint<D>> take_points(std::span<const double>& values, std::int64_t count) {
  std::vector<MaterialPoint<D>> points(static_cast<std::size_t>(count));
  for (MaterialPoint<D>& x : points) {
    std::copy_n(values.begin(), D, x.begin());
    values = values.subspan(D);
  }
  return points;
}

}  // namespace

template <class T, int D>
void BodyCuts<T, D>::put(ArchiveWriter& archive, const std::string& name) const {
  archive.put(name + "/blade", std::span<const std::int64_t>(moves_.blade));
  archive.put(name + "/points", std::span<const std::int64_t>(moves_.points));
  archive.put(name + "/place", std::span<const double>(moves_.place));
  archive.put(name + "/time", std::span<const double>(moves_.time));
  std::vector<std::int64_t> done, put, waiting, entered, outside_points;
  std::vector<double> target, outside, mean_force;
  for (const Blade& blade : blades_) {
    entered.push_back(blade.puncture ? 0 : 1);
    mean_force.push_back(blade.puncture ? blade.puncture->mean_force() : 0);
    outside_points.push_back(static_cast<std::int64_t>(blade.outside.size()));
    for (const Point<D>& x : blade.outside) outside.insert(outside.end(), x.begin(), x.end());
    done.push_back(blade.is_done ? 1 : 0);
    put.push_back(blade.is_put ? 1 : 0);
    waiting.push_back(static_cast<std::int64_t>(blade.target.size()));
    for (const MaterialPoint<D>& x : blade.target) target.insert(target.end(), x.begin(), x.end());
  }
  archive.put(name + "/is_done", std::span<const std::int64_t>(done));
  archive.put(name + "/is_put", std::span<const std::int64_t>(put));
  archive.put(name + "/waiting", std::span<const std::int64_t>(waiting));
  archive.put(name + "/target", std::span<const double>(target));
  archive.put(name + "/entered", std::span<const std::int64_t>(entered));
  archive.put(name + "/mean_force", std::span<const double>(mean_force));
  archive.put(name + "/outside_points", std::span<const std::int64_t>(outside_points));
  archive.put(name + "/outside", std::span<const double>(outside));
}

template <class T, int D>
std::vector<std::vector<std::int32_t>> BodyCuts<T, D>::repeat(const Moves& moves,
                                                              Body<T, D>& body) {
  std::vector<std::vector<std::int32_t>> changed(blocks_.size());
  std::span<const double> places = moves.place;
  for (std::size_t i = 0; i < moves.blade.size();) {
    has_moved_ = false;
    const double now = moves.time[i];
    for (; i < moves.blade.size() && moves.time[i] == now; ++i) {
      const auto blade = static_cast<std::size_t>(moves.blade[i]);
      if (moves.points[i] == 0) {
        end_cut(blades_[blade]);
      } else {
        move_blade(blade, take_points<D>(places, moves.points[i]), now);
      }
    }
    if (faces_ && has_moved_) faces_->follow(bonds_);
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const std::vector<std::int32_t>& nodes = bonds_.update(b);
      changed[b].insert(changed[b].end(), nodes.begin(), nodes.end());
      for (const std::int32_t slot : nodes) {
        if (!keeps_bonds_of(slot)) dissolve_group(slot, body, changed[b]);
      }
    }
  }
  return changed;
}

template <class T, int D>
void BodyCuts<T, D>::get_punctures(const ArchiveReader& archive, const std::string& name) {
  const auto entered = archive.get<std::int64_t>(name + "/entered");
  const auto mean_force = archive.get<double>(name + "/mean_force");
  const auto points = archive.get<std::int64_t>(name + "/outside_points");
  const auto outside = archive.get<double>(name + "/outside");
  std::span<const double> places = outside;
  for (std::size_t b = 0; b < blades_.size(); ++b) {
    blades_[b].outside = take_points<D>(places, points.at(b));
    if (entered.at(b) != 0) {
      blades_[b].puncture.reset();
    } else {
      blades_[b].puncture->set_mean_force(mean_force.at(b));
    }
  }
}

template <class T, int D>
void BodyCuts<T, D>::get(const ArchiveReader& archive, const std::string& name, Body<T, D>& body) {
  Moves moves;
  moves.blade = archive.get<std::int64_t>(name + "/blade");
  moves.points = archive.get<std::int64_t>(name + "/points");
  moves.place = archive.get<double>(name + "/place");
  moves.time = archive.get<double>(name + "/time");
  std::vector<std::vector<std::int32_t>> changed = repeat(moves, body);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    std::vector<std::int32_t>& slots = changed[b];
    std::sort(slots.begin(), slots.end());
    slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
    for (const std::int32_t slot : slots) set_bonds_of(slot, body);
    std::erase_if(slots, [&](std::int32_t slot) { return !is_relaxing(body, slot); });
    blocks_[b].relaxing = std::move(slots);
  }
  if (faces_) faces_->find_nodes(body, *tissue_);
  const auto done = archive.get<std::int64_t>(name + "/is_done");
  const auto put = archive.get<std::int64_t>(name + "/is_put");
  const auto waiting = archive.get<std::int64_t>(name + "/waiting");
  const auto target = archive.get<double>(name + "/target");
  std::span<const double> places = target;
  for (std::size_t b = 0; b < blades_.size(); ++b) {
    blades_[b].is_done = done.at(b) != 0;
    blades_[b].is_put = put.at(b) != 0;
    blades_[b].target = take_points<D>(places, waiting.at(b));
  }
  get_punctures(archive, name);
}

template std::vector<std::vector<std::int32_t>> BodyCuts<double, 2>::repeat(const Moves&,
                                                                            Body<double, 2>&);
template std::vector<std::vector<std::int32_t>> BodyCuts<double, 3>::repeat(const Moves&,
                                                                            Body<double, 3>&);
template std::vector<std::vector<std::int32_t>> BodyCuts<float, 2>::repeat(const Moves&,
                                                                           Body<float, 2>&);
template std::vector<std::vector<std::int32_t>> BodyCuts<float, 3>::repeat(const Moves&,
                                                                           Body<float, 3>&);
template void BodyCuts<double, 2>::get_punctures(const ArchiveReader&, const std::string&);
template void BodyCuts<double, 3>::get_punctures(const ArchiveReader&, const std::string&);
template void BodyCuts<float, 2>::get_punctures(const ArchiveReader&, const std::string&);
template void BodyCuts<float, 3>::get_punctures(const ArchiveReader&, const std::string&);
template void BodyCuts<double, 2>::put(ArchiveWriter&, const std::string&) const;
template void BodyCuts<double, 3>::put(ArchiveWriter&, const std::string&) const;
template void BodyCuts<float, 2>::put(ArchiveWriter&, const std::string&) const;
template void BodyCuts<float, 3>::put(ArchiveWriter&, const std::string&) const;
template void BodyCuts<double, 2>::get(const ArchiveReader&, const std::string&, Body<double, 2>&);
template void BodyCuts<double, 3>::get(const ArchiveReader&, const std::string&, Body<double, 3>&);
template void BodyCuts<float, 2>::get(const ArchiveReader&, const std::string&, Body<float, 2>&);
template void BodyCuts<float, 3>::get(const ArchiveReader&, const std::string&, Body<float, 3>&);

}  // namespace pliant::point_based
