#include "engine/geometry/mesh_values.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pliant {

template <class Value>
Value MeshValues::take(std::string_view what) {
  if (at_ > file_->content.size() || file_->content.size() - at_ < sizeof(Value)) {
    file_->refuse_end(file_->content.size(), std::string(what));
  }
  start_ = at_;
  char bytes[sizeof(Value)];
  std::copy_n(file_->content.data() + at_, sizeof(Value), bytes);
  at_ += sizeof(Value);
  if (encoding_ == Encoding::big_endian) std::reverse(bytes, bytes + sizeof(Value));
  return value_at<Value>(bytes);
}

std::int64_t MeshValues::integer(int bytes, std::string_view what) {
  if (is_text()) {
    const std::string_view word = text_.word();
    if (word.empty()) file_->refuse_end(file_->content.size(), std::string(what));
    return text_.integer(word, what);
  }
  return bytes == 8 ? take<std::int64_t>(what) : take<std::int32_t>(what);
}

double MeshValues::real(int bytes, std::string_view what) {
  if (is_text()) {
    const std::string_view word = text_.word();
    if (word.empty()) file_->refuse_end(file_->content.size(), std::string(what));
    return text_.number(word, what);
  }
  return bytes == 8 ? take<double>(what) : static_cast<double>(take<float>(what));
}

std::int64_t MeshValues::count(int bytes, std::string_view what) {
  const std::int64_t value = integer(bytes, what);
  if (value < 0) refuse(fmt::format("{} is {}", what, value), std::string(save_again));
  return value;
}

void MeshValues::refuse(const std::string& what, const std::string& remedy) const {
  if (is_text()) file_->refuse_line(start(), what, remedy);
  file_->refuse_byte(start(), what, remedy);
}

}  // namespace pliant
