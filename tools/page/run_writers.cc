#include "tools/page/run_writers.h"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "interpreter/source/readable_text.h"

namespace g31::page {
namespace {

/// What a call touches comes behind its beginning.
bool is_within(double time_s, const report::CallSpan& call) {
  return time_s > call.time_from_s && time_s <= call.time_to_s;
}

bool continues_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Whether a block names a variable.
bool names(std::string_view block, std::string_view variable) {
  for (std::size_t at = block.find(variable); at != std::string_view::npos;
       at = block.find(variable, at + 1)) {
    const std::size_t end = at + variable.size();
    const bool begins = at == 0 || !continues_name(block[at - 1]) || variable.front() == '#';
    if (begins && (end == block.size() || !continues_name(block[end]))) {
      return true;
    }
  }
  return false;
}

/// Whether a block reads where the last measuring move was latched: #5061 to #5069, $AA_MW, $AA_MM.
bool reads_touch(std::string_view block) {
  return block.find("#506") != std::string_view::npos ||
         block.find("$AA_M") != std::string_view::npos;
}

}  // namespace

Writers::Writers(const RunPage& run) : run_(run) {
  if (const auto control = session::control_named(run.result.control)) {
    comments_ = session::comment_form(control.value());
  }
  for (const report::CallSpan& call : run.result.chronicle->calls()) {
    if (call.level == 1) {
      calls_.push_back(&call);
    }
  }
}

std::string Writers::meaning_of(const std::string& variable) const {
  const report::VariableHistory* const history = find(variable);
  return history == nullptr ? "" : meaning_of(*history);
}

std::string Writers::meaning_of(const report::VariableHistory& history) const {
  const source::ShownPlace place = run_.sources.show(history.last_write);
  return source::readable_text(session::last_comment(place.text, comments_));
}

std::vector<std::size_t> Writers::touches_of(const std::string& variable) const {
  Found found;
  if (const report::VariableHistory* const history = find(variable)) {
    add_touches(*history, found);
  }
  return {found.touches.begin(), found.touches.end()};
}

void Writers::add_touches(const report::VariableHistory& history, Found& found) const {
  if (!found.variables.insert(&history).second || add_touches_of_call(history, found)) {
    return;
  }
  const source::ShownPlace place = run_.sources.show(history.last_write);
  const std::string_view line = place.text;
  const std::string_view read = line.substr(std::min(line.find('='), line.size()));
  for (const report::VariableHistory& other : run_.result.chronicle->histories()) {
    if (other.last_block < history.last_block && names(read, other.name)) {
      add_touches(other, found);
    }
  }
  if (reads_touch(read)) {
    add_last_touch(history.values.back().first, found);
  }
}

bool Writers::add_touches_of_call(const report::VariableHistory& history, Found& found) const {
  const report::CallSpan* const call = call_of_block(history.last_block);
  if (call == nullptr) {
    return false;
  }
  const auto& touches = run_.recorder.touches();
  const auto behind = [&](double time_s) {
    return std::ranges::upper_bound(touches, time_s, {}, &runtime::TouchEvent::time_s);
  };
  for (auto touch = behind(call->time_from_s); touch != behind(call->time_to_s); ++touch) {
    if (touch->triggered) {
      found.touches.insert(static_cast<std::size_t>(touch - touches.begin()) + 1);
    }
  }
  return true;
}

void Writers::add_last_touch(double time_s, Found& found) const {
  const auto& touches = run_.recorder.touches();
  const auto behind = std::ranges::upper_bound(touches, time_s, {}, &runtime::TouchEvent::time_s);
  if (behind != touches.begin() && std::prev(behind)->triggered) {
    found.touches.insert(static_cast<std::size_t>(behind - touches.begin()));
  }
}

std::string Writers::caller_at(double time_s) const {
  const auto behind = std::ranges::lower_bound(calls_, time_s, {}, &report::CallSpan::time_from_s);
  return behind != calls_.begin() && is_within(time_s, **std::prev(behind))
             ? (*std::prev(behind))->program
             : std::string();
}

const report::CallSpan* Writers::call_of_block(std::uint64_t number) const {
  const auto behind = std::ranges::lower_bound(calls_, number, {}, &report::CallSpan::first_block);
  return behind != calls_.begin() && number <= (*std::prev(behind))->last_block ? *std::prev(behind)
                                                                                : nullptr;
}

const report::VariableHistory* Writers::find(const std::string& variable) const {
  const auto histories = run_.result.chronicle->histories();
  const auto found = std::ranges::find(histories, variable, &report::VariableHistory::name);
  return found == histories.end() ? nullptr : &*found;
}

}  // namespace g31::page
