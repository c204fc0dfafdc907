#pragma once

#include <string>
#include <string_view>

#include "machine/base/result.h"
#include "tools/study/record.h"

namespace g31::study {

/// The study as a document: schema `g31.study/1`, with statistics; of a shard
/// `g31.study.shard/1`, without.  Numbers are written so that reading gives the same bits.
std::string record_json(const Record& record);

/// Reads either back.  Error: what is wrong with it.
Result<Record, std::string> parse_record(std::string_view text);

/// Whether both describe the same study.
bool same_study(const Description& a, const Description& b);

}  // namespace g31::study
