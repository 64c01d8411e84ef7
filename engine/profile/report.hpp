#pragma once

#include <string>

#include "engine/profile/deadlines.hpp"
#include "engine/profile/profile.hpp"

namespace pliant::profile {

/// The results of a profile for users, at most 100 columns wide.
std::string text_of(const Profile& profile, const Verdict& verdict);

/// The same for programs, with every frame and step; docs/profiling.md lists the keys.
std::string json_of(const Profile& profile, const Verdict& verdict);

/// "1.23 s", "16.7 ms", "120 us".
std::string short_time(double seconds);

}  // namespace pliant::profile
