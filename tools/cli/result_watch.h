#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "interpreter/runtime/block_listener.h"
#include "interpreter/runtime/shown_value.h"
#include "tools/expect/expectation.h"
#include "tools/setup/variable_name.h"

namespace g31::cli {

/// Hears which results a run writes: what a variable holds from before is no result of the run.  A
/// SINUMERIK's variables are 0 at first, which is a good deviation.
class ResultWatch final : public runtime::BlockListener {
 public:
  using ValueOf = std::function<std::optional<runtime::ShownValue>(const std::string& name)>;

  /// Before the run.
  /// @param value_of  variables as they are before the run
  /// @param other     hears everything, too, and outlives the watch; nullptr: nobody
  ResultWatch(const expect::Expectations& expectations, const ValueOf& value_of,
              runtime::BlockListener* other);

  /// Whether a result may be left from before; else nobody has to listen.
  [[nodiscard]] bool is_needed() const { return !before_.empty(); }
  /// Behind the run: nothing has written it, and it is what it was.
  /// @param name  as the sheet spells it
  [[nodiscard]] bool is_from_before(const std::string& name, const runtime::ShownValue& now) const;

  runtime::Verdict on_block(const runtime::BlockPlace& place) override;
  void on_level(std::uint16_t depth, const std::string& program) override;
  [[nodiscard]] bool hears_writes() const override { return true; }
  void on_write(const runtime::WriteEvent& event) override;
  void on_condition(const source::Location& where, bool is_met) override;

 private:
  runtime::BlockListener* other_;
  std::map<std::string, runtime::ShownValue, setup::InAnyCase> before_;  ///< as in WriteEvent
  std::set<std::string, setup::InAnyCase> written_;
};

}  // namespace g31::cli
