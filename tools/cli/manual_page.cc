#include "tools/cli/manual_page.h"

#include <algorithm>

#include <fmt/format.h>

#include "machine/base/contract.h"
#include "machine/base/letters.h"
#include "tools/cli/exit_code.h"

namespace g31::cli {
namespace {

/// Of this version, as the changes of the Debian package have it (debian_files.cmake).
constexpr std::string_view kDate = "2026-11-22";

/// Bytes of a line in the page; mandoc -Tlint asks for 80 at most.
constexpr std::size_t kWidth = 78;

/// A line in pieces that are no longer than kWidth, broken at blanks.
/// @param joint  "" where lines are filled; the escape that joins them where they are not
std::string folded(std::string text, std::string_view joint) {
  std::string pieces;
  while (text.size() > kWidth) {
    const std::size_t blank = text.find_last_of(' ', kWidth);
    if (blank == std::string::npos || text.find_first_not_of(' ') > blank) {
      break;
    }
    pieces +=
        joint.empty() ? text.substr(0, blank) : text.substr(0, blank + 1) + std::string(joint);
    pieces += '\n';
    text.erase(0, blank + 1);
    if (text.starts_with('.')) {
      text.insert(0, "\\&");
    }
  }
  return pieces + text;
}

/// A line as it is: nothing in it is a request or an escape of roff.
std::string line(std::string_view text, std::string_view joint = "") {
  std::string plain;
  if (text.starts_with('.') || text.starts_with('\'')) {
    plain = "\\&";
  }
  for (const char c : text) {
    switch (c) {
      case '\\':
        plain += "\\e";
        break;
      case '-':
        plain += "\\-";
        break;
      case '\'':
        plain += "\\(aq";
        break;
      default:
        plain += c;
    }
  }
  return folded(plain, joint) + "\n";
}

std::string heading(const ProgramWords& words, const std::string& page, const std::string& text) {
  std::string title = line(in_capitals(page));
  title.pop_back();  // the heading goes on
  std::string small = text;
  if (small.ends_with('.')) {
    small.pop_back();
  }
  std::string named = line(fmt::format("{} - {}", page, small));
  return fmt::format(".TH {} 1 {} \"{} {}\" \"User Commands\"\n.SH NAME\n{}", title, kDate,
                     words.program.name, words.version, named);
}

std::string options(const std::vector<OptionWords>& rows) {
  std::string text;
  for (const OptionWords& row : rows) {
    std::string names;
    for (const std::string& name : row.names) {
      names += (names.empty() ? "" : ", ") + name;
    }
    if (!row.value.empty() && row.names.front().starts_with('-')) {
      names += " " + row.value;
    }
    text += fmt::format(".TP\n.B {}{}", line(names), line(row.text));
    if (!row.choices.empty()) {
      std::string choices;
      for (const std::string& choice : row.choices) {
        choices += (choices.empty() ? "" : ", ") + choice;
      }
      text += line(fmt::format("({})", choices));
    }
  }
  return text;
}

std::string section(std::string_view title, const std::string& body) {
  return body.empty() ? body : fmt::format(".SH {}\n{}", title, body);
}

/// Examples and lists keep their lines.
std::string as_it_is(const std::string& text) {
  std::string body;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find('\n', from), text.size());
    body += line(std::string_view(text).substr(from, to - from), "\\");
    from = to + 1;
  }
  return body.empty() ? body : ".nf\n" + body + ".fi\n";
}

/// @param command  "": any of them
std::string exit_status(std::string_view command) {
  std::string text;
  for (const ExitCodeRow& row : exit_codes_of(command)) {
    text += fmt::format(".TP\n.B {}\n{}", static_cast<int>(row.code), line(row.text));
  }
  return text;
}

/// What --help says behind the options: a page has a section of its own for examples.
struct Notes {
  std::string examples;  ///< without their heading
  std::string rest;
};

Notes split(const std::string& text) {
  constexpr std::string_view kHead = "Examples:\n";
  const std::size_t head = text.find(kHead);
  if (head == std::string::npos) {
    return {"", text};
  }
  const std::size_t begin = head + kHead.size();
  const std::size_t end = std::min(text.find("\n\n", begin), text.size());
  const std::size_t behind = std::min(text.find_first_not_of('\n', end), text.size());
  return {text.substr(begin, end - begin), text.substr(0, head) + text.substr(behind)};
}

std::string synopsis(const std::string& call, const CommandWords& command) {
  std::string text = ".B " + line(call);
  text += "[\\fIoptions\\fR]\n";
  for (const OptionWords& place : command.places) {
    const std::string name = place.names.front() + (place.is_repeatable ? "..." : "");
    text +=
        place.is_required ? fmt::format("\\fI{}\\fR\n", name) : fmt::format("[\\fI{}\\fR]\n", name);
  }
  return text;
}

std::string program_page(const ProgramWords& words) {
  std::string commands;
  std::string others;
  for (const CommandWords& command : words.commands) {
    commands += fmt::format(".TP\n.B {}{}", line(command.name), line(command.text));
    others += fmt::format("{}.BR {}\\-{} (1)", others.empty() ? "" : ",\n", words.program.name,
                          command.name);
  }
  const std::string& name = words.program.name;
  return heading(words, name, words.program.text) +
         section("SYNOPSIS", fmt::format(".B {}\n\\fIcommand\\fR [\\fIoptions\\fR]\n", name)) +
         section("COMMANDS", commands) + section("OPTIONS", options(words.program.options)) +
         section("EXIT STATUS", exit_status("")) + section("SEE ALSO", others + "\n");
}

}  // namespace

std::string manual_page(const ProgramWords& words, std::string_view command) {
  if (command.empty()) {
    return program_page(words);
  }
  const auto row = std::ranges::find(words.commands, command, &CommandWords::name);
  G31_EXPECTS(row != words.commands.end());
  const std::string& name = words.program.name;
  const Notes notes = split(row->notes);
  return heading(words, fmt::format("{}-{}", name, row->name), row->text) +
         section("SYNOPSIS", synopsis(fmt::format("{} {}", name, row->name), *row)) +
         section("DESCRIPTION", line(row->text)) + section("ARGUMENTS", options(row->places)) +
         section("OPTIONS", options(row->options)) + section("EXAMPLES", as_it_is(notes.examples)) +
         section("NOTES", as_it_is(notes.rest)) + section("EXIT STATUS", exit_status(row->name)) +
         section("SEE ALSO", fmt::format(".BR {} (1)\n", name));
}

}  // namespace g31::cli
