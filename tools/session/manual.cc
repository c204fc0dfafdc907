#include "tools/session/manual.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "interpreter/dialects/fanuc/explain/explain.h"
#include "interpreter/dialects/sinumerik/explain/explain.h"
#include "interpreter/dialects/sinumerik/explain/program_texts.h"
#include "interpreter/runtime/overloaded.h"
#include "machine/base/letters.h"
#include "tools/disk/disk.h"
#include "tools/disk/shipped.h"

namespace g31::session {
namespace {

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

bool is_about_control(const runtime::Entry& entry) {
  return entry.kind == "control";
}

runtime::Entry entry_of_control(const Control& control) {
  return std::visit(runtime::Overloaded{
                        [](const FanucControl& chosen) {
                          const fanuc::Profile& profile = chosen.profile;
                          return fanuc::reference::explain(profile.name, profile).front();
                        },
                        [](const SinumerikControl& chosen) {
                          return runtime::Entry{
                              "control",
                              std::string(name_of(chosen)),
                              "SINUMERIK 828D, milling and turning, with its measuring cycles",
                              {}};
                        },
                    },
                    control);
}

/// Tells at each control which models run as it does.
void add_models(runtime::Entries& entries) {
  for (runtime::Entry& entry : entries) {
    const auto control = is_about_control(entry) ? control_named(entry.name)
                                                 : Result<Control, std::string>(std::string());
    if (control) {
      entry.facts.push_back(
          {"covers", fmt::format("{}", fmt::join(models_of(control.value()), ", "))});
    }
  }
}

/// A name that another control of the family has, spelled as it is, is no hint.
std::optional<std::string> other_than(const std::string& topic,
                                      std::optional<std::string> nearest) {
  return nearest && in_capitals(*nearest) == in_capitals(topic) ? std::nullopt : nearest;
}

}  // namespace

runtime::Entries explain(const std::string& topic, const Control& control) {
  runtime::Entries found = std::visit(
      runtime::Overloaded{
          [&](const FanucControl& chosen) {
            return fanuc::reference::explain(topic, chosen.profile);
          },
          [&](const SinumerikControl&) { return sinumerik::explain(topic, shipped_topics()); },
      },
      control);
  // M60 is a word of programs before it is the plate of a control.
  const auto named = control_named(topic);
  if (named && found.empty()) {
    found.push_back(entry_of_control(named.value()));
  }
  add_models(found);
  return found;
}

runtime::Entries everything(const Control& control) {
  runtime::Entries all = std::visit(
      runtime::Overloaded{
          [](const FanucControl& chosen) { return fanuc::reference::everything(chosen.profile); },
          [](const SinumerikControl&) { return sinumerik::everything(shipped_topics()); },
      },
      control);
  std::erase_if(all, is_about_control);
  for (const Control& one : all_controls()) {
    all.push_back(entry_of_control(one));
  }
  add_models(all);
  return all;
}

Suggestion suggestion_for(const std::string& topic, const Control& control) {
  return std::visit(
      runtime::Overloaded{
          [&](const FanucControl&) {
            Suggestion suggestion;
            if (!explain(topic, SinumerikControl{}).empty()) {
              suggestion.other_control = SinumerikControl{};
            }
            suggestion.nearest_topic = other_than(topic, fanuc::reference::nearest_topic(topic));
            suggestion.examples = "#5061, G31, ATAN, GOTO, 'alarm 112' or 6001.1";
            return suggestion;
          },
          [&](const SinumerikControl&) {
            Suggestion suggestion;
            suggestion.nearest_topic =
                other_than(topic, sinumerik::nearest_topic(topic, shipped_topics()));
            suggestion.examples =
                "$AA_MW, G54, SUBSTR, CYCLE977, _OVR[4], 61301 or $SCS_MEA_FEED_MEASURE";
            return suggestion;
          },
      },
      control);
}

}  // namespace g31::session
