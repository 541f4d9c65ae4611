// All that `mansard explain` knows, for machines.
#include <map>
#include <nlohmann/json.hpp>

#include "cli/explain.hpp"
#include "cli/order_drawing.hpp"
#include "grammar/put_place.hpp"

namespace mansard {

namespace {

using Json = nlohmann::ordered_json;

Json giver(const Origin& from, Span at) {
  Json json{{"style", from.style->name.text}};
  if (from.block) json["block"] = from.block->name.text;
  put_place(json, at);
  return json;
}

Json order_json(const Explained& explained) {
  Json order = Json::array();
  for (std::size_t i = 0; i < explained.standings.size(); ++i) {
    const Standing& standing = explained.standings[i];
    Json json{{"style", standing.style->name.text}};
    put_place(json, standing.style->name.at);
    json["parents"] = Json::array();
    for (const uint32_t parent : standing.parents)
      json["parents"].push_back(explained.standings[parent].style->name.text);
    json["why"] = why(explained.standings, i);
    order.push_back(std::move(json));
  }
  return order;
}

Json value_json(const VariableValue& value) {
  constexpr std::string_view givers[] = {"style", "property", "command line"};
  Json json{{"value", value.value ? Json(*value.value) : Json(nullptr)},
            {"giver", givers[static_cast<int>(value.giver)]}};
  if (value.command_line) json["command_line"] = *value.command_line;
  if (value.property) json["property"] = *value.property;
  json["depends_on"] = Json::array();
  if (value.dependence.shape) json["depends_on"].push_back("shape");
  if (value.dependence.random) json["depends_on"].push_back("random");
  if (value.dependence.footprint) json["depends_on"].push_back("footprint");
  if (value.dependence.abstract) json["depends_on"].push_back("abstract");
  json["settable"] = value.settable;
  if (!value.problem.empty()) json["problem"] = value.problem;
  return json;
}

class MemberJson {
 public:
  MemberJson(const Explained& explained, const Story& story)
      : explained_(explained), story_(story) {}

  Json json() const {
    Json json{{"kind", name_of(story_.kind)},
              {"name", story_.name},
              {"block", story_.block},
              {"full_name", story_.full_name()}};
    if (const auto value = explained_.value(story_)) json["in_force"] = value_json(*value);
    json["writings"] = Json::array();
    const std::map<const Writing*, Share> shares = all_shares();
    for (const Writing* writing : from_the_base(story_.writings)) {
      Json& made = json["writings"].emplace_back(writing_json(*writing));
      const auto share = shares.find(writing);
      if (share != shares.end()) put_rule(made, *writing, share->second);
    }
    if (story_.kind == MemberKind::symbol) {
      json["elements"] = alternatives(elements_of(explained_.style, story_));
      json["materials"] = alternatives(materials_of(explained_.style, story_));
      const std::string draws = material_draws(explained_.style, story_.name);
      if (!draws.empty()) json["drawn"] = draws;
    }
    json["uses"] = uses();
    return json;
  }

 private:
  static Json writing_json(const Writing& writing) {
    Json json = giver(writing.from, writing.at());
    json["fate"] = name_of(writing.fate);
    json["text"] = writing.at().text();
    json["docs"] = Json::array();
    for (const Span& doc : writing.preamble().docs) json["docs"].push_back(doc.text());
    json["annotations"] = Json::array();
    for (const auto& annotation : writing.preamble().annotations)
      json["annotations"].push_back(one_line(annotation.at));
    if (writing.fate == Fate::dropped) {
      json["replaced_by"] = giver(writing.replaced_by, writing.replaced_by.block->replace);
    }
    return json;
  }

  std::map<const Writing*, Share> all_shares() const {
    std::map<std::pair<uint32_t, Fate>, std::vector<const Writing*>> generations;
    for (const Writing& writing : story_.writings) {
      if (std::holds_alternative<const syntax::Rule*>(writing.syntax))
        generations[{writing.rank, writing.fate}].push_back(&writing);
    }
    std::map<const Writing*, Share> all;
    for (const auto& [key, rules] : generations) {
      const std::vector<Share> parts = shares(explained_, rules);
      for (std::size_t i = 0; i < rules.size(); ++i) all.emplace(rules[i], parts[i]);
    }
    return all;
  }

  void put_rule(Json& json, const Writing& writing, const Share& share) const {
    const auto& rule = *std::get<const syntax::Rule*>(writing.syntax);
    json["condition"] = rule.guard ? Json(one_line(rule.guard->at)) : Json(nullptr);
    json["else"] = rule.guard_else;
    json["share"] = share.part ? Json(*share.part) : Json(nullptr);
    const SymbolRules* rules = explained_.style.find_symbol(story_.name);
    if (!rules || writing.fate == Fate::dropped) return;
    for (std::size_t i = 0; i < rules->generations.size(); ++i) {
      const Generation& own = rules->generations[i];
      if (own.from.style != writing.from.style || !uses_super(own)) continue;
      const bool last = i + 1 == rules->generations.size();
      json["super"] = last ? Json(nullptr) : Json(rules->generations[i + 1].from.style->name.text);
    }
  }

  static Json alternatives(const std::vector<Alternative>& all) {
    constexpr std::string_view endings[] = {"set", "add", "take", "remove"};
    Json json = Json::array();
    for (const Alternative& alternative : all) {
      Json& made = json.emplace_back(giver(alternative.from, alternative.at));
      made["fate"] = name_of(alternative.fate);
      made["text"] = alternative.text;
      if (alternative.share.part) made["share"] = *alternative.share.part;
      if (alternative.fate == Fate::in_force) continue;
      made["ended_by"] = giver(alternative.ended.from, alternative.ended.at);
      made["ended_by"]["how"] = alternative.fate == Fate::dropped
                                    ? "replace"
                                    : endings[static_cast<int>(alternative.ended.how)];
    }
    return json;
  }

  Json uses() const {
    Json json = Json::array();
    for (const Use& use : story_.uses) {
      const Story& speaker = explained_.stories.speaker(use);
      const Writing& writing = explained_.stories.writing(use);
      Json made{
          {"how", name_of(use.kind)}, {"kind", name_of(speaker.kind)}, {"by", speaker.full_name()}};
      made.update(giver(writing.from, use.at));
      made["fate"] = name_of(writing.fate);
      json.push_back(std::move(made));
    }
    return json;
  }

  const Explained& explained_;
  const Story& story_;
};

}  // namespace

std::string explained_json(const Explained& explained, const std::vector<const Story*>& stories) {
  const syntax::Style& style = *explained.style.syntax;
  Json json{{"style", style.name.text}};
  put_place(json, style.name.at);
  json["start"] = explained.style.start;
  json["abstract"] = !explained.style.missing.empty();
  json["circumstances"] = explained.circumstances;
  json["order"] = order_json(explained);
  json["members"] = Json::array();
  if (stories.empty()) {
    for (const Story& story : explained.stories.all())
      json["members"].push_back(MemberJson(explained, story).json());
  }
  for (const Story* story : stories)
    json["members"].push_back(MemberJson(explained, *story).json());
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace mansard
