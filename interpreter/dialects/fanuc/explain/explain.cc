#include "interpreter/dialects/fanuc/explain/explain.h"

#include <algorithm>

#include "machine/base/nearest_name.h"

namespace g31::fanuc::reference {
namespace {

/// Upper case, runs of blanks one blank, none at the ends.
std::string normal_topic(std::string_view topic) {
  std::string normal;
  for (const char c : topic) {
    const bool is_blank = c == ' ' || c == '\t';
    if (is_blank && (normal.empty() || normal.back() == ' ')) {
      continue;
    }
    normal.push_back(is_blank ? ' ' : c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c);
  }
  if (!normal.empty() && normal.back() == ' ') {
    normal.pop_back();
  }
  return normal;
}

void append(Entries& all, Entries more) {
  std::ranges::move(more, std::back_inserter(all));
}

}  // namespace

Entries explain(std::string_view topic, const Profile& profile) {
  const std::string normal = normal_topic(topic);
  Entries found = variables(normal, profile);
  append(found, codes(normal, profile));
  append(found, alarms(normal, profile));
  append(found, parameters(normal));
  append(found, words(normal, profile));
  append(found, variable_names(normal));
  append(found, controls(normal));
  return found;
}

std::optional<std::string> nearest_topic(std::string_view topic) {
  const std::vector<std::string> names = topic_names();
  const std::vector<std::string_view> known(names.begin(), names.end());
  const auto nearest = nearest_name(normal_topic(topic), known);
  return nearest ? std::optional(std::string(*nearest)) : std::nullopt;
}

Entries everything(const Profile& profile) {
  Entries all = variables("#0-#99999999", profile);
  for (const std::string& name : topic_names()) {
    append(all, codes(name, profile));
    append(all, words(name, profile));
    append(all, parameters(name));
    append(all, variable_names(name));
    append(all, controls(normal_topic(name)));
  }
  append(all, all_alarms(profile));
  return all;
}

}  // namespace g31::fanuc::reference
