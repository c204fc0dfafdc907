#include "tools/view/page_server.h"

#include "machine/base/module.h"
#include "tools/view/server_module.h"

namespace g31::view {

Result<std::shared_ptr<PageServer>, std::string> PageServer::open(int port) {
  const ModuleFunction function = find_in_module(
      {.file = "g31_server.so", .does = "serves pages", .package = "libcpp-httplib0.11"},
      "g31_open_page_server");
  if (function.address == nullptr) {
    return function.why_not;
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
