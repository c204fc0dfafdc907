#include "tools/cli/output_places.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "tools/disk/part_file.h"
#include "tools/disk/shipped.h"

namespace g31::cli {
namespace {

namespace fs = std::filesystem;

/// Of a file that is there or not, one spelling; "": there is none.
std::string one_spelling(const std::string& path) {
  const auto file = disk::written_file(path);
  std::error_code error;
  const fs::path whole = file ? fs::absolute(file.value(), error) : fs::path();
  return whole.empty() ? "" : fs::weakly_canonical(whole, error).string();
}

/// Whether two paths are the same file, there or not.
bool are_same(const std::string& a, const std::string& b) {
  if (a == b || a.empty() || a == "-" || b == "-") {
    return a == b;
  }
  std::error_code error;
  if (fs::equivalent(a, b, error) && !error) {
    return true;
  }
  const std::string spelling = one_spelling(a);
  return !spelling.empty() && spelling == one_spelling(b);
}

}  // namespace

std::string why_no_place(const std::string& text) {
  return text.empty() ? "the name is empty: expected that of a file" : "";
}

std::string why_no_printer(const std::string& text) {
  return text.empty() ? "the name is empty: expected a file, - for standard output, or a serial "
                        "line as /dev/ttyS0,4800,e,7,2"
                      : "";
}

std::optional<session::Refusal> wrong_place(const std::vector<OutputPlace>& outputs,
                                            const InputLists& inputs) {
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    const std::string& path = output->path;
    if (path.empty()) {
      continue;
    }
    const bool is_stream = path == "-";
    const auto is_here = [&](const std::string& other) { return are_same(other, path); };
    if (!is_stream && std::ranges::any_of(inputs, [&](const std::vector<std::string>& list) {
          return std::ranges::any_of(list, is_here, disk::real_path);
        })) {
      return session::bad_input(fmt::format("{} {}: it would take the place of what is to be read",
                                            output->option, path));
    }
    const auto taken = std::find_if(outputs.begin(), output,
                                    [&](const OutputPlace& other) { return is_here(other.path); });
    if (taken != output) {
      return session::bad_input(fmt::format("{} and {} cannot both be {}", taken->option,
                                            output->option, is_stream ? "standard output" : path));
    }
  }
  return std::nullopt;
}

std::optional<session::Refusal> wrong_outputs(const std::vector<OutputPlace>& outputs,
                                              const InputLists& inputs) {
  if (auto wrong = wrong_place(outputs, inputs)) {
    return wrong;
  }
  for (const OutputPlace& output : outputs) {
    const bool is_asked = output.is_asked_first && !output.path.empty();
    if (const auto why = is_asked ? disk::why_not_begun(output.path) : std::nullopt) {
      return session::bad_input(
          fmt::format("{} {}: cannot write: {}", output.option, output.path, *why));
    }
  }
  return std::nullopt;
}

std::string sound_place(std::string_view option, const std::vector<OutputPlace>& outputs,
                        const InputLists& inputs) {
  const auto asked = std::ranges::find(outputs, option, &OutputPlace::option);
  if (asked == outputs.end() || asked->path.empty()) {
    return {};
  }
  const bool is_shared = std::ranges::any_of(outputs, [&](const OutputPlace& other) {
    return &other != &*asked && are_same(other.path, asked->path);
  });
  const bool is_sound =
      !is_shared && !wrong_place({*asked}, inputs) && !disk::why_not_begun(asked->path);
  return is_sound ? asked->path : std::string();
}

}  // namespace g31::cli
