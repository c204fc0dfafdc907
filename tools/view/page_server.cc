#include "tools/view/page_server.h"

#include "machine/base/module.h"
#include "tools/view/server_module.h"

namespace g31::view {

Result<std::shared_ptr<PageServer>, std::string> PageServer::open(int port) {
  const ModuleFunction function = find_in_module("g31_server.so", "g31_open_page_server");
  if (function.address == nullptr) {
    return "the module that serves pages cannot be loaded (" + function.why_not +
           "); install libcpp-httplib0.11";
  }
  std::shared_ptr<PageServer> server;
  std::string why_not;
  reinterpret_cast<decltype(&g31_open_page_server)>(function.address)(port, &server, &why_not);
  if (server == nullptr) {
    return why_not;
  }
  return server;
}

}  // namespace g31::view
