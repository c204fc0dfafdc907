#include "tools/cli/setup_command.h"

#include <algorithm>

#include "interpreter/source/source_map.h"
#include "tools/cli/messages.h"
#include "tools/cli/output_places.h"
#include "tools/cli/refusal_document.h"
#include "tools/cli/write_out.h"
#include "tools/disk/disk.h"
#include "tools/review/review.h"
#include "tools/review/review_document.h"

namespace g31::cli {

ExitCode setup_command(const SetupOptions& options) {
  if (const auto wrong =
          wrong_outputs({{"--json", options.json, true}}, {options.programs, options.setups})) {
    return refuse(*wrong);
  }
  const auto reviewed = review::review(options);
  if (!reviewed) {
    return refuse(reviewed.error(), options.json, "g31.setup/1");
  }
  const review::Review& review = reviewed.value();
  if (const auto wrong = wrong_place({{"--json", options.json}}, {review.files})) {
    return refuse(*wrong);
  }
  disk::Disk disk;
  const source::SourceMap sources(disk);
  std::string text;
  for (const source::Diagnostic& finding : review.findings) {
    text += render_text(finding, sources);
  }
  if (text.empty()) {
    text = "nothing is wrong with the set-up\n";
  }
  if (const auto wrong = write_result(
          options.json, [&] { return text; }, [&] { return review_document(review); })) {
    return refuse(*wrong);
  }
  const bool fails = std::ranges::any_of(review.findings, [&](const source::Diagnostic& finding) {
    return finding.severity >= options.fail_on;
  });
  return fails ? ExitCode::Findings : ExitCode::Completed;
}

}  // namespace g31::cli
