#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "interpreter/runtime/reference.h"

namespace g31::sinumerik {

/// What the tables say about a topic as a user writes it: "$AA_MW", "G54", "SUBSTR", "B_AND",
/// "CASE", "CR", "MSG", "alarm 14011", "14011", "$SCS_MEA_FEED_MEASURE", "55630".  Empty: nothing
/// is known.
runtime::Entries explain(std::string_view topic);

/// The known topic nearest to an unknown one.
std::optional<std::string> nearest_topic(std::string_view topic);

/// Everything, in the order of the tables.
runtime::Entries everything();

}  // namespace g31::sinumerik
