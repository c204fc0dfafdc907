#include "tools/cli/evaluate_request.h"

#include "tools/evaluate/request_words.h"

namespace g31::cli {

Result<evaluate::Request, session::Refusal> evaluate_request(const EvaluateOptions& options) {
  const auto asked = evaluate::request_of(
      {options.kind, options.columns, options.unit, options.magnify, options.given});
  if (!asked) {
    return session::bad_input(asked.error());
  }
  evaluate::Request request = asked.value();
  request.wants_curves = options.has_curves;
  request.language = options.language;
  request.wants_drawing = !options.svg.empty();
  return request;
}

}  // namespace g31::cli
