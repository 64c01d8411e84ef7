#include "engine/report/byte_streams.hpp"

#include <zlib.h>

#include <cstdlib>
#include <new>
#include <type_traits>

namespace pliant::report {
namespace {

template <class T>
void append(std::string& bytes, const std::vector<T>& values, const std::vector<T>* before) {
  const auto start = bytes.size() + 1, count = values.size();
  bytes.push_back(before ? 1 : 0);
  bytes.resize(start + sizeof(T) * count);
  T last = 0;
  for (std::size_t i = 0; i < count; ++i) {
    // Modulo the size of T, so that every difference fits.
    const T modulo = static_cast<T>(values[i] - (before ? (*before)[i] : last));
    const std::int64_t difference = static_cast<std::make_signed_t<T>>(modulo);
    auto code = static_cast<std::uint64_t>(difference < 0 ? -2 * difference - 1 : 2 * difference);
    for (std::size_t plane = 0; plane < sizeof(T); ++plane, code >>= 8)
      bytes[start + plane * count + i] = static_cast<char>(code & 0xFF);
    last = values[i];
  }
}

/// Sum of the absolute differences; smaller differences compress better.
std::int64_t roughness(const std::vector<std::uint16_t>& values,
                       const std::vector<std::uint16_t>* before) {
  std::int64_t sum = 0;
  std::int64_t last = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += std::abs(std::int64_t{values[i]} - (before ? (*before)[i] : last));
    last = values[i];
  }
  return sum;
}

}  // namespace

void append_numbers(std::string& bytes, const std::vector<std::uint16_t>& values,
                    const std::vector<std::uint16_t>& before) {
  const bool follows =
      before.size() == values.size() && roughness(values, &before) < roughness(values, nullptr);
  append(bytes, values, follows ? &before : nullptr);
}

void append_numbers(std::string& bytes, const std::vector<std::uint32_t>& values) {
  append<std::uint32_t>(bytes, values, nullptr);
}

std::string deflated(std::string_view bytes) {
  auto size = compressBound(bytes.size());
  std::string packed(size, '\0');
  // The bound suffices for any input: only a lack of memory can make this fail.
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 6) != Z_OK)
    throw std::bad_alloc();
  packed.resize(size);
  return packed;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto left = bytes.size() - i;
    const auto byte = [&](std::size_t k) {
      return k < left ? static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i + k])) : 0U;
    };
    const std::uint32_t three = byte(0) << 16 | byte(1) << 8 | byte(2);
    text += letters[three >> 18];
    text += letters[three >> 12 & 63];
    text += left > 1 ? letters[three >> 6 & 63] : '=';
    text += left > 2 ? letters[three & 63] : '=';
  }
  return text;
}

}  // namespace pliant::report
