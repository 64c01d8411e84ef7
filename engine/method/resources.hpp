#pragma once

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "engine/method/field.hpp"
#include "scheduler/phase.hpp"

/// Resources: the fields of a method as the scheduler knows them, numbered by the list of groups.
namespace pliant {

/// The slots of a block that a resource covers; different phases write particles, ghosts and
/// images.
enum class Part { particles, ghosts, images };
inline constexpr int part_count = 3;

/// One group of fields.
template <class Group>
struct GroupDeclaration {
  Group group;
  std::string_view name;
  bool has_parts = false;                  ///< each Part is a resource of its own
  std::array<const char*, 3> copies = {};  ///< names of its copies; empty: there is one
};

/// A resource as its method names it.
template <class Group>
struct Resource {
  Group group;
  int copy = 0;
  Part part = Part::particles;
};

/// The numbers and names of resources, from a list of groups in the order of `Group`.
template <class Group, std::size_t n>
class ResourceNumbers {
 public:
  /// Keeps a reference to the list.
  constexpr explicit ResourceNumbers(const Table<Group, GroupDeclaration<Group>, n>& groups)
      : groups_(groups) {
    for (std::size_t g = 0; g < n; ++g) {
      const auto& group = groups[static_cast<Group>(g)];
      first_[g + 1] = first_[g] + copies(group) * parts(group);
    }
  }

  constexpr scheduler::FieldId operator()(const Resource<Group>& resource) const {
    const auto& group = groups_[resource.group];
    const int part = group.has_parts ? static_cast<int>(resource.part) : 0;
    return first_[static_cast<std::size_t>(resource.group)] + resource.copy * parts(group) + part;
  }

  constexpr Resource<Group> operator[](scheduler::FieldId id) const {
    const auto above = std::upper_bound(first_.begin(), first_.end(), id);
    const auto group = static_cast<Group>(above - first_.begin() - 1);
    const int of_group = id - *(above - 1), of_copy = parts(groups_[group]);
    return {group, of_group / of_copy, static_cast<Part>(of_group % of_copy)};
  }

  constexpr int count() const { return first_[n]; }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    names.reserve(count());
    for (scheduler::FieldId id = 0; id < count(); ++id) names.push_back(name((*this)[id]));
    return names;
  }

 private:
  static constexpr int copies(const GroupDeclaration<Group>& group) {
    int count = 0;
    for (const char* name : group.copies) count += name != nullptr ? 1 : 0;
    return std::max(count, 1);
  }
  static constexpr int parts(const GroupDeclaration<Group>& group) {
    return group.has_parts ? part_count : 1;
  }

  std::string name(const Resource<Group>& resource) const {
    const auto& group = groups_[resource.group];
    std::string name(group.name);
    if (resource.part == Part::ghosts) name += " of ghosts";
    if (resource.part == Part::images) name += " of images";
    const char* copy = group.copies[static_cast<std::size_t>(resource.copy)];
    return copy == nullptr ? name : name + ", " + copy;
  }

  const Table<Group, GroupDeclaration<Group>, n>& groups_;
  std::array<scheduler::FieldId, n + 1> first_ = {};
};

/// Several resources that a phase names together.
class Resources {
 public:
  Resources(std::initializer_list<scheduler::FieldId> ids) : ids_(ids) {}

  friend Resources operator+(Resources a, const Resources& b) {
    a.ids_.insert(a.ids_.end(), b.ids_.begin(), b.ids_.end());
    return a;
  }
  auto begin() const { return ids_.begin(); }
  auto end() const { return ids_.end(); }

 private:
  std::vector<scheduler::FieldId> ids_;
};

/// What a phase reads or writes: resources, and the blocks whose data it accesses.
class Accesses {
 public:
  Accesses() = default;
  Accesses(const Resources& resources, scheduler::Reach reach) {
    for (const scheduler::FieldId id : resources) list_.push_back({id, reach});
  }

  friend Accesses operator+(Accesses a, const Accesses& b) {
    a.list_.insert(a.list_.end(), b.list_.begin(), b.list_.end());
    return a;
  }
  operator std::vector<scheduler::Access>() const { return list_; }

 private:
  std::vector<scheduler::Access> list_;
};

/// Resources of the block that a phase works on.
inline Accesses own(const Resources& resources) { return {resources, scheduler::Reach::own}; }
/// Resources of that block and its neighbours.
inline Accesses near(const Resources& resources) {
  return {resources, scheduler::Reach::neighbours};
}
/// Resources of all blocks.
inline Accesses all(const Resources& resources) { return {resources, scheduler::Reach::all}; }

}  // namespace pliant
