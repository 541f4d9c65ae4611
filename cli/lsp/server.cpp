#include "cli/lsp/server.hpp"

#include <algorithm>
#include <exception>

#include "cli/lsp/capabilities.hpp"
#include "cli/lsp/uri.hpp"

namespace mansard::lsp {

namespace {

/// How long typing must rest before scripts are checked.
constexpr int rest = 15;  // milliseconds

}  // namespace

int Server::run() {
  while (!status_) {
    project_.settle();
    if (waiting_.empty()) {
      const bool more = read_all(!is_dirty_ ? -1 : is_checking_ ? 0 : rest);
      if (!more && !status_ && is_dirty_) check_on();
      continue;
    }
    const Params message = waiting_.front();
    waiting_.pop_front();
    handle(message);
    read_all(0);  // a request may have been cancelled meanwhile
  }
  return *status_;
}

void Server::check_on() {
  is_checking_ = check_next(project_);
  if (is_checking_) return;
  is_dirty_ = false;
  publisher_.publish(project_, [this](const Json& params) {
    send(Json::object({{"method", "textDocument/publishDiagnostics"}, {"params", params}}));
  });
}

/// All that has come; waits for the first. False when nothing came in that time.
bool Server::read_all(int milliseconds) {
  bool any = false;
  for (;; milliseconds = 0) {
    FrameReader::Frame frame = in_.next(milliseconds);
    switch (frame.got) {
      case FrameReader::Got::end:
        if (waiting_.empty() && !status_) status_ = 1;
        return any;
      case FrameReader::Got::nothing:
        return any;
      case FrameReader::Got::broken:
        send_error("null", {Refusal::parse_error, frame.text});
        break;
      case FrameReader::Got::message:
        take(frame.text);
        break;
    }
    any = true;
  }
}

void Server::take(const std::string& text) {
  const auto message = Params::parse(text);
  if (!message) {
    in_.give_back(text);
    return send_error("null", {Refusal::parse_error, "the message is no JSON"});
  }
  const bool known = message->is_object() && (*message)["method"].text();
  const bool is_reply =
      message->is_object() && (!(*message)["result"].is_null() || !(*message)["error"].is_null());
  if (known) {
    waiting_.push_back(*message);
  } else if (!is_reply) {
    send_error("null", {Refusal::invalid_request, "a message is an object with a method"});
  }
}

void Server::handle(const Params& message) {
  const std::string method = *message["method"].text();
  if (!message["id"].is_null()) return answer(message, method);
  try {
    notice(method, message["params"]);
  } catch (const std::exception&) {  // nobody waits for an answer to a notification
  }
}

void Server::answer(const Params& message, const std::string& method) {
  const std::string id = message["id"].written();
  try {
    if (is_cancelled(id)) throw Refusal(Refusal::cancelled, "cancelled");
    const Json result = result_of(method, message["params"]);
    send(Json::object({{"id", Json::raw(id)}, {"result", result}}));
  } catch (const Refusal& refusal) {
    send_error(id, refusal);
  } catch (const std::exception& error) {
    send_error(id, {Refusal::internal_error, error.what()});
  }
}

bool Server::is_cancelled(const std::string& id) {
  return std::ranges::any_of(waiting_, [&](const Params& message) {
    return message["method"].text() == "$/cancelRequest" && message["params.id"].written() == id;
  });
}

Json Server::result_of(const std::string& method, const Params& params) {
  if (state_ == State::shut_down)
    throw Refusal(Refusal::invalid_request, "the server was shut down");
  if (method == "initialize") return initialize(params);
  if (state_ == State::fresh)
    throw Refusal(Refusal::not_initialized, "'initialize' must come first");
  if (method == "shutdown") {
    state_ = State::shut_down;
    return nullptr;
  }
  const auto row = std::ranges::find(requests(), method, &Request::method);
  if (row == requests().end())
    throw Refusal(Refusal::method_not_found, "there is no method '" + method + "'");
  return row->answer(project_, params);
}

Json Server::initialize(const Params& params) {
  if (state_ != State::fresh)
    throw Refusal(Refusal::invalid_request, "the server is initialized already");
  for (const Params& encoding : params["capabilities.general.positionEncodings"].items()) {
    if (encoding.text() == "utf-16") break;  // the editor's favourite comes first
    if (encoding.text() != "utf-8") continue;
    project_.encoding = Encoding::utf8;
    break;
  }
  project_.snippets =
      params["capabilities.textDocument.completion.completionItem.snippetSupport"].is_true();
  for (const Params& folder : params["workspaceFolders"].items())
    project_.workspace().add_folder(path_of(folder.needed_text("uri")));
  const auto root = params["rootUri"].text();
  if (root && params["workspaceFolders"].items().empty())
    project_.workspace().add_folder(path_of(*root));
  state_ = State::running;
  return Json::object({{"capabilities", capabilities(project_.encoding)},
                       {"serverInfo", Json::object({{"name", "mansard"}})}});
}

void Server::notice(const std::string& method, const Params& params) {
  is_checking_ = false;
  if (method == "exit") {
    status_ = state_ == State::shut_down ? 0 : 1;
  } else if (state_ != State::running) {
    return;  // the protocol says to drop it
  } else if (method.starts_with("textDocument/")) {
    take_document(method, params);
  } else if (method == "workspace/didChangeWatchedFiles") {
    project_.forget_files();
    is_dirty_ = true;
  } else if (method == "workspace/didChangeWorkspaceFolders") {
    change_folders(params["event"]);
  }
}

void Server::take_document(const std::string& method, const Params& params) {
  const std::string uri = params.needed_text("textDocument.uri");
  const auto version = params["textDocument.version"].number();
  Documents& documents = project_.documents();
  is_dirty_ = true;
  if (method == "textDocument/didOpen") {
    documents.open(uri, params.needed_text("textDocument.text"), version);
  } else if (method == "textDocument/didChange") {
    documents.change(uri, params["contentChanges"].items(), version, project_.encoding);
    return;
  } else if (method == "textDocument/didClose") {
    documents.close(uri);
  } else if (method == "textDocument/didSave") {
    project_.forget_files();
  }
  project_.workspace().forget();  // opened, closed or saved: other files may be there
}

void Server::change_folders(const Params& event) {
  for (const Params& folder : event["removed"].items())
    project_.workspace().remove_folder(path_of(folder.needed_text("uri")));
  for (const Params& folder : event["added"].items())
    project_.workspace().add_folder(path_of(folder.needed_text("uri")));
}

void Server::send(Json message) {
  message.put("jsonrpc", "2.0");
  if (!write_frame(out_, message.text())) status_ = 1;
}

void Server::send_error(const std::string& id, const Refusal& refusal) {
  const Json error =
      Json::object({{"code", static_cast<int>(refusal.code)}, {"message", refusal.text}});
  send(Json::object({{"id", Json::raw(id)}, {"error", error}}));
}

}  // namespace mansard::lsp
