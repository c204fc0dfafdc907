#include "tools/cli/completion.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "machine/base/contract.h"

namespace g31::cli {
namespace {

using Script = std::string (*)(const ProgramWords&);

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

/// A text between ' and ' of a shell.
std::string quoted(const std::string& text) {
  return "'" + replaced(text, "'", R"('\'')") + "'";
}

std::vector<std::string> names_of(const std::vector<OptionWords>& options) {
  std::vector<std::string> names;
  for (const OptionWords& option : options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

// ---- bash

/// What bash fills COMPREPLY by.
std::string bash_reply(const OptionWords& option) {
  switch (option.kind) {
    case ValueKind::File:
      return R"(-f -- "$word")";
    case ValueKind::Folder:
      return R"(-d -- "$word")";
    case ValueKind::Choice:
      return fmt::format(R"(-W '{}' -- "$word")", fmt::join(option.choices, " "));
    case ValueKind::Nothing:
    case ValueKind::Text:
      return {};
  }
  contract_violated("every kind of value is completed", __FILE__, __LINE__);
}

/// The first place that can be completed; behind a choice that was made, the one behind it.
std::string bash_places(const std::vector<OptionWords>& places) {
  std::string text;
  std::string when;
  for (const OptionWords& place : places) {
    const std::string reply = bash_reply(place);
    if (!reply.empty()) {
      text += fmt::format("      {}places=(compgen {})\n", when, reply);
    }
    if (place.kind == ValueKind::Choice) {
      when = fmt::format(R"([[ " ${{COMP_WORDS[*]:1:COMP_CWORD-1}} " == *' '@({})' '* ]] && )",
                         fmt::join(place.choices, "|"));
    } else if (!reply.empty()) {
      break;
    }
  }
  return text;
}

std::string bash_command(const CommandWords& command) {
  std::string text = fmt::format("    {})\n      case $before in\n", command.name);
  for (const OptionWords& option : command.options) {
    if (option.kind != ValueKind::Nothing) {
      const std::string reply = bash_reply(option);
      text += fmt::format(
          "        {}) {}return ;;\n", fmt::join(option.names, "|"),
          reply.empty()
              ? ""
              : fmt::format(
                    R"(mapfile -t COMPREPLY < <(compgen {}); COMPREPLY=("${{COMPREPLY[@]/#/$head}}"); )",
                    reply));
    }
  }
  text +=
      fmt::format("      esac\n      options='{}'\n", fmt::join(names_of(command.options), " "));
  return text + bash_places(command.places) + "      ;;\n";
}

std::string bash_script(const ProgramWords& words) {
  std::vector<std::string> commands;
  std::string cases;
  for (const CommandWords& command : words.commands) {
    commands.push_back(command.name);
    cases += bash_command(command);
  }
  const std::string& name = words.program.name;
  return fmt::format(R"(# bash completion of {0}; made by: {0} completion bash
_{0}() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} command='' options='' i
  local places=() head=''
  COMPREPLY=()
  # Of --option=value bash makes three words where = breaks words, else one.
  if [[ $word == = ]]; then
    word=''
  elif [[ $before == = ]]; then
    before=${{COMP_WORDS[COMP_CWORD-2]}}
  elif [[ $word == --*=* ]]; then
    head=${{word%%=*}}= before=${{word%%=*}} word=${{word#*=}}
  fi
  for ((i = 1; i < COMP_CWORD; i++)); do
    if [[ ${{COMP_WORDS[i]}} != -* ]]; then
      command=${{COMP_WORDS[i]}}
      break
    fi
  done
  case $command in
    '')
      options='{1}'
      places=(compgen -W '{2}' -- "$word")
      ;;
{3}    *) return ;;
  esac
  if [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
  elif ((${{#places[@]}} > 0)); then
    mapfile -t COMPREPLY < <("${{places[@]}}")
  fi
}}
complete -o filenames -o bashdefault -F _{0} {0}
)",
                     name, fmt::join(names_of(words.program.options), " "),
                     fmt::join(commands, " "), cases);
}

// ---- zsh

/// What _arguments does with a value.
std::string zsh_action(const OptionWords& option) {
  switch (option.kind) {
    case ValueKind::File:
      return "_files";
    case ValueKind::Folder:
      return "_files -/";
    case ValueKind::Choice:
      return fmt::format("({})", fmt::join(option.choices, " "));
    case ValueKind::Nothing:
    case ValueKind::Text:
      return " ";
  }
  contract_violated("every kind of value is completed", __FILE__, __LINE__);
}

/// A text within [ ] or before a colon of a specification.
std::string zsh_text(const std::string& text) {
  std::string plain;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') {
      plain += '\\';
    }
    plain += c;
  }
  return plain;
}

/// The specification of an option under each of its names, or of a place.
std::string zsh_specifications(const OptionWords& option, bool is_place) {
  std::string value;
  if (option.kind != ValueKind::Nothing) {
    const std::string& called = is_place ? option.names.front() : option.value;
    value = fmt::format(":{}:{}", zsh_text(called), zsh_action(option));
  }
  if (is_place) {
    return fmt::format(" \\\n        {}", quoted((option.is_repeatable ? "*" : "") + value));
  }
  std::string text;
  for (const std::string& name : option.names) {
    text += fmt::format(" \\\n        {}",
                        quoted(fmt::format("{}{}[{}]{}", option.is_repeatable ? "*" : "", name,
                                           zsh_text(option.text), value)));
  }
  return text;
}

std::string zsh_arguments(const CommandWords& command) {
  std::string text = "_arguments -s";
  for (const OptionWords& option : command.options) {
    text += zsh_specifications(option, false);
  }
  for (const OptionWords& place : command.places) {
    text += zsh_specifications(place, true);
  }
  return text;
}

std::string zsh_script(const ProgramWords& words) {
  std::string commands;
  std::string cases;
  for (const CommandWords& command : words.commands) {
    commands +=
        fmt::format("    {}\n", quoted(fmt::format("{}:{}", command.name, zsh_text(command.text))));
    cases += fmt::format("    {})\n      {}\n      ;;\n", command.name, zsh_arguments(command));
  }
  return fmt::format(R"(#compdef {0}
# made by: {0} completion zsh
_{0}() {{
  local context state state_descr line curcontext=$curcontext
  typeset -A opt_args
  local -a commands
  commands=(
{1}  )
  {2} \
        '1: :->command' '*:: :->words'
  case $state in
    command) _describe command commands ;;
    words)
      curcontext="${{curcontext%:*}}-$line[1]:"
      case $line[1] in
{3}      esac
      ;;
  esac
}}
if [ "$funcstack[1]" = _{0} ]; then
  _{0} "$@"
else
  compdef _{0} {0}
fi
)",
                     words.program.name, commands, zsh_arguments(words.program) + " -C", cases);
}

// ---- fish

std::string fish_option(const std::string& program, const std::string& when,
                        const OptionWords& option) {
  std::string line = fmt::format("complete -c {} -n {}", program, quoted(when));
  for (const std::string& name : option.names) {
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  switch (option.kind) {
    case ValueKind::File:
      line += " -r -F";
      break;
    case ValueKind::Folder:
      line += " -x -a '(__fish_complete_directories)'";
      break;
    case ValueKind::Choice:
      line += fmt::format(" -x -a '{}'", fmt::join(option.choices, " "));
      break;
    case ValueKind::Text:
      line += " -x";
      break;
    case ValueKind::Nothing:
      break;
  }
  return fmt::format("{} -d {}\n", line, quoted(option.text));
}

std::string fish_script(const ProgramWords& words) {
  const std::string& name = words.program.name;
  std::string text = fmt::format("# fish completion of {0}; made by: {0} completion fish\n", name);
  for (const OptionWords& option : words.program.options) {
    text += fish_option(name, "__fish_use_subcommand", option);
  }
  for (const CommandWords& command : words.commands) {
    text += fmt::format("complete -c {} -f -n __fish_use_subcommand -a {} -d {}\n", name,
                        command.name, quoted(command.text));
    const std::string when = "__fish_seen_subcommand_from " + command.name;
    for (const OptionWords& option : command.options) {
      text += fish_option(name, when, option);
    }
    for (const OptionWords& place : command.places) {
      if (place.kind == ValueKind::Choice) {
        const std::string choices = fmt::format("{}", fmt::join(place.choices, " "));
        text += fmt::format(
            "complete -c {} -n {} -f -a '{}'\n", name,
            quoted(fmt::format("{}; and not __fish_seen_subcommand_from {}", when, choices)),
            choices);
      }
    }
  }
  return text;
}

struct ShellRow {
  std::string_view name;
  Script script;
};

constexpr std::array kShells = {
    ShellRow{"bash", bash_script},
    ShellRow{"fish", fish_script},
    ShellRow{"zsh", zsh_script},
};

}  // namespace

std::vector<std::string> completion_shells() {
  std::vector<std::string> names;
  for (const ShellRow& row : kShells) {
    names.emplace_back(row.name);
  }
  return names;
}

std::string completion_script(const ProgramWords& words, std::string_view shell) {
  const auto* const row = std::ranges::find(kShells, shell, &ShellRow::name);
  G31_EXPECTS(row != kShells.end());
  return row->script(words);
}

}  // namespace g31::cli
