// The grammar of a .style file, one rule a line, read like the printed grammar of docs/language.md.
// Space and comments are skipped before every token; what must stand against its left neighbour is
// called `tight`. Included by parse.cpp (and by the test that analyses the grammar) only.
#pragma once

#include "grammar/lexical.hpp"

namespace mansard::peg {

// clang-format off

// ---- values
struct expr; struct body; struct part; struct parts;
struct op_pre         : seq<ws, sor<minus, seq<one<'!'>, not_at<one<'='>>>>> {};
struct op_mul         : seq<ws, sor<seq<one<'*'>, not_at<one<'*'>>>, one<'/'>>> {};
struct op_add         : seq<ws, sor<one<'+'>, minus>> {};
struct op_cmp         : seq<ws, sor<string<'<', '='>, string<'>', '='>, string<'=', '='>, string<'!', '='>, one<'<'>, one<'>'>>> {};
struct op_and         : seq<ws, string<'&', '&'>> {};
struct op_or          : seq<ws, string<'|', '|'>> {};
struct floating       : seq<T<"~">, expr> {};
struct dont_care      : seq<colon> {};
struct size           : sor<floating, dont_care, expr> {};
struct named_start    : at<word, assign> {};
struct named          : seq<named_start, word, assign, size> {};
struct arg            : sor<named, size> {};
struct args           : seq<T<"(">, opt<list<arg, comma>>, T<")">> {};
struct index          : seq<tight<'['>, expr, T<"]">> {};
struct member_name    : seq<dot, word> {};
struct qualified      : seq<name, ws, two<':'>, name> {};
struct reference      : seq<sor<qualified, name>, many<member_name>> {};
struct call           : seq<reference, maybe<args>> {};
struct list_value     : seq<T<"[">, opt<list<expr, comma>>, T<"]">> {};
struct parenthesis    : seq<T<"(">, expr, T<")">> {};
struct amount         : seq<sor<number, parenthesis>, opt<unit>> {};
struct boolean        : sor<K<"true">, K<"false">> {};
struct primary        : sor<amount, text, list_value, boolean, call> {};
struct subscript      : seq<primary, many<index>> {};
struct unary          : seq<many<op_pre>, subscript> {};
struct multiplication : seq<unary, many<op_mul, unary>> {};
struct addition       : seq<multiplication, many<op_add, multiplication>> {};
struct comparison     : seq<addition, maybe<op_cmp, addition>> {};
struct conjunction    : seq<comparison, many<op_and, comparison>> {};
struct disjunction    : seq<conjunction, many<op_or, conjunction>> {};
struct conditional    : seq<K<"if">, expr, K<"then">, expr, K<"else">, expr> {};
struct expr           : sor<conditional, disjunction> {};

// ---- heads of rules
struct params         : seq<T<"(">, opt<list<name, comma>>, T<")">> {};
struct head_index     : seq<tight<'['>, sor<number, name>, T<"]">> {};
struct guard_else     : K<"else"> {};
struct guard          : seq<colon, sor<seq<guard_else, maybe<expr>>, expr>> {};
struct head           : seq<name, maybe<params>, maybe<head_index>, maybe<guard>, at<arrow>> {};
struct modifier       : sor<K<"final">, K<"override">> {};
struct member_start   : sor<head, seq<K<"var">, name>, seq<K<"def">, name>, seq<K<"abstract">, sor<name, K<"var">>>, seq<modifier, sor<name, K<"var">, K<"def">>>, seq<T<"@">, word>> {};
struct block_start    : seq<opt<K<"replace">>, sor<seq<sor<elements_name, materials_name>, T<"{">>, seq<name, T<"{">, member_start>>> {};
struct not_head       : not_at<head> {};
struct not_block      : not_at<block_start> {};
struct value_here     : not_at<head> {};
struct value          : seq<value_here, expr> {};

// ---- successors
struct push           : seq<T<"[">, body, T<"]">> {};
struct branch         : seq<T<"{">, body, T<"}">> {};
struct else_if        : seq<K<"else">, K<"if">, expr, branch> {};
struct else_branch    : seq<K<"else">, branch> {};
struct if_            : seq<K<"if">, expr, branch, many<else_if>, maybe<else_branch>> {};
struct super_         : K<"super"> {};
struct of_style       : seq<K<"style">, parenthesis, T<"::">> {};
struct emitted        : sor<seq<of_style, name>, qualified, name> {};
struct emit           : seq<emitted, maybe<args>, maybe<index>, maybe<parts, no_bracket>> {};
struct element_kind   : sor<push, if_, super_, emit> {};
struct element        : seq<not_head, not_block, element_kind> {};
struct body           : seq<element, many<element>> {};
struct word_label     : seq<word, colon> {};
struct amount_label   : seq<at<ws, sor<digit, one<'.', '(', '~', ':', '"', '-', '!'>>>, size, colon> {};
struct other_label    : seq<at<expr, colon>, expr, colon> {};
struct label          : sor<word_label, amount_label, other_label> {};
struct part_list      : seq<T<"{">, list<part, bar>, T<"}">> {};
struct group          : seq<part_list, T<"*">> {};
struct part           : sor<group, seq<maybe<label>, body>> {};
struct star_          : T<"*"> {};
struct parts          : seq<part_list, maybe<star_>> {};

// ---- members of blocks and styles
struct annotation     : seq<T<"@">, word, maybe<args>> {};
struct preamble       : many<sor<doc, annotation>> {};
struct probability    : seq<colon, value> {};
struct rule           : seq<head, arrow, body, maybe<probability>> {};
struct plain_primary  : sor<amount, text, boolean, list_value, reference> {};
struct plain_value    : seq<many<op_pre>, plain_primary> {};
struct variable       : seq<K<"var">, name, sor<seq<assign, value>, seq<value_here, plain_value>>> {};
struct function       : seq<K<"def">, name, params, assign, value> {};
struct abstract_var   : seq<K<"abstract">, K<"var">, name> {};
struct abstract_name  : seq<K<"abstract">, name, maybe<params>> {};
struct plain_item     : sor<variable, function, rule> {};
struct any_item       : sor<abstract_var, abstract_name, seq<many<modifier>, plain_item>> {};
struct block_item     : seq<preamble, any_item> {};
struct start          : seq<K<"start">, name> {};
struct shared_item    : sor<variable, function> {};
struct style_item     : sor<abstract_var, abstract_name, seq<many<modifier>, shared_item>, start> {};

// ---- elements and materials
struct entry_kind     : sor<colon, T<"+">, seq<ws, minus>> {};
struct weight         : seq<colon, expr> {};
struct meshes         : seq<plus<text>, maybe<weight>> {};
struct more_meshes    : seq<opt<bar>, meshes> {};
struct removed        : seq<K<"remove">, name> {};
struct element_entry  : seq<name, entry_kind, meshes, many<more_meshes>> {};
struct element_item   : seq<preamble, sor<removed, element_entry>> {};
struct look           : seq<name, args> {};
struct looks          : seq<look, many<look>, maybe<weight>> {};
struct more_looks     : seq<opt<bar>, looks> {};
struct per            : seq<K<"per">, text> {};
struct material_entry : seq<name, entry_kind, looks, many<more_looks>, maybe<per>> {};
struct material_item  : seq<preamble, sor<removed, material_entry>> {};

// ---- blocks, styles, files
template <class Item, class Bad> struct members : seq<T<"{">, star<not_at<sor<at<T<"}">>, leave>>, sor<Item, Bad>>, sor<T<"}">, missing_brace>> {};
struct replace        : seq<K<"replace">, at<ws, identifier>> {};
struct elements_head  : seq<elements_name, at<T<"{">>> {};
struct materials_head : seq<materials_name, at<T<"{">>> {};
struct rules_head     : seq<name, at<T<"{">>> {};
struct elements       : members<element_item, bad_element> {};
struct materials      : members<material_item, bad_material> {};
struct rules          : members<block_item, bad_item> {};
struct block          : seq<maybe<replace>, sor<seq<elements_head, elements>, seq<materials_head, materials>, seq<rules_head, rules>>> {};
struct any_member     : sor<style_item, block> {};
struct style_member   : seq<preamble, any_member> {};
struct style_members  : members<style_member, bad_member> {};
struct parents        : seq<colon, list<name, comma>> {};
struct style_word     : sor<K<"style">, K<"class">> {};
struct style_head     : seq<preamble, maybe<final_>, style_word, name, maybe<parents>, at<T<"{">>> {};
struct style          : seq<style_head, style_members> {};
struct import_        : seq<K<"import">, text> {};
struct top            : sor<import_, style> {};
struct file           : seq<opt<utf8::bom>, star<not_at<end>, sor<top, bad_style>>, end> {};
struct only_expr      : seq<expr, expr_end> {};

// ---- where reading goes on after an error
struct rule_start     : seq<preamble, star<modifier>, head> {};
struct style_start    : sor<seq<preamble, opt<final_>, style_word, name, sor<colon, T<"{">>>, seq<K<"import">, text>> {};
struct any_block      : seq<preamble, opt<replace>, block_start> {};
struct style_item_start : sor<seq<K<"var">, name>, seq<K<"def">, name, T<"(">>, seq<K<"abstract">, sor<name, K<"var">>>, seq<K<"start">, name>, seq<T<"@">, word>> {};
struct element_start  : sor<seq<name, entry_kind, text>, seq<K<"remove">, name>, seq<T<"@">, word>> {};
struct material_start : sor<seq<name, entry_kind, name, T<"(">>, seq<K<"remove">, name>, seq<T<"@">, word>> {};

// clang-format on

}  // namespace mansard::peg
