#include "tools/session/control.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/code/program_name.h"
#include "interpreter/dialects/sinumerik/run/session.h"
#include "interpreter/runtime/overloaded.h"
#include "machine/base/contract.h"
#include "machine/base/letters.h"
#include "machine/base/nearest_name.h"

namespace g31::session {
namespace {

struct ControlModel {
  std::string_view model;
  std::string_view profile;
};

constexpr auto kControlModels = std::to_array<ControlModel>({
#define CONTROL_MODEL(model, profile) {model, profile},
#include "tools/session/control_models.def"
#undef CONTROL_MODEL
});

/// Small letters and digits alone: "Fanuc 0i-MF" is fanuc0imf.
std::string plain_name(std::string_view name) {
  std::string plain;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      plain.push_back(small_letter(c));
    }
  }
  return plain;
}

/// The longest model that the name begins with, or nullptr.
const ControlModel* model_of(std::string_view plain) {
  for (const std::string_view maker :
       {"fanuc", "series", "mitsubishi", "meldas", "brother", "haas"}) {
    if (plain.starts_with(maker) && plain.size() > maker.size()) {
      plain.remove_prefix(maker.size());
    }
  }
  std::size_t longest = 0;
  const ControlModel* found = nullptr;
  for (const ControlModel& row : kControlModels) {
    const std::string model = plain_name(row.model);
    // M60 is a model, M605 none; 0i-MF goes on with letters.
    const bool is_model = plain.starts_with(model) &&
                          (plain.size() == model.size() ||
                           std::isdigit(static_cast<unsigned char>(plain[model.size()])) == 0);
    if (model.size() > longest && is_model) {
      longest = model.size();
      found = &row;
    }
  }
  return found;
}

Control as_model(const Control& control, std::string_view model) {
  const auto* const chosen = std::get_if<FanucControl>(&control);
  return chosen != nullptr
             ? Control(FanucControl{fanuc::profile_of_model(chosen->profile.get(), model)})
             : control;
}

bool is_word_letter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$';
}

/// Whether a word stands in the text by itself; one that ends with a bracket or = may go on.
bool has_whole_word(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos;
       at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || !is_word_letter(text[at - 1]);
    const bool ends =
        end == text.size() || !is_word_letter(word.back()) || !is_word_letter(text[end]);
    if (begins && ends) {
      return true;
    }
  }
  return false;
}

/// CYCLE977(..)
bool calls_cycle(std::string_view text) {
  constexpr std::string_view kCycle = "CYCLE";
  for (std::size_t at = text.find(kCycle); at != text.npos; at = text.find(kCycle, at + 1)) {
    const std::size_t number = at + kCycle.size();
    const std::size_t end = std::min(text.find_first_not_of("0123456789", number), text.size());
    if (end > number && end < text.size() && text[end] == '(') {
      return true;
    }
  }
  return false;
}

/// Words that no Fanuc program has, and nothing that one has: # before a number, O before one.
bool is_sinumerik_text(std::string_view text) {
  static constexpr std::string_view kWords[] = {
      "DEF REAL", "DEF INT", "DEF BOOL", "DEF STRING", "GOTOF",   "GOTOB",    "STOPRE",
      "MEAS=",    "MEAW=",   "ENDFOR",   "ENDLOOP",    "$AA_MW[", "$AC_MEA[", "$P_UIFR[",
      "MSG(",     "MCALL",   "SUPA",     "DIAMON",     "DIAMOF",  "T=\""};
  bool is_comment = false;  // of a SINUMERIK
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool is_first = at == 0 || text[at - 1] == '\n' || text[at - 1] == '\r';
    is_comment = text[at] == ';' || (is_comment && !is_first);
    if (is_comment) {
      continue;
    }
    const bool has_digit =
        at + 1 < text.size() && std::isdigit(static_cast<unsigned char>(text[at + 1])) != 0;
    if ((text[at] == '#' || (is_first && (text[at] == 'O' || text[at] == ':'))) && has_digit) {
      return false;
    }
  }
  return calls_cycle(text) || std::ranges::any_of(kWords, [&](std::string_view word) {
           return has_whole_word(text, word);
         });
}

}  // namespace

std::string_view name_of(const Control& control) {
  return std::visit(
      runtime::Overloaded{
          [](const FanucControl& chosen) -> std::string_view { return chosen.profile.get().name; },
          [](const SinumerikControl&) { return sinumerik::kControlName; },
      },
      control);
}

bool defines_data(const std::string& path, std::string_view text) {
  return sinumerik::holds_definitions(sinumerik::program_name(path), text);
}

std::vector<Control> all_controls() {
  std::vector<Control> all;
  for (const fanuc::Profile& profile : fanuc::profiles()) {
    all.emplace_back(FanucControl{profile});
  }
  all.emplace_back(SinumerikControl{});
  return all;
}

std::vector<std::string> control_names() {
  std::vector<std::string> names;
  for (const Control& control : all_controls()) {
    names.emplace_back(name_of(control));
  }
  return names;
}

std::vector<std::string_view> models_of(const Control& control) {
  std::vector<std::string_view> models;
  for (const ControlModel& row : kControlModels) {
    if (row.profile == name_of(control)) {
      models.push_back(row.model);
    }
  }
  return models;
}

Result<Control, std::string> control_named(std::string_view name) {
  const std::string plain = plain_name(name);
  const ControlModel* const model = model_of(plain);
  std::vector<std::string_view> known;
  std::optional<Control> found;
  for (const Control& control : all_controls()) {
    known.push_back(name_of(control));
    if (plain_name(known.back()) == plain) {
      return control;
    }
    if (model != nullptr && known.back() == model->profile) {
      found = as_model(control, model->model);
    }
  }
  if (found) {
    return *found;
  }
  const auto nearest = nearest_name(name, known);
  return fmt::format("unknown control '{}'{}; known: {}", name,
                     nearest ? fmt::format(", did you mean '{}'?", *nearest) : "",
                     fmt::join(known, ", "));
}

Control default_control() {
  const fanuc::Profile* const profile = fanuc::find_profile("fanuc-16i");
  G31_EXPECTS(profile != nullptr);
  return FanucControl{*profile};
}

Control control_of_program(const std::string& path, std::string_view text) {
  const std::string ending = in_small_letters(std::filesystem::path(path).extension().string());
  const bool by_ending = ending == ".mpf" || ending == ".spf" || ending == ".arc";
  return by_ending || text.starts_with("%_N_") || is_sinumerik_text(text)
             ? Control(SinumerikControl{})
             : default_control();
}

}  // namespace g31::session
