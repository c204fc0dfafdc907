#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "machine/base/result.h"

namespace g31::view {

/// Serves one page at 127.0.0.1 to who knows its token, and tells them of newer ones.
///
/// It answers GET of two paths, `/` and `/events` (server-sent events: the number of the edition
/// that there is, and `works` while a newer one is made), with the token as `?t=`.  A request
/// without the token, or one for another host name, as a page elsewhere could make a browser send
/// it, is 403; it reads no file.
class PageServer {
 public:
  /// @param port  0: any that is free
  /// @returns why nobody can listen there
  static Result<std::shared_ptr<PageServer>, std::string> open(int port);

  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;
  /// Ends all that it serves.
  virtual ~PageServer() = default;

  /// With the token: "http://127.0.0.1:34567/?t=...".
  [[nodiscard]] virtual std::string address() const = 0;

  /// From now on this is the page.  Any thread may call it.
  /// @param edition  larger than that of the page before, from 1
  virtual void show(std::uint64_t edition, std::string html) = 0;
  /// From now until then a newer page is made.  Any thread may call it.
  virtual void work() = 0;

 protected:
  PageServer() = default;
};

}  // namespace g31::view
