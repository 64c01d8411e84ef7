#include "engine/cli/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pliant::cli {

namespace {

std::vector<std::string> names_of(const std::vector<CommandModel>& commands) {
  std::vector<std::string> names;
  names.reserve(commands.size());
  for (const CommandModel& command : commands) names.push_back(command.name);
  return names;
}

/// All names of the options of a command.
std::vector<std::string> names_of(const std::vector<OptionModel>& options) {
  std::vector<std::string> names;
  for (const OptionModel& option : options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

std::string escaped(std::string_view text, std::string_view special, std::string_view by) {
  std::string result;
  for (const char letter : text) {
    if (special.find(letter) != special.npos) result += by;
    result += letter;
  }
  return result;
}

std::string bash_values(const OptionModel& option) {
  switch (option.completion) {
    case Completion::none:
      return "return";
    case Completion::files:
      return "compopt -o filenames; mapfile -t COMPREPLY < <(compgen -f -- \"$word\"); return";
    case Completion::folders:
      return "compopt -o filenames; mapfile -t COMPREPLY < <(compgen -d -- \"$word\"); return";
    case Completion::words:
      break;
  }
  return fmt::format("mapfile -t COMPREPLY < <(compgen -W '{}' -- \"$word\"); return",
                     fmt::join(option.words, " "));
}

/// Lines of the function for a command whose words begin at position `place`.
std::string bash_command(const CommandModel& command, int place, const std::string& indent) {
  std::string text;
  if (!command.commands.empty()) {
    text += fmt::format("{}case \"${{COMP_WORDS[{}]}}\" in\n", indent, place);
    for (const CommandModel& one : command.commands) {
      text +=
          fmt::format("{0}  {1})\n{0}    if ((COMP_CWORD > {2})); then\n{3}{0}    fi\n{0}    ;;\n",
                      indent, one.name, place, bash_command(one, place + 1, indent + "      "));
    }
    text += indent + "esac\n";
  }
  std::string values;
  for (const OptionModel& option : command.options) {
    if (option.value.empty()) continue;
    values +=
        fmt::format("{}  {}) {} ;;\n", indent, fmt::join(option.names, "|"), bash_values(option));
  }
  if (!values.empty()) {
    text += fmt::format("{0}case \"$previous\" in\n{1}{0}esac\n", indent, values);
  }
  std::vector<std::string> words = names_of(command.commands);
  for (const OptionModel& argument : command.arguments) {
    words.insert(words.end(), argument.words.begin(), argument.words.end());
  }
  const bool has_files = std::ranges::any_of(command.arguments, [](const OptionModel& argument) {
    return argument.completion == Completion::files || argument.completion == Completion::folders;
  });
  text += fmt::format(
      "{0}if [[ $word == -* ]]; then mapfile -t COMPREPLY < <(compgen -W '{1}' -- \"$word\"); "
      "return; fi\n",
      indent, fmt::join(names_of(command.options), " "));
  if (!words.empty()) {
    text += fmt::format("{}mapfile -t COMPREPLY < <(compgen -W '{}' -- \"$word\")\n", indent,
                        fmt::join(words, " "));
  }
  if (has_files) {
    text += indent + "compopt -o filenames\n" + indent +
            "mapfile -t -O \"${#COMPREPLY[@]}\" COMPREPLY < <(compgen -f -- \"$word\")\n";
  }
  return text + indent + "return\n";
}

std::string zsh_values(const OptionModel& option) {
  switch (option.completion) {
    case Completion::none:
      return " ";
    case Completion::files:
      return "_files";
    case Completion::folders:
      return "_files -/";
    case Completion::words:
      break;
  }
  return fmt::format("({})", fmt::join(option.words, " "));
}

/// One argument of _arguments for each name of an option.
std::string zsh_option(const OptionModel& option, const std::string& indent) {
  std::string text;
  for (const std::string& name : option.names) {
    text += fmt::format(" \\\n{}'{}{}[{}]", indent, option.repeatable ? "*" : "", name,
                        escaped(escaped(option.description, "[]:", "\\"), "'", "'\\'"));
    if (!option.value.empty()) text += fmt::format(":{}:{}", option.value, zsh_values(option));
    text += "'";
  }
  return text;
}

std::string zsh_described(const std::vector<CommandModel>& commands) {
  std::string text;
  for (const CommandModel& command : commands) {
    text += fmt::format(" '{}:{}'", command.name, escaped(command.description, "'", "'\\'"));
  }
  return text;
}

std::string zsh_command(const CommandModel& command, const std::string& indent) {
  std::string text;
  if (!command.commands.empty()) {
    text += fmt::format("{0}local -a commands_{1}=({2})\n{0}case $words[2] in\n", indent,
                        command.name, zsh_described(command.commands));
    for (const CommandModel& one : command.commands) {
      text += fmt::format(
          "{0}  {1})\n{0}    if ((CURRENT > 2)); then\n{0}      shift words; ((CURRENT--))\n"
          "{2}{0}      return\n{0}    fi ;;\n",
          indent, one.name, zsh_command(one, indent + "      "));
    }
    text += fmt::format("{0}esac\n{0}((CURRENT == 2)) && _describe command commands_{1}\n", indent,
                        command.name);
  }
  text += indent + "_arguments";
  for (const OptionModel& option : command.options) text += zsh_option(option, indent + "  ");
  for (const OptionModel& argument : command.arguments) {
    text += fmt::format(" \\\n{}  ':{}:{}'", indent, argument.argument, zsh_values(argument));
  }
  return text + "\n";
}

std::string fish_values(const OptionModel& option) {
  switch (option.completion) {
    case Completion::none:
      return option.value.empty() ? "" : " -x";
    case Completion::files:
      return " -r -F";
    case Completion::folders:
      return " -x -a '(__fish_complete_directories)'";
    case Completion::words:
      break;
  }
  return fmt::format(" -x -a '{}'", fmt::join(option.words, " "));
}

std::string fish_described(const std::string& description) {
  return escaped(description, "'\\", "\\");
}

std::string fish_command(const CommandModel& command, const std::string& condition) {
  std::string text;
  for (const OptionModel& option : command.options) {
    text += fmt::format("complete -c pliant -n '{}'", condition);
    for (const std::string& name : option.names) {
      text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    }
    text += fmt::format("{} -d '{}'\n", fish_values(option), fish_described(option.description));
  }
  for (const OptionModel& argument : command.arguments) {
    if (argument.completion == Completion::none) continue;
    text += fmt::format("complete -c pliant -n '{}'{}\n", condition,
                        argument.completion == Completion::words
                            ? fmt::format(" -f -a '{}'", fmt::join(argument.words, " "))
                            : " -F");
  }
  return text;
}

}  // namespace

std::string bash_completion(const CommandModel& program) {
  return "# Completion of pliant for bash. Written by `pliant completion bash`.\n"
         "_pliant() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}\n"
         "  COMPREPLY=()\n" +
         bash_command(program, 1, "  ") +
         "}\n"
         "complete -F _pliant pliant\n";
}

std::string zsh_completion(const CommandModel& program) {
  return "#compdef pliant\n"
         "# Completion of pliant for zsh. Written by `pliant completion zsh`.\n"
         "_pliant() {\n" +
         zsh_command(program, "  ") +
         "}\n"
         "_pliant \"$@\"\n";
}

std::string fish_completion(const CommandModel& program) {
  std::string text =
      "# Completion of pliant for fish. Written by `pliant completion fish`.\n"
      "complete -c pliant -f\n" +
      fish_command(program, "__fish_use_subcommand");
  for (const CommandModel& command : program.commands) {
    text += fmt::format("complete -c pliant -n __fish_use_subcommand -f -a {} -d '{}'\n",
                        command.name, fish_described(command.description));
    const std::string taken = "__fish_seen_subcommand_from " + command.name;
    text += fish_command(command, taken);
    for (const CommandModel& one : command.commands) {
      text += fmt::format("complete -c pliant -n '{}' -f -a {} -d '{}'\n", taken, one.name,
                          fish_described(one.description));
      text += fish_command(one, taken + "; and __fish_seen_subcommand_from " + one.name);
    }
  }
  return text;
}

}  // namespace pliant::cli
