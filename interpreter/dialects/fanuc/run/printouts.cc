#include "interpreter/dialects/fanuc/run/printouts.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/dialects/fanuc/state/expression_reads.h"
#include "interpreter/dialects/fanuc/text/output_format.h"
#include "interpreter/runtime/printer_port.h"
#include "interpreter/source/latin_1.h"
#include "interpreter/source/readable_text.h"
#include "machine/base/contract.h"

namespace g31::fanuc {
namespace {

using runtime::PrintCode;

OutputStyle style_of(const Control& control) {
  OutputStyle style = control.profile.output.style;
  if (control.parameters.is_on(ParameterId::PrintOmitsZeros)) {
    style.leading_zeros = OutputStyle::LeadingZeros::Omit;
  }
  return style;
}

/// The bytes of one statement, piece by piece: only characters get a parity (MB-248, MB-250).
class Printout {
 public:
  void add(std::string_view bytes, PrintCode code) {
    if (pieces_.empty() || pieces_.back().code != code) {
      pieces_.push_back({code, {}});
    }
    pieces_.back().bytes += bytes;
  }

  /// To the printer, if there is one, then to the observer: it hears only what was printed.
  /// @param as_utf8  what the observer may read it with
  MaybeFailure deliver(Control& control, source::AsUtf8 as_utf8) const {
    std::string whole;
    if (control.printer != nullptr) {
      control.watch.has_waited();
    }
    for (const Piece& piece : pieces_) {
      if (control.printer != nullptr) {
        if (auto problem = control.printer->send(piece.bytes, piece.code)) {
          return not_ready(std::move(*problem));
        }
      }
      whole += piece.bytes;
    }
    control.observer.on_output({whole, control.here(), as_utf8});
    return std::nullopt;
  }

  static Failure not_ready(std::string problem) {
    Failure failure;
    failure.id = AlarmId::PrinterNotReady;
    failure.detail = std::move(problem);
    return failure;
  }

 private:
  struct Piece {
    PrintCode code;
    std::string bytes;
  };
  std::vector<Piece> pieces_;
};

MaybeFailure open_or_close(Control& control, OutputStatement statement) {
  const bool opens = statement == OutputStatement::POPEN;
  if (control.printer != nullptr) {
    control.watch.has_waited();
    auto problem = opens ? control.printer->select() : control.printer->release();
    if (problem) {
      return Printout::not_ready(std::move(*problem));
    }
  }
  control.printer_open = opens;
  return std::nullopt;
}

/// DPRNT and BPRNT without POPEN: an alarm, a note or nothing, as the control has it (MB-249,
/// MB-374).
MaybeFailure refused_output(Control& control, OutputStatement statement, source::Location block) {
  using WithoutPopen = OutputRule::WithoutPopen;
  const WithoutPopen rule = control.profile.output.without_popen;
  if (control.printer_open || rule == WithoutPopen::Prints) {
    return std::nullopt;
  }
  if (rule == WithoutPopen::Alarm) {
    Failure failure;
    failure.id = AlarmId::PrinterClosed;
    failure.detail = fmt::format("{} without POPEN", info(statement).name);
    return failure;
  }
  control.warn_once(source::DiagnosticId::PrinterNotOpen, block, info(statement).name);
  return std::nullopt;
}

}  // namespace

MaybeFailure print(Control& control, const CallStack& stack, const Step& step) {
  const auto statement = static_cast<OutputStatement>(step.number);
  if (info(statement).has_format == HasFormat::No) {
    return open_or_close(control, statement);
  }
  const CompiledProgram& program = *stack.frame().program;
  const syntax::ShortSpan format = program.tree->blocks[step.block].text;
  if (auto refused = refused_output(control, statement,
                                    stack.location(program.tree->blocks[step.block].span))) {
    return refused;
  }
  const auto items =
      parse_output_format(program.file->text().substr(format.begin, format.end - format.begin));
  G31_EXPECTS(items.ok());  // the parser refused every other format
  if (auto wrong = wrong_output(statement, control.profile.output, items.value())) {
    return at_place(wrong->id, format, std::move(wrong->detail));
  }
  const bool is_binary = statement == OutputStatement::BPRNT;
  const PrintCode characters =
      control.parameters.is_on(ParameterId::IsoCode) ? PrintCode::Iso : PrintCode::Ascii;
  Printout printout;
  for (const OutputItem& item : items.value()) {
    if (item.variable < 0) {
      printout.add(item.text, characters);
      continue;
    }
    const auto value = control.all_variables.read(item.variable);
    control.touches.missed.reads(holder_of(control.variables.depth(), item.variable));
    const auto bytes =
        !value      ? std::nullopt
        : is_binary ? binary_text(value.value().or_zero(), item.decimals)
                    : std::optional(decimal_text(value.value().or_zero(), item.integer_places,
                                                 item.decimals, style_of(control)));
    if (!bytes) {
      Failure failure;
      failure.id = value ? AlarmId::IntegerOverflow : value.error();
      failure.where = format;
      failure.detail = fmt::format("#{} cannot be printed here", item.variable);
      return failure;
    }
    if (!is_binary && cuts_digits(value.value().or_zero(), item, style_of(control))) {
      control.warn_once(source::DiagnosticId::DigitsCut, stack.location(format),
                        fmt::format("#{} is {:.{}f}, printed as {}", item.variable,
                                    value.value().or_zero(), item.decimals, *bytes));
    }
    printout.add(*bytes, is_binary ? PrintCode::Binary : characters);
  }
  control.use_measured();
  printout.add(control.parameters.is_on(ParameterId::PrintReturns) ? "\n\r" : "\n", characters);
  return printout.deliver(control, is_binary ? &source::as_utf8 : &source::readable_text);
}

}  // namespace g31::fanuc
