#include "engine/cli/command_model.hpp"

#include <algorithm>

namespace pliant::cli {

namespace {

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// The words of CLI::IsMember, which CLI11 shows as "{dot,json}" after the type.
std::vector<std::string> words_of(const std::string& type) {
  std::vector<std::string> words;
  const std::size_t begin = type.find('{'), end = type.find('}');
  if (begin == type.npos || end == type.npos) return words;
  std::string inside = type.substr(begin + 1, end - begin - 1);
  for (std::string& word : CLI::detail::split(inside, ',')) words.push_back(word);
  return words;
}

/// Arguments are files or folders, except for a few that are names.
Completion completion_of(const OptionModel& option) {
  if (!option.words.empty()) return Completion::words;
  if (option.value == "FOLDER" || option.argument == "FOLDER") return Completion::folders;
  const bool is_name = option.argument == "COMMAND" || option.argument == "NAME";
  const bool is_file =
      option.value == "FILE" || option.value == "CASE" || option.value == "PROGRAM";
  return is_file || (option.names.empty() && !is_name) ? Completion::files : Completion::none;
}

OptionModel model_of_option(const CLI::Option& option) {
  OptionModel model;
  for (const std::string& name : option.get_snames()) model.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) model.names.push_back("--" + name);
  if (model.names.empty()) model.argument = option.get_name();
  const std::string type = option.get_type_name();
  if (option.get_items_expected_max() > 0) model.value = type.substr(0, type.find(':'));
  model.description = one_line(option.get_description());
  model.required = option.get_required();
  model.repeatable = option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
  model.words = words_of(type);
  model.completion = completion_of(model);
  return model;
}

CommandModel model_of_command(const CLI::App& app) {
  CommandModel model{app.get_name(), one_line(app.get_description()), app.get_footer(), {}, {}, {}};
  for (const CLI::Option* option : app.get_options()) {
    const OptionModel one = model_of_option(*option);
    (one.names.empty() ? model.arguments : model.options).push_back(one);
  }
  const auto is_for_people = [](const CLI::App* command) { return !command->get_group().empty(); };
  for (const CLI::App* command : app.get_subcommands(is_for_people)) {
    model.commands.push_back(model_of_command(*command));
  }
  return model;
}

}  // namespace

CommandModel model_of(const CLI::App& app) {
  CommandModel model = model_of_command(app);
  for (CommandModel& command : model.commands) {
    for (OptionModel& argument : command.arguments) {
      if (argument.argument != "COMMAND") continue;
      argument.completion = Completion::words;
      for (const CommandModel& one : model.commands) argument.words.push_back(one.name);
    }
  }
  return model;
}

}  // namespace pliant::cli
