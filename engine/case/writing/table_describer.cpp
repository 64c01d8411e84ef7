#include "engine/case/writing/table_describer.hpp"

namespace pliant {
namespace {

std::string word_line(const Word& word) {
  return fmt::format("- `\"{}\"`: {}\n", word.text, word.meaning);
}

}  // namespace

std::string type_of(const WallFriction&) {
  std::string texts;
  for (const Word& word : wall_frictions()) {
    texts += fmt::format("{}`\"{}\"`", texts.empty() ? "" : ", ", word.text);
  }
  return texts;
}

const Case& TableDescriber::empty_case() {
  static const Case empty;
  return empty;
}

void TableDescriber::add_row(std::string_view key, const std::string& columns) {
  const std::string_view choice = choices_.empty() ? "" : choices_[choice_].text;
  for (Row& row : rows_) {
    if (row.key != key || row.columns != columns) continue;
    row.choices.push_back(choice);
    return;
  }
  rows_.push_back({std::string(key), columns, {choice}});
}

void TableDescriber::list_words(std::string_view key, std::span<const Word> known) {
  std::string list = fmt::format("`{}`:\n\n", key);
  for (const Word& word : known) {
    if (word.meaning.empty()) return;
    list += word_line(word);
  }
  if (std::find(word_lists_.begin(), word_lists_.end(), list) == word_lists_.end()) {
    word_lists_.push_back(list);
  }
}

std::string TableDescriber::choices_of(const Row& row) const {
  if (row.choices.size() >= choices_.size()) return "all";
  if (2 * row.choices.size() <= choices_.size()) {
    return fmt::format("{}", fmt::join(row.choices, ", "));
  }
  std::vector<std::string_view> others;
  for (const Word& word : choices_) {
    const auto found = std::find(row.choices.begin(), row.choices.end(), word.text);
    if (found == row.choices.end()) others.push_back(word.text);
  }
  return fmt::format("all but {}", fmt::join(others, ", "));
}

std::string TableDescriber::text() const {
  const bool has_choices = choices_.size() > 1;
  std::string text =
      fmt::format("| key |{} type | unit | default | meaning |\n", has_choices ? " for |" : "");
  text += fmt::format("| --- |{} --- | --- | --- | --- |\n", has_choices ? " --- |" : "");
  for (const Row& row : rows_) {
    const std::string choices = has_choices ? fmt::format(" {} |", choices_of(row)) : "";
    text += fmt::format("| `{}` |{} {}\n", row.key, choices, row.columns);
  }
  if (has_choices) {
    text += "\n";
    for (const Word& word : choices_) text += word_line(word);
  }
  for (const std::string& list : word_lists_) text += "\n" + list;
  return text;
}

}  // namespace pliant
