// What happens when a rule of the grammar has matched: phrases go on the tape under a tag, and
// members, complete, from the tape into the tree. Nothing of a refused phrase stays on the tape.
#pragma once

#include "grammar/messages.hpp"

namespace mansard::peg {

// clang-format off
template <class Rule> inline constexpr Tag tag = Tag::none;
template <> inline constexpr Tag tag<name> = Tag::name;
template <> inline constexpr Tag tag<elements_name> = Tag::name;
template <> inline constexpr Tag tag<materials_name> = Tag::name;
template <> inline constexpr Tag tag<qualified> = Tag::qualified;
template <> inline constexpr Tag tag<word> = Tag::word;
template <> inline constexpr Tag tag<style_word> = Tag::word;
template <> inline constexpr Tag tag<number> = Tag::number;
template <> inline constexpr Tag tag<text> = Tag::text;
template <> inline constexpr Tag tag<boolean> = Tag::boolean;
template <> inline constexpr Tag tag<list_value> = Tag::list;
template <> inline constexpr Tag tag<parenthesis> = Tag::parenthesis;
template <> inline constexpr Tag tag<unit> = Tag::unit;
template <> inline constexpr Tag tag<amount> = Tag::amount;
template <> inline constexpr Tag tag<op_pre> = Tag::op;
template <> inline constexpr Tag tag<op_mul> = Tag::op;
template <> inline constexpr Tag tag<op_add> = Tag::op;
template <> inline constexpr Tag tag<op_cmp> = Tag::op;
template <> inline constexpr Tag tag<op_and> = Tag::op;
template <> inline constexpr Tag tag<op_or> = Tag::op;
template <> inline constexpr Tag tag<reference> = Tag::reference;
template <> inline constexpr Tag tag<call> = Tag::call;
template <> inline constexpr Tag tag<subscript> = Tag::subscript;
template <> inline constexpr Tag tag<unary> = Tag::unary;
template <> inline constexpr Tag tag<plain_value> = Tag::unary;
template <> inline constexpr Tag tag<multiplication> = Tag::chain;
template <> inline constexpr Tag tag<addition> = Tag::chain;
template <> inline constexpr Tag tag<comparison> = Tag::chain;
template <> inline constexpr Tag tag<conjunction> = Tag::chain;
template <> inline constexpr Tag tag<disjunction> = Tag::chain;
template <> inline constexpr Tag tag<conditional> = Tag::conditional;
template <> inline constexpr Tag tag<named> = Tag::named;
template <> inline constexpr Tag tag<floating> = Tag::floating;
template <> inline constexpr Tag tag<dont_care> = Tag::dont_care;
template <> inline constexpr Tag tag<args> = Tag::args;
template <> inline constexpr Tag tag<index> = Tag::index;
template <> inline constexpr Tag tag<push> = Tag::push;
template <> inline constexpr Tag tag<if_> = Tag::if_;
template <> inline constexpr Tag tag<super_> = Tag::super_;
template <> inline constexpr Tag tag<of_style> = Tag::of_style;
template <> inline constexpr Tag tag<emit> = Tag::emit;
template <> inline constexpr Tag tag<body> = Tag::body;
template <> inline constexpr Tag tag<label> = Tag::label;
template <> inline constexpr Tag tag<part> = Tag::part;
template <> inline constexpr Tag tag<group> = Tag::group;
template <> inline constexpr Tag tag<parts> = Tag::parts;
template <> inline constexpr Tag tag<star_> = Tag::star;
template <> inline constexpr Tag tag<doc> = Tag::doc;
template <> inline constexpr Tag tag<annotation> = Tag::annotation;
template <> inline constexpr Tag tag<modifier> = Tag::modifier;
template <> inline constexpr Tag tag<final_> = Tag::modifier;
template <> inline constexpr Tag tag<params> = Tag::params;
template <> inline constexpr Tag tag<head_index> = Tag::index;
template <> inline constexpr Tag tag<guard> = Tag::guard;
template <> inline constexpr Tag tag<guard_else> = Tag::guard_else;
template <> inline constexpr Tag tag<head> = Tag::head;
template <> inline constexpr Tag tag<probability> = Tag::probability;
template <> inline constexpr Tag tag<rule> = Tag::rule;
template <> inline constexpr Tag tag<variable> = Tag::variable;
template <> inline constexpr Tag tag<function> = Tag::function;
template <> inline constexpr Tag tag<abstract_var> = Tag::abstract_variable;
template <> inline constexpr Tag tag<abstract_name> = Tag::abstract_symbol;
template <> inline constexpr Tag tag<start> = Tag::start;
template <> inline constexpr Tag tag<replace> = Tag::replace;
template <> inline constexpr Tag tag<parents> = Tag::parents;
template <> inline constexpr Tag tag<meshes> = Tag::alternative;
template <> inline constexpr Tag tag<looks> = Tag::alternative;
template <> inline constexpr Tag tag<weight> = Tag::weight;
template <> inline constexpr Tag tag<look> = Tag::look;
template <> inline constexpr Tag tag<entry_kind> = Tag::entry_kind;
template <> inline constexpr Tag tag<removed> = Tag::entry;
template <> inline constexpr Tag tag<element_entry> = Tag::entry;
template <> inline constexpr Tag tag<material_entry> = Tag::entry;
template <> inline constexpr Tag tag<per> = Tag::per;
// clang-format on

template <class Rule, class... Rules>
inline constexpr bool is_any_of = (std::is_same_v<Rule, Rules> || ...);

/// A phrase of one part only is that part.
template <class Rule>
inline constexpr bool folds =
    is_any_of<Rule, amount, reference, call, subscript, unary, plain_value, multiplication,
              addition, comparison, conjunction, disjunction>;
/// Stands against its left neighbour; doc looks at the space before it.
template <class Rule>
inline constexpr bool is_tight =
    is_any_of<Rule, unit, index, head_index, doc, number_end, no_bracket>;
/// The bracket, or the `if`, that a rule begins with and that is open until the rule is done.
template <class Rule>
inline constexpr char opener =
    is_any_of<Rule, args, parenthesis, params>                                      ? '('
    : is_any_of<Rule, index, list_value, head_index, push>                          ? '['
    : is_any_of<Rule, branch, part_list, elements, materials, rules, style_members> ? '{'
    : is_any_of<Rule, conditional>                                                  ? 'i'
                                                                                    : '\0';
/// What is refused inside is not worth telling.
template <class Rule>
inline constexpr bool is_quiet =
    is_any_of<Rule, named_start, not_head, value_here, not_block, word_label, other_label, end,
              style_start, any_block, member_start, style_item_start, element_start,
              material_start>;
template <class Rule>
inline constexpr bool hushes = false;
template <class... Rules>
inline constexpr bool hushes<hush<Rules...>> = true;

template <class Rule>
struct action : nothing<Rule> {};

// clang-format off
template <> struct action<import_> { static void apply0(Reading& r) { r.tree.take_import(); } };
template <> struct action<style_head> { static void apply0(Reading& r) { r.tree.take_style_head(); } };
template <> struct action<elements_head> { static void apply0(Reading& r) { r.tree.take_block_head(syntax::BlockKind::elements); } };
template <> struct action<materials_head> { static void apply0(Reading& r) { r.tree.take_block_head(syntax::BlockKind::materials); } };
template <> struct action<rules_head> { static void apply0(Reading& r) { r.tree.take_block_head(syntax::BlockKind::rules); } };
template <> struct action<block_item> { static void apply0(Reading& r) { r.take_block_item(); } };
template <> struct action<style_item> { static void apply0(Reading& r) { r.tree.take_style_item(); } };
template <> struct action<element_item> { static void apply0(Reading& r) { r.tree.take_element_entry(); } };
template <> struct action<material_item> { static void apply0(Reading& r) { r.tree.take_material_entry(); } };
template <> struct action<block> { template <class In> static void apply(const In& in, Reading& r) { r.end_block(in.end()); } };
template <> struct action<style> { template <class In> static void apply(const In& in, Reading& r) { r.end_style(in.end()); } };
// clang-format on

}  // namespace mansard::peg
