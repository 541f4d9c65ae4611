// A diagnostic as a JSON object, for editors and scripts.
#include <nlohmann/json.hpp>

#include "grammar/diagnostic.hpp"
#include "grammar/put_place.hpp"

namespace mansard {

using Json = nlohmann::ordered_json;

std::string to_json(const Diagnostic& diagnostic) {
  Json json;
  json["severity"] = diagnostic.severity == Severity::error ? "error" : "warning";
  json["code"] = diagnostic.code;
  json["text"] = diagnostic.text;
  put_place(json, diagnostic.at);
  json["also"] = Json::array();
  for (const Span& at : diagnostic.also) put_place(json["also"].emplace_back(Json::object()), at);
  json["notes"] = Json::array();
  for (const Note& note : diagnostic.notes) {
    Json& made = json["notes"].emplace_back(Json::object());
    made["text"] = note.text;
    put_place(made, note.at);
  }
  json["help"] = diagnostic.help;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string note_to_json(std::string_view text) {
  Json json;
  json["severity"] = "note";
  json["text"] = text;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace mansard
