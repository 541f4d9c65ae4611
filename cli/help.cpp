// mansard help
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/argument_table.hpp"
#include "cli/arguments.hpp"
#include "cli/topics.hpp"
#include "cli/vocabulary.hpp"
#include "cli/word_pages.hpp"
#include "grammar/codes.hpp"
#include "grammar/parse.hpp"
#include "interpreter/attribute_table.hpp"
#include "interpreter/function.hpp"
#include "interpreter/operation.hpp"
#include "interpreter/selectors.hpp"
#include "styles/annotations.hpp"

namespace mansard {
namespace {

void print(const std::string& text) { std::fputs(text.c_str(), stdout); }

void overview() {
  print("mansard: buildings from footprints and .style scripts\n\nCommands\n");
  for (const Command& c : commands()) {
    std::printf("  %-8s %s\n", std::string(c.name).c_str(), std::string(c.summary).c_str());
  }
  print("\nTopics: ");
  for (const Topic& t : topics()) print(std::string(t.name) + " ");
  print(
      "operations functions annotations warnings\n\nmansard help WORD says more: a command, a "
      "topic, a "
      "warning, and every word and sign of\nthe language: mansard help roof, overhang, super, 1r, "
      "--sweep.\n");
}

void command_page(const Command& c) {
  print("mansard " + std::string(c.name) + " " + std::string(c.usage) + "\n\n  " +
        std::string(c.summary) + "\n\n");
  for (const Flag& f : c.flags) {
    const std::string left =
        std::string(f.name) + (f.value.empty() ? "" : " " + std::string(f.value));
    std::printf("  %-24s %s%s\n", left.c_str(), std::string(f.summary).c_str(),
                f.repeatable ? " (repeatable)" : "");
  }
  print("\nExamples\n");
  std::string_view rest = c.examples;
  while (!rest.empty()) {
    const auto end = rest.find('\n');
    print("  " + std::string(rest.substr(0, end)) + "\n");
    rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
  }
}

void named_line(std::string_view name, std::string_view summary) {
  std::printf("  %-14s %s\n", std::string(name).c_str(), std::string(summary).c_str());
}

void operation_page(const Operation& o) {
  print(usage(o) + "\n\n  " + std::string(o.summary) + "\n");
  if (o.count > 0) print("\nArguments\n");
  for (std::size_t i = 0; i < o.count; ++i) {
    const std::string_view name = o.parameter_name(i);
    named_line(
        name, std::string(argument_summary(o, name)) + (o.may_be_left_out(i) ? " (optional)" : ""));
  }
  if (!o.parts.empty()) print("\nParts\n");
  for (std::size_t i = 0; i < parts_in(o.parts); ++i)
    named_line(part_name(o.parts, i), part_summary(o, part_name(o.parts, i)));
  if (!o.example.empty()) print("\nExample\n  FOOTPRINT -> " + std::string(o.example) + "\n");
}

void function_page(const Function& f) {
  print(std::string(f.name) + "(" + std::string(f.args) + ")\n\n  " + std::string(f.summary) +
        "\n\nExample\n  " + std::string(f.example) + "\n");
}

void operations_list() {
  std::string_view group;
  for (const Operation& o : operations()) {
    if (o.group != group)
      std::printf("%s%s\n", group.empty() ? "" : "\n", std::string(o.group).c_str());
    group = o.group;
    std::printf("  %s\n      %s\n", usage(o).c_str(), std::string(o.summary).c_str());
  }
}

void functions_list() {
  for (const Function& f : functions()) {
    std::printf("%s(%s)\n    %s\n", std::string(f.name).c_str(), std::string(f.args).c_str(),
                std::string(f.summary).c_str());
  }
}

void annotations_list() {
  for (const AnnotationRow& a : annotation_rows()) {
    std::printf("%s\n    %s\n", usage(a).c_str(), std::string(a.summary).c_str());
  }
}

void codes_list() {
  for (const CodePage& c : code_pages()) {
    std::printf("%s  %s\n", std::string(c.code).c_str(), std::string(c.title).c_str());
  }
}

template <class Name>
nlohmann::ordered_json names(std::size_t count, Name name) {
  auto all = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < count; ++i) all.push_back(name(i));
  return all;
}

/// Objects of name and summary.
template <class Row>
nlohmann::ordered_json explained(std::size_t count, Row row) {
  return names(count, [&](std::size_t i) {
    const auto [name, summary] = row(i);
    return nlohmann::ordered_json{{"name", name}, {"summary", summary}};
  });
}

void all_as_json() {
  nlohmann::ordered_json json;
  for (const Command& c : commands()) {
    nlohmann::ordered_json flags = nlohmann::ordered_json::array();
    for (const Flag& f : c.flags)
      flags.push_back({{"name", f.name}, {"value", f.value}, {"summary", f.summary}});
    json["commands"].push_back(
        {{"name", c.name}, {"usage", c.usage}, {"summary", c.summary}, {"flags", flags}});
  }
  for (const Operation& o : operations()) {
    json["operations"].push_back(
        {{"name", o.name},
         {"group", o.group},
         {"usage", usage(o)},
         {"args", names(o.count, [&](std::size_t i) { return o.parameter_name(i); })},
         {"parts", names(parts_in(o.parts), [&](std::size_t i) { return part_name(o.parts, i); })},
         {"arguments", explained(o.count,
                                 [&](std::size_t i) {
                                   const std::string_view name = o.parameter_name(i);
                                   return std::pair(name, argument_summary(o, name));
                                 })},
         {"named_parts", explained(parts_in(o.parts),
                                   [&](std::size_t i) {
                                     const std::string_view name = part_name(o.parts, i);
                                     return std::pair(name, part_summary(o, name));
                                   })},
         {"summary", o.summary},
         {"example", o.example}});
  }
  for (const Function& f : functions()) {
    json["functions"].push_back(
        {{"name", f.name}, {"args", f.args}, {"summary", f.summary}, {"example", f.example}});
  }
  for (const CodePage& c : code_pages())
    json["warnings"].push_back({{"code", c.code}, {"title", c.title}, {"page", c.page}});
  const auto put = [&](const char* table, std::string_view name, std::string_view summary) {
    json[table].push_back({{"name", name}, {"summary", summary}});
  };
  for (const WordRow& w : word_rows()) put("words", w.name, w.summary);
  for (const AnnotationRow& a : annotation_rows()) put("annotations", a.name, a.summary);
  for (const std::string_view word : selector_words)
    put("selectors", word, selector_summary(*find_selector(word)));
  for (const AttributeRow& a : attributes()) put("attributes", a.name, a.summary);
  for (const InputRow& i : inputs()) put("inputs", i.name, i.summary);
  json["keywords"] = nlohmann::ordered_json::array();
  for (const std::string_view k : keywords()) json["keywords"].push_back(k);
  print(json.dump(1) + "\n");
}

bool page(std::string_view topic) {
  if (topic == "operations") return operations_list(), true;
  if (topic == "functions") return functions_list(), true;
  if (topic == "warnings") return codes_list(), true;
  if (topic == "annotations") return annotations_list(), true;
  if (const Command* c = find_command(topic)) return command_page(*c), true;
  if (const Operation* o = find_operation(topic)) return operation_page(*o), true;
  for (const std::string& name : {std::string(topic), "Shape." + std::string(topic)}) {
    if (const Function* f = find_function(name)) return function_page(*f), true;
  }
  if (const CodePage* c = find_code(topic)) {
    print(std::string(c->code) + ": " + std::string(c->title) + "\n\n" + std::string(c->page) +
          "\n");
    return true;
  }
  for (const Topic& t : topics()) {
    if (t.name != topic) continue;
    print(std::string(t.title) + "\n\n" + std::string(t.page) + "\n");
    return true;
  }
  return false;
}

}  // namespace

int run_help(const Arguments& arguments) {
  if (arguments.has("--json")) return all_as_json(), exit_done;
  if (arguments.positional().empty()) return overview(), exit_done;
  std::string topic = arguments.positional()[0];
  if (topic.size() > 2 && topic.ends_with("()")) topic.resize(topic.size() - 2);
  const std::string words = word_page(topic);
  const bool has_page = page(topic);
  print((has_page && !words.empty() ? "\n" : "") + words);
  if (has_page || !words.empty()) return exit_done;
  std::vector<std::string_view> known = words_with_pages();
  known.insert(known.end(), {"operations", "functions", "annotations", "warnings"});
  for (const Command& c : commands()) known.push_back(c.name);
  for (const Operation& o : operations()) known.push_back(o.name);
  for (const Function& f : functions()) known.push_back(f.name);
  for (const Topic& t : topics()) known.push_back(t.name);
  const auto meant = nearest(topic, known);
  throw UsageError(
      "no help on '" + topic + "'" +
      (meant ? "; did you mean '" + std::string(*meant) + "'?" : ": see 'mansard help'"));
}

}  // namespace mansard
