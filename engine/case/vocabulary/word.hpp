#pragma once

#include <array>
#include <span>
#include <string_view>

namespace pliant {

/// One value of an enumeration, with its spelling in case files.
struct Word {
  int value;
  std::string_view text;
  std::string_view meaning;
};

/// All words of the enumeration `E`, in the order of the reference.
template <class E>
inline constexpr std::array<Word, 0> words{};

template <class E>
constexpr Word word(E value, std::string_view text, std::string_view meaning) {
  return {static_cast<int>(value), text, meaning};
}

/// The word for a value, from `known`.
constexpr std::string_view text_of(std::span<const Word> known, int value) {
  for (const Word& word : known) {
    if (word.value == value) return word.text;
  }
  return {};
}

/// The word for `value`.
template <class E>
constexpr std::string_view text_of(E value) {
  return text_of(words<E>, static_cast<int>(value));
}

/// The words of a table whose rows are in the order of their enumerators.
template <class E, class Row, std::size_t size>
constexpr std::array<Word, size> words_of(const std::array<Row, size>& rows) {
  std::array<Word, size> list{};
  for (std::size_t i = 0; i < size; ++i) {
    list[i] = word(static_cast<E>(i), rows[i].word, rows[i].meaning);
  }
  return list;
}

/// Whether each row i of a table belongs to enumerator i.
template <class Row, std::size_t size>
constexpr bool is_in_order(const std::array<Row, size>& rows) {
  for (std::size_t i = 0; i < size; ++i) {
    if (static_cast<std::size_t>(rows[i].kind) != i) return false;
  }
  return true;
}

}  // namespace pliant
