#include "tools/cli/explain_command.h"

#include <algorithm>
#include <cstdio>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "interpreter/runtime/reference.h"
#include "tools/cli/messages.h"
#include "tools/evaluate/manual.h"
#include "tools/session/manual.h"

namespace g31::cli {
namespace {

using Json = nlohmann::ordered_json;

/// "alarm 112" may come as two arguments: a head takes the argument behind it along.
std::vector<std::string> joined_topics(const std::vector<std::string>& arguments) {
  std::vector<std::string> topics;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    std::string head = arguments[i];
    std::ranges::transform(head, head.begin(), [](char c) {
      return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    const bool is_head = head == "alarm" || head == "parameter";
    topics.push_back(arguments[i]);
    if (is_head && i + 1 < arguments.size()) {
      topics.back() += ' ' + arguments[++i];
    }
  }
  return topics;
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

void print(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
}

void print_text(const runtime::Entries& entries) {
  std::string text;
  for (const runtime::Entry& entry : entries) {
    text += text_of(entry);
  }
  print(text);
}

void print_json(const runtime::Entries& entries, std::string_view control) {
  Json document = {{"schema", "g31.explain/1"}, {"control", control}};
  document["entries"] = Json::array();
  for (const runtime::Entry& entry : entries) {
    document["entries"].push_back(json_of(entry));
  }
  print(document.dump(2) + "\n");
}

std::string unknown_text(const std::string& topic, const session::Control& control) {
  const session::Suggestion suggestion = session::suggestion_for(topic, control);
  if (suggestion.other_control) {
    return fmt::format("g31: error: {} does not know '{}', --control {} does\n",
                       session::name_of(control), topic,
                       session::name_of(*suggestion.other_control));
  }
  return fmt::format("g31: error: nothing is known about '{}'{}\n", topic,
                     suggestion.nearest_topic
                         ? fmt::format(", did you mean '{}'?", *suggestion.nearest_topic)
                         : fmt::format(": write {}", suggestion.examples));
}

}  // namespace

ExitCode explain_command(const ExplainOptions& options) {
  const auto control = options.control.empty() ? session::default_control()
                                               : session::control_named(options.control);
  if (!control) {
    return refuse(session::bad_setup(control.error()));
  }
  runtime::Entries entries;
  if (options.all) {
    entries = session::everything(control.value());
    std::ranges::move(evaluate::everything(), std::back_inserter(entries));
  }
  ExitCode code = ExitCode::Completed;
  for (const std::string& topic : joined_topics(options.topics)) {
    runtime::Entries found = session::explain(topic, control.value());
    std::ranges::move(evaluate::explain(topic), std::back_inserter(found));
    if (found.empty()) {
      std::fputs(unknown_text(topic, control.value()).c_str(), stderr);
      code = ExitCode::BadUsage;
    }
    std::ranges::move(found, std::back_inserter(entries));
  }
  if (options.json) {
    print_json(entries, session::name_of(control.value()));
  } else {
    print_text(entries);
  }
  return code;
}

}  // namespace g31::cli
