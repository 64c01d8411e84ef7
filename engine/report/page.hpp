#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pliant::report {

/// The page with its style and scripts, without data: page/ bundled into one file.
std::string_view empty_page();

/// A complete page for a browser without a network, with the data `json` and base64 `frames`.
std::string page_of(std::string_view title, std::string_view json,
                    const std::vector<std::string>& frames);

}  // namespace pliant::report
