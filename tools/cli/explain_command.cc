#include "tools/cli/explain_command.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "interpreter/dialects/fanuc/reference/explain.h"
#include "tools/cli/chosen_profile.h"

namespace g31::cli {
namespace {

namespace reference = fanuc::reference;
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

std::string text_of(const reference::Entry& entry) {
  std::string text = fmt::format("{} ({})\n  {}\n", entry.name, entry.kind,
                                 entry.text.empty() ? "no more is known" : entry.text);
  for (const reference::Fact& fact : entry.facts) {
    text += fmt::format("    {}: {}\n", fact.name, fact.value);
  }
  return text;
}

Json json_of(const reference::Entry& entry) {
  Json object = {{"kind", entry.kind}, {"name", entry.name}, {"text", entry.text}};
  object["facts"] = Json::object();
  for (const reference::Fact& fact : entry.facts) {
    object["facts"][fact.name] = fact.value;
  }
  return object;
}

void print(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
}

void print_text(const reference::Entries& entries) {
  std::string text;
  for (const reference::Entry& entry : entries) {
    text += text_of(entry);
  }
  print(text);
}

void print_json(const reference::Entries& entries, const fanuc::Profile& profile) {
  Json document = {{"schema", "g31.explain/1"}, {"control", profile.name}};
  document["entries"] = Json::array();
  for (const reference::Entry& entry : entries) {
    document["entries"].push_back(json_of(entry));
  }
  print(document.dump(2) + "\n");
}

std::string unknown_text(const std::string& topic) {
  const auto nearest = reference::nearest_topic(topic);
  return fmt::format("g31: error: nothing is known about '{}'{}\n", topic,
                     nearest ? fmt::format(", did you mean '{}'?", *nearest)
                             : ": write #5061, G31, ATAN, GOTO, 'alarm 112' or 6001.1");
}

}  // namespace

ExitCode explain_command(const ExplainOptions& options) {
  const auto profile =
      profile_named(options.control.empty() ? kDefaultControl : std::string_view(options.control));
  if (!profile) {
    std::fputs(fmt::format("g31: error: {}\n", profile.error()).c_str(), stderr);
    return ExitCode::Setup;
  }
  reference::Entries entries;
  if (options.all) {
    entries = reference::everything(*profile.value());
  }
  ExitCode code = ExitCode::Completed;
  for (const std::string& topic : joined_topics(options.topics)) {
    reference::Entries found = reference::explain(topic, *profile.value());
    if (found.empty()) {
      std::fputs(unknown_text(topic).c_str(), stderr);
      code = ExitCode::BadUsage;
    }
    std::ranges::move(found, std::back_inserter(entries));
  }
  if (options.json) {
    print_json(entries, *profile.value());
  } else {
    print_text(entries);
  }
  return code;
}

}  // namespace g31::cli
