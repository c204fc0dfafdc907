#include "tools/cli/explain_command.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "interpreter/runtime/reference.h"
#include "machine/base/letters.h"
#include "tools/cli/messages.h"
#include "tools/cli/refusal_document.h"
#include "tools/cli/write_out.h"
#include "tools/manual/manual.h"
#include "tools/manual/pages.h"
#include "tools/session/manual.h"

namespace g31::cli {
namespace {

using Json = nlohmann::ordered_json;

/// "alarm 112" and "exit code 4" may come as several arguments: a head takes what is behind it
/// along.
std::vector<std::string> joined_topics(const std::vector<std::string>& arguments) {
  std::vector<std::string> topics;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string head = in_small_letters(arguments[i]);
    topics.push_back(arguments[i]);
    if (head == "exit" && i + 1 < arguments.size() &&
        in_small_letters(arguments[i + 1]) == "code") {
      ++i;
    }
    const bool is_head = head == "alarm" || head == "parameter" || head == "exit";
    if (is_head && i + 1 < arguments.size()) {
      topics.back() += ' ' + arguments[++i];
    }
  }
  return topics;
}

runtime::Entry entry_of_exit(const ExitCodeRow& row) {
  return {
      "exit code", fmt::format("exit {}", static_cast<int>(row.code)), std::string(row.text), {}};
}

/// "exit 4", "exit code 4"
runtime::Entries exit_entries(const std::string& topic) {
  std::string asked = in_small_letters(topic);
  if (constexpr std::string_view kLong = "exit code "; asked.starts_with(kLong)) {
    asked = "exit " + asked.substr(kLong.size());
  }
  runtime::Entries found;
  for (const ExitCodeRow& row : exit_codes()) {
    runtime::Entry entry = entry_of_exit(row);
    if (entry.name == asked) {
      found.push_back(std::move(entry));
    }
  }
  return found;
}

runtime::Entries everything_of(const session::Control& control) {
  runtime::Entries all = manual::everything(control);
  std::ranges::transform(exit_codes(), std::back_inserter(all), entry_of_exit);
  return all;
}

std::string text_of(const runtime::Entry& entry) {
  std::string text = fmt::format("{} ({})\n  {}\n", entry.name, entry.kind,
                                 entry.text.empty() ? "no more is known" : entry.text);
  for (const runtime::Fact& fact : entry.facts) {
    text += fmt::format("    {}: {}\n", fact.name, fact.value);
  }
  return text;
}

Json json_of(const runtime::Entry& entry) {
  Json object = {{"kind", entry.kind}, {"name", entry.name}, {"text", entry.text}};
  object["facts"] = Json::object();
  for (const runtime::Fact& fact : entry.facts) {
    object["facts"][fact.name] = fact.value;
  }
  return object;
}

/// What a topic that nothing is named by was found in.
struct Found {
  std::string words;
  runtime::Entries entries;
  std::optional<session::Control> named_by;  ///< another control that has something of this name
};

std::string text_of(const Found& found) {
  std::string text = fmt::format("'{}' is found in:\n", found.words);
  for (const runtime::Entry& entry : found.entries) {
    text += fmt::format("  {} ({}): {}\n", entry.name, entry.kind, entry.text);
  }
  if (found.named_by) {
    text += fmt::format("--control {} has something that is named so\n",
                        session::name_of(*found.named_by));
  }
  return text;
}

/// What is known of all topics.
struct Answer {
  runtime::Entries entries;
  std::vector<Found> found;
  std::vector<session::Refusal> unknown;  ///< why there is nothing of the others
};

std::string text_of(const Answer& answer) {
  std::string text;
  for (const runtime::Entry& entry : answer.entries) {
    text += text_of(entry);
  }
  for (const Found& found : answer.found) {
    text += text_of(found);
  }
  return text;
}

std::string document_of(const Answer& answer, std::string_view control) {
  Json document = {{"schema", "g31.explain/1"}, {"control", control}};
  document["entries"] = Json::array();
  for (const runtime::Entry& entry : answer.entries) {
    document["entries"].push_back(json_of(entry));
  }
  for (const Found& found : answer.found) {
    Json entries = Json::array();
    for (const runtime::Entry& entry : found.entries) {
      entries.push_back(json_of(entry));
    }
    document["found"].push_back({{"words", found.words}, {"entries", std::move(entries)}});
  }
  if (!answer.unknown.empty()) {
    document["status"] = "usage";
    document["exit_code"] = static_cast<int>(ExitCode::BadUsage);
    document["diagnostics"] = Json::array();
  }
  for (const session::Refusal& one : answer.unknown) {
    document["diagnostics"].push_back(
        {{"severity", "error"}, {"code", ""}, {"message", one.message}});
  }
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string unknown_text(const std::string& topic, const session::Control& control,
                         const session::Suggestion& suggestion) {
  if (suggestion.other_control) {
    return fmt::format("{} does not know '{}', --control {} does", session::name_of(control), topic,
                       session::name_of(*suggestion.other_control));
  }
  const auto nearest =
      suggestion.nearest_topic ? suggestion.nearest_topic : manual::nearest_name_of(topic);
  return fmt::format("nothing is known about '{}'{}", topic,
                     nearest ? fmt::format(", did you mean '{}'?", *nearest)
                             : fmt::format(": write {}", suggestion.examples));
}

/// What the first control that knows a topic has of it, and whose it is.
runtime::Entries entries_of_other_control(const std::string& topic) {
  for (const session::Control& other : session::all_controls()) {
    runtime::Entries named = manual::explain(topic, other);
    for (runtime::Entry& entry : named) {
      entry.facts.push_back({"control", std::string(session::name_of(other))});
    }
    if (!named.empty()) {
      return named;
    }
  }
  return {};
}

/// Adds what is named by the topic, else what it is found in, else why there is neither.
void add_topic(const std::string& topic, const ExplainOptions& options,
               const session::Control& control, Answer& answer) {
  runtime::Entries named = options.search ? runtime::Entries() : manual::explain(topic, control);
  std::ranges::move(options.search ? runtime::Entries() : exit_entries(topic),
                    std::back_inserter(named));
  if (!named.empty()) {
    std::ranges::move(named, std::back_inserter(answer.entries));
    return;
  }
  const session::Suggestion suggestion = session::suggestion_for(topic, control);
  runtime::Entries found = manual::search(everything_of(control), topic);
  if (!found.empty()) {
    answer.found.push_back({topic, std::move(found), suggestion.other_control});
    return;
  }
  named = options.search || !options.control.empty() ? runtime::Entries()
                                                     : entries_of_other_control(topic);
  if (!named.empty()) {
    std::ranges::move(named, std::back_inserter(answer.entries));
    return;
  }
  answer.unknown.push_back(session::bad_input(unknown_text(topic, control, suggestion)));
}

/// A page of docs, as the tables make it.
ExitCode print_page(const std::string& name) {
  std::vector<std::string_view> known;
  for (const manual::Page& page : manual::pages()) {
    if (page.name == name) {
      const auto wrong = write_out("-", page.make());
      return wrong ? refuse(*wrong) : ExitCode::Completed;
    }
    known.push_back(page.name);
  }
  std::fputs(
      fmt::format("g31: error: there is no page '{}'; there are {}\n", name, fmt::join(known, ", "))
          .c_str(),
      stderr);
  return ExitCode::BadUsage;
}

}  // namespace

ExitCode explain_command(const ExplainOptions& options) {
  if (!options.page.empty()) {
    return print_page(options.page);
  }
  const auto control = options.control.empty() ? session::default_control()
                                               : session::control_named(options.control);
  if (!control) {
    return refuse(session::bad_setup(control.error()), options.json, "g31.explain/1");
  }
  Answer answer;
  if (options.all) {
    answer.entries = everything_of(control.value());
  }
  for (const std::string& topic : joined_topics(options.topics)) {
    add_topic(topic, options, control.value(), answer);
  }
  for (const session::Refusal& unknown : answer.unknown) {
    (void)refuse(unknown);
  }
  const auto wrong = write_result(
      options.json, [&] { return text_of(answer); },
      [&] { return document_of(answer, session::name_of(control.value())); });
  if (wrong) {
    return refuse(*wrong);
  }
  return answer.unknown.empty() ? ExitCode::Completed : ExitCode::BadUsage;
}

}  // namespace g31::cli
