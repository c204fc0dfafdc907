#include "tools/session/sheet_places.h"

namespace g31::session {

void place_settings(const setup::Job& job, std::vector<source::Diagnostic>& diagnostics) {
  for (source::Diagnostic& diagnostic : diagnostics) {
    const auto place = job.places.find(diagnostic.setting);
    if (place != job.places.end()) {
      diagnostic.in_sheet = place->second;
    }
  }
}

}  // namespace g31::session
