// The one file of the server that reads JSON.
#include "cli/lsp/params.hpp"

#include <nlohmann/json.hpp>

namespace mansard::lsp {

namespace {

const nlohmann::json* json_of(const void* value) {
  return static_cast<const nlohmann::json*>(value);
}

}  // namespace

std::optional<Params> Params::parse(const std::string& text) {
  auto json = nlohmann::json::parse(text, nullptr, false);
  if (json.is_discarded()) return std::nullopt;
  auto message = std::make_shared<const nlohmann::json>(std::move(json));
  const void* const value = message.get();
  return Params(std::move(message), value);
}

Params Params::operator[](std::string_view path) const {
  const nlohmann::json* at = json_of(value_);
  while (at && !path.empty()) {
    const std::string name(path.substr(0, path.find('.')));
    path.remove_prefix(std::min(path.size(), name.size() + 1));
    if (!at->is_object()) return {message_, nullptr};
    const auto found = at->find(name);
    at = found == at->end() ? nullptr : &*found;
  }
  return {message_, at};
}

bool Params::is_null() const { return !value_ || json_of(value_)->is_null(); }
bool Params::is_object() const { return value_ && json_of(value_)->is_object(); }
bool Params::is_array() const { return value_ && json_of(value_)->is_array(); }
bool Params::is_true() const {
  return value_ && json_of(value_)->is_boolean() && json_of(value_)->get<bool>();
}

std::optional<std::string> Params::text() const {
  if (!value_ || !json_of(value_)->is_string()) return std::nullopt;
  return json_of(value_)->get<std::string>();
}

std::optional<uint32_t> Params::number() const {
  if (!value_ || !json_of(value_)->is_number()) return std::nullopt;
  const auto number = json_of(value_)->get<double>();
  if (!(number >= 0 && number <= 2147483647)) return std::nullopt;
  return static_cast<uint32_t>(number);
}

std::vector<Params> Params::items() const {
  std::vector<Params> all;
  if (!is_array()) return all;
  for (const nlohmann::json& item : *json_of(value_)) all.push_back({message_, &item});
  return all;
}

std::string Params::written() const {
  if (!value_) return "null";
  return json_of(value_)->dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string Params::needed_text(std::string_view path) const {
  if (auto found = (*this)[path].text()) return *std::move(found);
  throw Refusal(Refusal::invalid_params, "'" + std::string(path) + "' must be a string");
}

uint32_t Params::needed_number(std::string_view path) const {
  if (const auto found = (*this)[path].number()) return *found;
  throw Refusal(Refusal::invalid_params, "'" + std::string(path) + "' must be a whole number");
}

}  // namespace mansard::lsp
