#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// Numbers as text that a page can hold. page/decode.js reads it back.
namespace pliant::report {

/// Appends `values` as one byte that names the prediction (0: the number before; 1: the same number
/// of `before`), and then the differences from it as 2 w or -2 w - 1, all lowest bytes first. The
/// prediction from `before` is taken where that has as many numbers and makes the smaller
/// differences.
void append_numbers(std::string& bytes, const std::vector<std::uint16_t>& values,
                    const std::vector<std::uint16_t>& before);
void append_numbers(std::string& bytes, const std::vector<std::uint32_t>& values);

/// A zlib stream (RFC 1950).
std::string deflated(std::string_view bytes);

/// RFC 4648.
std::string base64(std::string_view bytes);

}  // namespace pliant::report
