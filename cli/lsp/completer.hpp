// Collects what may be written at a place. Private to completion*.cpp.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "cli/lsp/place.hpp"
#include "cli/lsp/project.hpp"

namespace mansard::lsp {

class Completer {
 public:
  Completer(Project& project, View& view, Place place, Range word)
      : project_(project),
        view_(view),
        place_(std::move(place)),
        word_(word),
        style_(view.library().find(place_.style)) {}

  std::vector<Json> run();

 private:
  /// The protocol's numbers for what is completed.
  enum Shown : int {
    function = 3,
    variable = 6,
    style = 7,
    module = 9,
    property = 10,
    keyword = 14,
    file = 17,
    choice = 20,
    symbol = 21,
    operation = 24,
    parameter = 25,
  };
  struct Item {
    std::string label;
    int kind;
    std::string detail, documentation;
    std::string insert;  ///< empty: the label
    bool is_snippet = false;
    char rank = '5';  ///< '0' comes first
  };

  // completion.cpp
  void add(Item item);
  void add_words(std::initializer_list<std::string_view> words);
  void in_file();
  void in_style();
  void in_rules();
  void in_entries(bool materials);
  void in_successor();
  void in_part();
  void in_expression();
  void in_text();
  void in_import();
  void annotations();

  // completion_members.cpp
  void styles(std::string_view after);
  void symbols(const syntax::Style* style);
  void operations();
  void functions();
  void attributes();
  void attributes_of(std::string_view object);
  void parameters();
  void variables();
  void blocks();
  void members_of(std::string_view block);
  void selectors(std::string_view after);
  void part_names();
  void named_arguments();
  void overridable();
  void overridable_block();

  Project& project_;
  View& view_;
  Place place_;
  Range word_;
  const syntax::Style* style_;
  std::set<std::pair<std::string, int>> known_;
  std::vector<Json> items_;
};

}  // namespace mansard::lsp
