#include "engine/report/page.hpp"

#include <cassert>

// The bundle is part of the program, so that a report needs no other file.
asm(R"(
    .section .rodata
    .global pliant_report_page
    .global pliant_report_page_end
    .type pliant_report_page, @object
    .type pliant_report_page_end, @object
pliant_report_page:
    .incbin ")" PLIANT_REPORT_PAGE R"("
pliant_report_page_end:
    .byte 0
    .previous
)");

extern "C" {
extern const char pliant_report_page[];
extern const char pliant_report_page_end[];
}

namespace pliant::report {
namespace {

/// Escapes text between tags.
std::string escaped(std::string_view text) {
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text) {
    if (c == '<')
      safe += "&lt;";
    else if (c == '&')
      safe += "&amp;";
    else
      safe += c;
  }
  return safe;
}

/// Escapes JSON so that no tag in it can end the script that contains it.
std::string without_tags(std::string_view json) {
  std::string safe;
  safe.reserve(json.size());
  for (const char c : json) {
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  }
  return safe;
}

/// Copies `page` up to `place`, and continues after it.
void copy_until(std::string_view place, std::string_view& page, std::string& text) {
  const auto found = page.find(place);
  assert(found != page.npos);
  text += page.substr(0, found);
  page.remove_prefix(found + place.size());
}

}  // namespace

std::string_view empty_page() {
  return {pliant_report_page,
          static_cast<std::size_t>(pliant_report_page_end - pliant_report_page)};
}

std::string page_of(std::string_view title, std::string_view json,
                    const std::vector<std::string>& frames) {
  std::string_view page = empty_page();
  std::size_t size = page.size() + 2 * json.size();
  for (const auto& frame : frames) size += frame.size() + 80;
  std::string text;
  text.reserve(size);
  copy_until("<!--title-->", page, text);
  text += escaped(title);
  copy_until("<!--run-->", page, text);
  text += without_tags(json);
  copy_until("<!--frames-->", page, text);
  for (const auto& frame : frames) {
    text += R"(<script type="application/octet-stream" class="frame">)";
    text += frame;
    text += "</script>\n";
  }
  return text += page;
}

}  // namespace pliant::report
