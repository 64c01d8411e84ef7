#include "engine/cli/manual.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pliant/version.hpp>

namespace pliant::cli {

namespace {

/// Escapes text for roff.
std::string literal(std::string_view text) {
  std::string result;
  for (const char letter : text) {
    const bool begins_line = result.empty() || result.back() == '\n';
    if (begins_line && (letter == '.' || letter == '\'')) result += "\\&";
    if (letter == '\\')
      result += "\\e";
    else if (letter == '-')
      result += "\\-";
    else
      result += letter;
  }
  return result;
}

std::string options_of(const std::vector<OptionModel>& options) {
  std::string text;
  for (const OptionModel& option : options) {
    text += ".TP\n";
    if (option.names.empty()) {
      text += fmt::format("\\fI{}\\fR\n", literal(option.argument));
    } else {
      text += fmt::format("\\fB{}\\fR", literal(fmt::format("{}", fmt::join(option.names, ", "))));
      if (!option.value.empty()) text += fmt::format(" \\fI{}\\fR", literal(option.value));
      text += "\n";
    }
    text += literal(option.description) + "\n";
    if (!option.words.empty() && !option.names.empty()) {
      text += literal(fmt::format("({})", fmt::join(option.words, ", "))) + "\n";
    }
  }
  return text;
}

std::string synopsis_of(const std::string& name, const CommandModel& command) {
  std::string text = fmt::format("\\fB{}\\fR", literal(name));
  for (const OptionModel& argument : command.arguments) {
    const std::string shown = fmt::format("\\fI{}\\fR", literal(argument.argument));
    text += argument.required ? " " + shown : fmt::format(" [{}]", shown);
  }
  return text + (command.options.empty() ? "" : " [\\fIoptions\\fR]");
}

std::string section_of(const std::string& name, const CommandModel& command) {
  std::string text =
      fmt::format(".SS {}\n{}.\n", synopsis_of(name, command), literal(command.description));
  text += options_of(command.arguments) + options_of(command.options);
  if (!command.footer.empty()) {
    text += fmt::format(".PP\n.nf\n{}\n.fi\n", literal(command.footer));
  }
  for (const CommandModel& one : command.commands) text += section_of(name + " " + one.name, one);
  return text;
}

constexpr std::string_view ending = R"roff(.SH EXIT STATUS
.TP
0
Done.
.TP
1
What was measured does not reach what was asked for.
.TP
2
Bad usage or bad input; the message says where, what is wrong, and what to do.
.TP
3
The run failed; the last good state is kept.
.TP
4
Interrupted; \fB\-\-resume\fR continues.
.SH ENVIRONMENT
.TP
NO_COLOR
If it is set and not empty, messages on a terminal have no colour.
.SH FILES
Cases are in \fIshare/pliant/cases\fR, the documentation in \fIshare/doc/pliant\fR, and the JSON Schema of
case files in \fIshare/pliant/case.schema.json\fR, all below the folder in which the program is installed.
)roff";

}  // namespace

std::string manual_page(const CommandModel& program) {
  std::string text = fmt::format(
      ".\\\" Written by `pliant manual`.\n.TH PLIANT 1 \"\" \"pliant {}\" \"User Commands\"\n"
      ".SH NAME\npliant \\- {}\n.SH SYNOPSIS\n",
      version, literal("simulates elastic solids and soft tissue with particles"));
  for (const CommandModel& command : program.commands) {
    text += synopsis_of("pliant " + command.name, command) + "\n.br\n";
  }
  text += ".SH OPTIONS\n" + options_of(program.options) + ".SH COMMANDS\n";
  for (const CommandModel& command : program.commands) {
    text += section_of("pliant " + command.name, command);
  }
  return text + std::string(ending);
}

}  // namespace pliant::cli
