#include "tools/cli/evaluate_command.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "tools/cli/evaluate_request.h"
#include "tools/cli/messages.h"
#include "tools/disk/disk.h"
#include "tools/evaluate/evaluate.h"

namespace g31::cli {
namespace {

std::optional<session::Refusal> print_whole(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    return session::bad_input(
        fmt::format("cannot write standard output: {}", std::strerror(errno)));
  }
  return std::nullopt;
}

std::optional<session::Refusal> hand_over(const EvaluateOptions& options,
                                          const evaluate::Evaluation& evaluation) {
  const bool is_document = options.json == "-";
  auto wrong =
      print_whole(is_document ? evaluate::evaluation_document(evaluation, options.has_curves)
                              : evaluate::evaluation_table(evaluation));
  if (wrong || is_document || options.json.empty()) {
    return wrong;
  }
  const auto problem = disk::write_whole_file(
      options.json, evaluate::evaluation_document(evaluation, options.has_curves));
  return problem ? std::optional(session::bad_input(*problem)) : std::nullopt;
}

}  // namespace

ExitCode evaluate_command(const EvaluateOptions& options) {
  const auto request = evaluate_request(options);
  if (!request) {
    return refuse(request.error());
  }
  disk::Disk disk;
  const auto text = disk.read(options.file);
  if (!text) {
    return refuse(session::bad_input(fmt::format("cannot read {}", options.file)));
  }
  const auto evaluation = evaluate::evaluate({options.file, *text}, request.value());
  if (!evaluation) {
    return refuse(session::refusal_of({evaluation.error()}));
  }
  const auto wrong = hand_over(options, evaluation.value());
  return wrong ? refuse(*wrong) : ExitCode::Completed;
}

}  // namespace g31::cli
