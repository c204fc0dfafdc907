#include <fmt/format.h>

#include "interpreter/dialects/fanuc/output_format.h"
#include "interpreter/dialects/fanuc/runner.h"
#include "machine/base/contract.h"

namespace g31::fanuc {
namespace {

OutputStyle style_of(const Control& control) {
  OutputStyle style = control.profile.output.style;
  if (control.parameters.is_on(ParameterId::PrintOmitsZeros)) {
    style.leading_zeros = OutputStyle::LeadingZeros::Omit;
  }
  return style;
}

}  // namespace

/// POPEN, PCLOS, DPRNT, BPRNT (MB-235 to MB-253); runs when it is read, like every macro statement.
MaybeFailure Runner::output(const Step& step) {
  const auto statement = static_cast<OutputStatement>(step.number);
  if (info(statement).has_format == HasFormat::No) {
    control_.printer_open = statement == OutputStatement::POPEN;
    return std::nullopt;
  }
  const CompiledProgram& program = *frame().program;
  const syntax::ShortSpan format = program.tree->blocks[step.block].text;
  if (!control_.printer_open && control_.profile.output.needs_popen) {
    Failure failure;
    failure.id = AlarmId::PrinterClosed;
    failure.detail = fmt::format("{} without POPEN", info(statement).name);
    return failure;
  }
  if (!control_.printer_open) {
    control_.warn_once(source::DiagnosticId::PrinterNotOpen,
                       location(program.tree->blocks[step.block].span), info(statement).name);
  }
  const auto items =
      parse_output_format(program.file->text().substr(format.begin, format.end - format.begin));
  G31_EXPECTS(items.ok());  // the parser refused every other format
  if (statement == OutputStatement::DPRNT) {
    if (const auto refused = refused_by(control_.profile.output, items.value())) {
      Failure failure;
      failure.id = AlarmId::OutputFormat;
      failure.where = format;
      failure.detail = *refused;
      return failure;
    }
  }
  std::string line;
  for (const OutputItem& item : items.value()) {
    if (item.variable < 0) {
      line += item.text;
      continue;
    }
    const auto value = control_.variables.read(item.variable);
    const auto bytes =
        !value ? std::nullopt
        : statement == OutputStatement::BPRNT
            ? binary_text(value.value().or_zero(), item.decimals)
            : std::optional(decimal_text(value.value().or_zero(), item.integer_places,
                                         item.decimals, style_of(control_)));
    if (!bytes) {
      Failure failure;
      failure.id = value ? AlarmId::IntegerOverflow : value.error();
      failure.where = format;
      failure.detail = fmt::format("#{} cannot be printed here", item.variable);
      return failure;
    }
    line += *bytes;
  }
  line += control_.parameters.is_on(ParameterId::PrintReturns) ? "\n\r" : "\n";
  control_.observer.on_output(line);
  return std::nullopt;
}

}  // namespace g31::fanuc
