#pragma once

#include <string_view>

namespace g31::testing {

/// Keeps a document that a command wrote for the test that holds all of them against their schemas
/// (documents_of_tests): a JSON text with "schema": "g31....", or lines of --jsonl.  Anything else
/// is left alone, and so is what is larger than 4 MB.
///
/// Equal texts are kept once.  The folder is `documents` of the build; many processes may keep
/// documents there at a time.
void keep_document(std::string_view text);

}  // namespace g31::testing
