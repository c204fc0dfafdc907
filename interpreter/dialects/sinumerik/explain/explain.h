#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "interpreter/dialects/sinumerik/explain/topic.h"

namespace g31::sinumerik {

/// What the tables say about a topic as a user writes it: "$AA_MW", "G54", "SUBSTR", "B_AND",
/// "CASE", "CR", "MSG", "alarm 14011", "14011", "$SCS_MEA_FEED_MEASURE", "55630"; and what the
/// programs that come with g31 say: "CYCLE977", "_OVR[4]", "61301".  Empty: nothing is known.
/// @param shipped  of those programs
runtime::Entries explain(std::string_view topic, const Topics& shipped);

/// The known topic nearest to an unknown one.
std::optional<std::string> nearest_topic(std::string_view topic, const Topics& shipped);

/// Everything, in the order of the tables; then the programs.
runtime::Entries everything(const Topics& shipped);

}  // namespace g31::sinumerik
