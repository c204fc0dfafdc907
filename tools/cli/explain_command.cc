#include "tools/cli/explain_command.h"

#include <algorithm>
#include <cstdio>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "interpreter/dialects/fanuc/reference/explain.h"
#include "interpreter/dialects/sinumerik/reference/explain.h"
#include "interpreter/dialects/sinumerik/reference/program_texts.h"
#include "interpreter/dialects/sinumerik/session.h"
#include "tools/cli/chosen_profile.h"
#include "tools/disk/disk.h"
#include "tools/disk/shipped.h"

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

/// What the shipped programs of the SINUMERIK say of themselves; of an alarm the first place.
const sinumerik::Topics& shipped_topics() {
  static const sinumerik::Topics kTopics = [] {
    sinumerik::Topics all;
    std::set<std::string> known;
    const auto folder = disk::shipped_folder("macros/sinumerik");
    if (!folder) {
      return all;
    }
    disk::Disk disk;
    for (const std::string& name : disk.list(*folder)) {
      const bool is_program = name.ends_with(".SPF") || name.ends_with(".DEF");
      const auto text = is_program ? disk.read(*folder + "/" + name) : std::nullopt;
      for (sinumerik::Topic& topic : sinumerik::topics_of_text(text.value_or(""))) {
        if (known.insert(topic.name).second) {
          all.push_back(std::move(topic));
        }
      }
    }
    return all;
  }();
  return kTopics;
}

/// What either dialect knows.
runtime::Entries entries_about(const std::string& topic, const ChosenControl& control) {
  return control.profile != nullptr ? fanuc::reference::explain(topic, *control.profile)
                                    : sinumerik::explain(topic, shipped_topics());
}

runtime::Entries everything(const ChosenControl& control) {
  return control.profile != nullptr ? fanuc::reference::everything(*control.profile)
                                    : sinumerik::everything(shipped_topics());
}

std::string unknown_text(const std::string& topic, const ChosenControl& control) {
  if (control.profile != nullptr && !sinumerik::explain(topic, shipped_topics()).empty()) {
    return fmt::format("g31: error: {} does not know '{}', --control {} does\n", control.name,
                       topic, sinumerik::kControlName);
  }
  const auto nearest = control.profile != nullptr
                           ? fanuc::reference::nearest_topic(topic)
                           : sinumerik::nearest_topic(topic, shipped_topics());
  return fmt::format(
      "g31: error: nothing is known about '{}'{}\n", topic,
      nearest ? fmt::format(", did you mean '{}'?", *nearest)
      : control.profile != nullptr
          ? ": write #5061, G31, ATAN, GOTO, 'alarm 112' or 6001.1"
          : ": write $AA_MW, G54, SUBSTR, CYCLE977, _OVR[4], 61301 or $SCS_MEA_FEED_MEASURE");
}

}  // namespace

ExitCode explain_command(const ExplainOptions& options) {
  const auto control =
      control_named(options.control.empty() ? kDefaultControl : std::string_view(options.control));
  if (!control) {
    std::fputs(fmt::format("g31: error: {}\n", control.error()).c_str(), stderr);
    return ExitCode::Setup;
  }
  runtime::Entries entries;
  if (options.all) {
    entries = everything(control.value());
  }
  ExitCode code = ExitCode::Completed;
  for (const std::string& topic : joined_topics(options.topics)) {
    runtime::Entries found = entries_about(topic, control.value());
    if (found.empty()) {
      std::fputs(unknown_text(topic, control.value()).c_str(), stderr);
      code = ExitCode::BadUsage;
    }
    std::ranges::move(found, std::back_inserter(entries));
  }
  if (options.json) {
    print_json(entries, control.value().name);
  } else {
    print_text(entries);
  }
  return code;
}

}  // namespace g31::cli
