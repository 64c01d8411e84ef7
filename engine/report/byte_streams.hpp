#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// Numbers as text in a page; page/decode.js decodes them.
namespace pliant::report {

/// Appends `values`: one byte for the prediction (0: the number before; 1: the same number of
/// `before`), then the differences from it as 2 w or -2 w - 1, lowest bytes first. `before` is used
/// if it has as many numbers and gives smaller differences.
void append_numbers(std::string& bytes, const std::vector<std::uint16_t>& values,
                    const std::vector<std::uint16_t>& before);
void append_numbers(std::string& bytes, const std::vector<std::uint32_t>& values);

/// A zlib stream (RFC 1950).
std::string deflated(std::string_view bytes);

/// RFC 4648.
std::string base64(std::string_view bytes);

}  // namespace pliant::report
