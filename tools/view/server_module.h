#pragma once

#include <memory>
#include <string>

#include "tools/view/page_server.h"

// A function of the module g31_server, which is loaded when a page is to be served: the libraries
// of the server (cpp-httplib, OpenSSL, brotli) would add 2 ms to each start of g31, which takes 3
// ms.

/// Opens a server, as view::PageServer::open says.
/// @param server   null where nobody can listen there
/// @param why_not  in that case why
extern "C" __attribute__((visibility("default"))) void g31_open_page_server(
    int port, std::shared_ptr<g31::view::PageServer>* server, std::string* why_not);
