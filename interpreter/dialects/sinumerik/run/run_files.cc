// Files that a program reads and writes.  All of them lie side by side in one place, whatever path
// a program writes: nothing leads out of it.

#include <algorithm>
#include <cstddef>
#include <limits>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/run/file_name.h"
#include "interpreter/dialects/sinumerik/run/procedures.h"
#include "interpreter/dialects/sinumerik/vocabulary/functions.h"
#include "interpreter/runtime/budget_spent.h"
#include "interpreter/runtime/output_budget.h"
#include "interpreter/runtime/stop_report.h"

namespace g31::sinumerik {
namespace {

constexpr std::size_t kLongestLine = 200;
constexpr std::size_t kLongestLineRead = 255;

/// What the procedures say in their first argument (work preparation, file handling).
namespace file_error {
constexpr double kNone = 0.0;
constexpr double kBadPath = 1.0;
constexpr double kNoFile = 3.0;
constexpr double kNoAccess = 13.0;
constexpr double kNoLine = 21.0;
constexpr double kArrayTooSmall = 22.0;
constexpr double kTooManyLines = 23.0;
}  // namespace file_error

/// The same of EXTOPEN, EXTWRITE and EXTCLOSE.
namespace external_error {
constexpr double kNotOpen = 1.0;
constexpr double kTooLong = 3.0;
constexpr double kOpenAlready = 5.0;
constexpr double kBadPath = 16.0;
}  // namespace external_error

/// The lines of a text, without their ends: the first `most` of them.
std::vector<std::string_view> lines_of(std::string_view text, double most) {
  std::vector<std::string_view> lines;
  while (!text.empty() && static_cast<double>(lines.size()) < most) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

constexpr std::uint64_t kLineEnd = 2;  // as a document writes it

/// What a file counts as output: a name and a block of a disk beside its bytes.
std::uint64_t size_of_file(std::string_view name, std::string_view content) {
  constexpr std::uint64_t kDiskBlock = 4096;
  return kDiskBlock + runtime::size_in_document(name) + runtime::size_in_document(content);
}

bool may_write(Channel& channel, std::uint64_t bytes) {
  runtime::OutputBudget* const budget = channel.watch.output();
  return budget == nullptr || budget->charge(runtime::Output::Files, bytes);
}

void make_file(Channel& channel, const std::string& name) {
  if (!channel.files.contains(name) && may_write(channel, size_of_file(name, {}))) {
    channel.files.content(name);
  }
}

/// A file counts with what it is now, not with what has gone through it.
void append_line(Channel& channel, const std::string& name, const std::string& line) {
  make_file(channel, name);
  if (may_write(channel, runtime::size_in_document(line) + kLineEnd)) {
    std::string& content = channel.files.content(name);
    content += line;
    content += '\n';
  }
}

bool remove_file(Channel& channel, const std::string& name) {
  const std::string* const content = channel.files.find(name);
  if (content == nullptr) {
    return false;
  }
  if (runtime::OutputBudget* const budget = channel.watch.output()) {
    budget->give_back(runtime::Output::Files, size_of_file(name, *content));
  }
  channel.files.remove(name);
  return true;
}

/// A loop may read far into a large file at each pass: such blocks are looked at one by one.
void spend_on_reading(Channel& channel, std::ptrdiff_t bytes) {
  constexpr std::ptrdiff_t kBytesOfAPiece = 1 << 18;  // some tenths of a millisecond
  for (std::ptrdiff_t piece = 0; piece < bytes / kBytesOfAPiece; ++piece) {
    if (const auto halt = channel.watch.before_work()) {
      throw runtime::BudgetSpent(runtime::message_of(*halt), {});
    }
  }
}

/// What READ says behind its work.
double read_lines(Channel& channel, Operands& at, Arguments list) {
  const std::string name = file_meant(channel, at.text(list[1].value));
  if (name.empty()) {
    return file_error::kBadPath;
  }
  const std::string* const content = channel.files.find(name);
  if (content == nullptr) {
    return file_error::kNoFile;
  }
  const double count = rounded(at.number(list[3]));
  const double line = rounded(at.number(list[2]));
  const double most = line == 0.0 ? std::numeric_limits<double>::infinity() : line + count - 1.0;
  const std::vector<std::string_view> lines = lines_of(*content, std::max(line, most));
  const auto line_count = static_cast<double>(lines.size());
  spend_on_reading(channel, lines.empty() ? 0 : lines.back().data() - content->data());
  const double first = line == 0.0 ? line_count - count + 1.0 : line;  // 0: the last ones
  if (first < 1.0 || first > line_count) {
    return file_error::kNoLine;
  }
  if (count < 1.0 || first + count - 1.0 > line_count) {
    return file_error::kTooManyLines;
  }
  const VariableView target = at.variable(list[4].variable);
  const auto begin = static_cast<std::size_t>(
      list[4].form == Argument::Form::Whole ? 0.0 : at.number(list[4].element));
  const auto wanted = static_cast<std::size_t>(count);
  if (begin + wanted > static_cast<std::size_t>(target.shape.count())) {
    return file_error::kArrayTooSmall;
  }
  for (std::size_t i = 0; i < wanted; ++i) {
    const auto longest = std::min(kLongestLineRead, static_cast<std::size_t>(target.longest));
    target.texts[begin + i] = lines[static_cast<std::size_t>(first) - 1 + i].substr(0, longest);
  }
  return file_error::kNone;
}

}  // namespace

std::string file_name(std::string_view path) {
  if (path.find("..") != std::string_view::npos || path.ends_with('/')) {
    return {};
  }
  const std::size_t slash = path.find_last_of("/\\");
  std::string name(slash == std::string_view::npos ? path : path.substr(slash + 1));
  return name == "." || name.find('\0') != std::string::npos ? std::string() : name;
}

std::string file_meant(const Channel& channel, std::string_view path) {
  const std::string name = file_name(path);
  return name.empty() ? name : channel.files.kept_name(name);
}

namespace procedure {

/// WRITE(error, file, line)
double write_file(Channel& channel, Operands& at, Arguments list) {
  const std::string name = file_meant(channel, at.text(list[1].value));
  const std::string& line = at.text(list[2].value);
  if (name.empty() || line.size() > kLongestLine) {
    return file_error::kBadPath;
  }
  append_line(channel, name, line);
  return file_error::kNone;
}

/// DELETE(error, file)
MaybeFailure delete_file(Calls& calls, Channel& channel, Operands& at, Arguments list) {
  const std::string& path = at.text(list[1].value);
  const std::string name = file_meant(channel, path);
  return at.assign(list[0], name.empty()                   ? file_error::kBadPath
                            : remove_file(channel, name)   ? file_error::kNone
                            : calls.is_given_program(path) ? file_error::kNoAccess
                                                           : file_error::kNoFile);
}

/// READ(error, file, line, count, texts)
MaybeFailure read_file(Calls& calls, Channel& channel, Operands& at, Arguments list) {
  MaybeFailure wrong = calls.expect_no_program(at.text(list[1].value), "READ");
  return wrong ? wrong : at.assign(list[0], read_lines(channel, at, list));
}

/// FILESIZE(error, file, size)
MaybeFailure tell_file_size(Calls& calls, Channel& channel, Operands& at, Arguments list) {
  const std::string path = at.text(list[1].value);
  if (file_name(path).empty()) {
    return at.assign(list[0], file_error::kBadPath);
  }
  if (MaybeFailure wrong = calls.expect_no_program(path, "FILESIZE")) {
    return wrong;
  }
  const std::string* const content = channel.files.find(file_meant(channel, path));
  if (content != nullptr) {
    if (MaybeFailure wrong = at.assign(list[2], static_cast<double>(content->size()))) {
      return wrong;
    }
  }
  return at.assign(list[0], content != nullptr ? file_error::kNone : file_error::kNoFile);
}

/// EXTOPEN(error, file, mode, use, "APP" or "OVR")
double open_external(Channel& channel, Operands& at, Arguments list) {
  const std::string name = file_name(at.text(list[1].value));
  if (name.empty()) {
    return external_error::kBadPath;
  }
  if (!channel.open_files.insert(name).second) {
    return external_error::kOpenAlready;
  }
  const bool appends = list.size() < 5 || upper(at.text(list[4].value)) != "OVR";
  if (!appends) {
    remove_file(channel, name);
  }
  make_file(channel, name);
  return file_error::kNone;
}

double write_external(Channel& channel, Operands& at, Arguments list) {
  const std::string name = file_name(at.text(list[1].value));
  if (!channel.open_files.contains(name)) {
    return external_error::kNotOpen;
  }
  const std::string& line = at.text(list[2].value);
  if (line.size() > kLongestLine) {
    return external_error::kTooLong;
  }
  append_line(channel, name, line);
  return file_error::kNone;
}

double close_external(Channel& channel, Operands& at, Arguments list) {
  const bool was_open = channel.open_files.erase(file_name(at.text(list[1].value))) > 0;
  return was_open ? file_error::kNone : external_error::kNotOpen;
}

}  // namespace procedure
}  // namespace g31::sinumerik
