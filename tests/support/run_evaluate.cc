#include "tests/support/run_evaluate.h"

namespace g31::testing {

EvaluateOutput run_evaluate(cli::EvaluateOptions options) {
  options.json = "-";
  EvaluateOutput output{captured([&] { return cli::evaluate_command(options); }), {}};
  if (output.exit_code == 0) {
    output.document = nlohmann::json::parse(output.out);
  }
  return output;
}

EvaluateOutput evaluate_text(const std::string& text, cli::EvaluateOptions options) {
  TemporaryFolder folder;
  options.file = folder.write("data.csv", text);
  EvaluateOutput output = run_evaluate(options);
  // The folder has a name of its own each time.
  for (std::string* said : {&output.out, &output.errors}) {
    for (std::size_t at = said->find(options.file); at != std::string::npos;
         at = said->find(options.file)) {
      said->replace(at, options.file.size(), "data.csv");
    }
  }
  return output;
}

}  // namespace g31::testing
