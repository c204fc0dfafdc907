#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/run/runner.h"
#include "interpreter/dialects/fanuc/text/output_format.h"
#include "interpreter/runtime/printer_port.h"
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
  MaybeFailure deliver(Control& control) const {
    std::string whole;
    for (const Piece& piece : pieces_) {
      if (control.printer != nullptr) {
        if (auto problem = control.printer->send(piece.bytes, piece.code)) {
          return not_ready(std::move(*problem));
        }
      }
      whole += piece.bytes;
    }
    control.observer.on_output({whole, control.here()});
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

}  // namespace

MaybeFailure Runner::open_or_close(OutputStatement statement) {
  const bool opens = statement == OutputStatement::POPEN;
  if (control_.printer != nullptr) {
    auto problem = opens ? control_.printer->select() : control_.printer->release();
    if (problem) {
      return Printout::not_ready(std::move(*problem));
    }
  }
  control_.printer_open = opens;
  return std::nullopt;
}

/// DPRNT and BPRNT without POPEN: an alarm or a note, as the control has it (MB-249, MB-374).
MaybeFailure Runner::refused_output(OutputStatement statement, syntax::ShortSpan block) {
  if (control_.printer_open) {
    return std::nullopt;
  }
  if (control_.profile.output.needs_popen) {
    Failure failure;
    failure.id = AlarmId::PrinterClosed;
    failure.detail = fmt::format("{} without POPEN", info(statement).name);
    return failure;
  }
  control_.warn_once(source::DiagnosticId::PrinterNotOpen, location(block), info(statement).name);
  return std::nullopt;
}

/// POPEN, PCLOS, DPRNT, BPRNT (MB-235 to MB-253); runs when it is read, like every macro statement.
MaybeFailure Runner::output(const Step& step) {
  const auto statement = static_cast<OutputStatement>(step.number);
  if (info(statement).has_format == HasFormat::No) {
    return open_or_close(statement);
  }
  const CompiledProgram& program = *frame().program;
  const syntax::ShortSpan format = program.tree->blocks[step.block].text;
  if (auto refused = refused_output(statement, program.tree->blocks[step.block].span)) {
    return refused;
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
  const bool is_binary = statement == OutputStatement::BPRNT;
  const PrintCode characters =
      control_.parameters.is_on(ParameterId::IsoCode) ? PrintCode::Iso : PrintCode::Ascii;
  Printout printout;
  for (const OutputItem& item : items.value()) {
    if (item.variable < 0) {
      printout.add(item.text, characters);
      continue;
    }
    const auto value = control_.all_variables.read(item.variable);
    control_.touches.missed.reads(holder_of(control_.variables.depth(), item.variable));
    const auto bytes =
        !value      ? std::nullopt
        : is_binary ? binary_text(value.value().or_zero(), item.decimals)
                    : std::optional(decimal_text(value.value().or_zero(), item.integer_places,
                                                 item.decimals, style_of(control_)));
    if (!bytes) {
      Failure failure;
      failure.id = value ? AlarmId::IntegerOverflow : value.error();
      failure.where = format;
      failure.detail = fmt::format("#{} cannot be printed here", item.variable);
      return failure;
    }
    if (!is_binary && cuts_digits(value.value().or_zero(), item, style_of(control_))) {
      control_.warn_once(source::DiagnosticId::DigitsCut, location(format),
                         fmt::format("#{} is {:.{}f}, printed as {}", item.variable,
                                     value.value().or_zero(), item.decimals, *bytes));
    }
    printout.add(*bytes, is_binary ? PrintCode::Binary : characters);
  }
  control_.use_measured();
  printout.add(control_.parameters.is_on(ParameterId::PrintReturns) ? "\n\r" : "\n", characters);
  return printout.deliver(control_);
}

}  // namespace g31::fanuc
