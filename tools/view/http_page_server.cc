// The server of pages, in the module g31_server.

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <optional>
#include <string_view>
#include <thread>

#include <fmt/format.h>
#include <httplib.h>
#include <sys/random.h>
#include <sys/socket.h>
#include <unistd.h>

#include "tools/view/connection.h"
#include "tools/view/elastic_threads.h"
#include "tools/view/server_module.h"

namespace g31::view {
namespace {

constexpr const char* kHost = "127.0.0.1";
constexpr const char* kMethod = "GET";
constexpr int kWrongMethod = 405;
constexpr int kMostListeners = 10;  // each keeps a thread for as long as it listens
constexpr std::size_t kMostPayload = 1024;
constexpr auto kNewsPatience = std::chrono::seconds(2);
constexpr int kMostWaiting = 256;  // connections that are not accepted yet

/// 128 bits from the system, as hexadecimal digits; nullopt: it has none.
std::optional<std::string> random_token() {
  std::array<unsigned char, 16> bytes = {};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    return std::nullopt;
  }
  std::string token;
  for (const unsigned char byte : bytes) {
    token += fmt::format("{:02x}", byte);
  }
  return token;
}

/// Takes as long for a wrong text as for the right one.
bool are_equal(std::string_view a, std::string_view b) {
  unsigned char differs = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    differs |= static_cast<unsigned char>(a[i] ^ b[i]);
  }
  return differs == 0;
}

/// The library's server, but no client keeps it from ending.
class PromptServer final : public httplib::Server {
 public:
  /// @param ends  outlives the server
  explicit PromptServer(const std::atomic<bool>& ends) : ends_(ends) {}

 private:
  /// Ranges are ignored, as RFC 9110, 14.2, lets a server: pieces of a page would be of different
  /// editions, and the library asks the provider for bytes behind its end.
  static void answer_whole(httplib::Request& request) { request.ranges.clear(); }

  /// One request and its answer.
  bool process_and_close_socket(socket_t socket) override {
    Connection connection(socket, ends_);
    bool is_closed = false;
    const bool is_answered = process_request(connection, true, is_closed, answer_whole);
    ::shutdown(socket, SHUT_RDWR);
    ::close(socket);
    return is_answered;
  }

  const std::atomic<bool>& ends_;
};

class HttpPageServer final : public PageServer {
 public:
  HttpPageServer() = default;
  HttpPageServer(const HttpPageServer&) = delete;
  HttpPageServer& operator=(const HttpPageServer&) = delete;
  ~HttpPageServer() override;

  /// @returns why it cannot listen there; nullopt: it does
  std::optional<std::string> begin(int port);
  void show(std::uint64_t edition, std::string html) override;
  void work() override;
  [[nodiscard]] std::string address() const override {
    return fmt::format("http://{}:{}/?t={}", kHost, port_, token_);
  }

 private:
  using Response = httplib::Response;

  /// The status of a request that is not answered; 0: it is.
  [[nodiscard]] int refusal_of(const httplib::Request& request) const;
  void set_up();
  void answer_page(Response& response);
  void answer_events(Response& response);
  /// What there is: the page, and whether a newer one is made.
  struct State {
    std::uint64_t edition = 0;
    bool works = false;
    bool operator==(const State&) const = default;
  };

  /// Waits for a state other than `last`.  @returns it, or `last` where none came in time
  State next_state(const State& last);

  std::atomic<bool> ends_ = false;
  PromptServer server_{ends_};
  socket_t socket_ = INVALID_SOCKET;
  std::string token_;
  int port_ = 0;
  std::thread thread_;
  std::atomic<int> listeners_ = 0;
  std::mutex mutex_;
  std::condition_variable changed_;
  State state_;
  std::shared_ptr<const std::string> html_;
};

int HttpPageServer::refusal_of(const httplib::Request& request) const {
  constexpr int kForbidden = 403;
  constexpr int kNotFound = 404;
  const std::string host = request.get_header_value("Host");
  if (request.get_header_value_count("Host") != 1 ||
      (host != fmt::format("{}:{}", kHost, port_) && host != fmt::format("localhost:{}", port_))) {
    return kForbidden;
  }
  if (request.get_param_value_count("t") != 1 || !are_equal(request.get_param_value("t"), token_)) {
    return kForbidden;
  }
  if (request.method != kMethod) {
    return kWrongMethod;
  }
  return request.path == "/" || request.path == "/events" ? 0 : kNotFound;
}

void HttpPageServer::set_up() {
  server_.new_task_queue = [] { return new ElasticThreads(); };  // the server's own
  server_.set_payload_max_length(kMostPayload);
  // No other program may share the port, as the library would let it.
  server_.set_socket_options([this](socket_t socket) {
    socket_ = socket;
    const int yes = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  });
  server_.set_default_headers({{"Accept-Ranges", "none"},
                               {"Cache-Control", "no-store"},
                               {"X-Content-Type-Options", "nosniff"},
                               {"X-Frame-Options", "DENY"},
                               {"Cross-Origin-Resource-Policy", "same-origin"},
                               {"Referrer-Policy", "no-referrer"}});
  server_.set_pre_routing_handler([this](const httplib::Request& request, Response& response) {
    const int refusal = refusal_of(request);
    if (refusal == 0) {
      return httplib::Server::HandlerResponse::Unhandled;
    }
    response.status = refusal;
    if (refusal == kWrongMethod) {
      response.set_header("Allow", kMethod);
    }
    response.set_content(fmt::format("{}\n", refusal), "text/plain");
    return httplib::Server::HandlerResponse::Handled;
  });
  server_.Get("/", [this](const httplib::Request&, Response& response) { answer_page(response); });
  server_.Get("/events",
              [this](const httplib::Request&, Response& response) { answer_events(response); });
}

std::optional<std::string> HttpPageServer::begin(int port) {
  const auto token = random_token();
  if (!token) {
    return "the system has no random numbers";
  }
  token_ = *token;
  set_up();
  errno = 0;
  const bool is_bound = port == 0 ? (port_ = server_.bind_to_any_port(kHost)) > 0
                                  : server_.bind_to_port(kHost, port_ = port);
  if (!is_bound) {
    return fmt::format("nobody can listen at {}:{}: {}", kHost, port,
                       errno == 0 ? "it is taken" : std::strerror(errno));
  }
  // The library lets five wait; a connection beyond comes again only after a second.
  ::listen(socket_, kMostWaiting);
  thread_ = std::thread([this] { server_.listen_after_bind(); });
  while (!server_.is_running()) {
    std::this_thread::yield();
  }
  return std::nullopt;
}

HttpPageServer::~HttpPageServer() {
  {
    const std::scoped_lock lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) {
    server_.stop();
    thread_.join();
  }
}

void HttpPageServer::show(std::uint64_t edition, std::string html) {
  {
    const std::scoped_lock lock(mutex_);
    state_ = {edition, false};
    html_ = std::make_shared<const std::string>(std::move(html));
  }
  changed_.notify_all();
}

void HttpPageServer::work() {
  {
    const std::scoped_lock lock(mutex_);
    state_.works = true;
  }
  changed_.notify_all();
}

HttpPageServer::State HttpPageServer::next_state(const State& last) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, kNewsPatience, [&] { return ends_ || state_ != last; });
  return state_;
}

void HttpPageServer::answer_page(Response& response) {
  constexpr std::string_view kWait =
      "<!doctype html><meta charset=\"utf-8\"><meta http-equiv=\"refresh\" content=\"0\">"
      "<title>g31 view</title><p>g31 runs the program…</p>\n";
  next_state({0, true});
  std::shared_ptr<const std::string> html;
  {
    const std::scoped_lock lock(mutex_);
    html = html_ != nullptr ? html_ : std::make_shared<const std::string>(kWait);
  }
  // By pieces, so that the library does not compress it: that would last longer than the run.
  response.set_content_provider(
      html->size(), "text/html; charset=utf-8",
      [html](std::size_t from, std::size_t length, httplib::DataSink& sink) {
        return sink.write(html->data() + from, length);
      });
}

void HttpPageServer::answer_events(Response& response) {
  constexpr int kTooMany = 503;
  if (++listeners_ > kMostListeners) {
    --listeners_;
    response.status = kTooMany;
    response.set_content("too many windows are open\n", "text/plain");
    return;
  }
  response.set_chunked_content_provider(
      "text/event-stream",
      [this, last = State{}](std::size_t, httplib::DataSink& sink) mutable {
        const State now = next_state(last);
        if (ends_) {
          return false;
        }
        std::string text =
            now.edition == last.edition ? ":\n\n" : fmt::format("data: {}\n\n", now.edition);
        text += now.works && !last.works ? "event: works\ndata:.\n\n" : "";
        last = now;
        return sink.write(text.data(), text.size());
      },
      [this](bool) { --listeners_; });
}

}  // namespace
}  // namespace g31::view

void g31_open_page_server(int port, std::shared_ptr<g31::view::PageServer>* server,
                          std::string* why_not) {
  auto opened = std::make_shared<g31::view::HttpPageServer>();
  if (auto problem = opened->begin(port)) {
    *why_not = std::move(*problem);
    return;
  }
  *server = std::move(opened);
}
