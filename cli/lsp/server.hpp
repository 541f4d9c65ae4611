// The conversation with the editor: JSON-RPC 2.0 and the life of a server as the Language Server
// Protocol 3.17 tells it.
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <string>

#include "cli/lsp/diagnostics.hpp"
#include "cli/lsp/frames.hpp"
#include "cli/lsp/project.hpp"

namespace mansard::lsp {

/// The table of what is answered.
struct Request {
  std::string_view method;
  Json (*answer)(Project&, const Params&);
};
std::span<const Request> requests();

class Server {
 public:
  /// Reads from one file descriptor, writes to the other.
  Server(int in, int out, std::vector<std::string> style_path)
      : in_(in), out_(out), project_(std::move(style_path)) {}

  /// Until `exit` or the end of the input: 0 after a `shutdown`, else 1.
  int run();

 private:
  enum class State : uint8_t { fresh, running, shut_down };

  bool read_all(int milliseconds);
  void check_on();
  void take(const std::string& text);
  void handle(const Params& message);
  void answer(const Params& message, const std::string& method);
  Json result_of(const std::string& method, const Params& params);
  Json initialize(const Params& params);
  void notice(const std::string& method, const Params& params);
  void take_document(const std::string& method, const Params& params);
  void change_folders(const Params& params);
  bool is_cancelled(const std::string& id);
  void send(Json message);
  void send_error(const std::string& id, const Refusal& refusal);

  FrameReader in_;
  int out_;
  Project project_;
  Publisher publisher_;
  State state_ = State::fresh;
  std::deque<Params> waiting_;
  std::optional<int> status_;  ///< to end with
  bool is_dirty_ = false;      ///< diagnostics may be others
  bool is_checking_ = false;   ///< some scripts are checked, others not yet
};

}  // namespace mansard::lsp
