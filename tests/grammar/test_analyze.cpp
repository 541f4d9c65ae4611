// PEGTL's own check of the grammar: no rule loops without consuming anything.
#include <doctest/doctest.h>

#include <tao/pegtl/contrib/analyze.hpp>

#include "grammar/recovery.hpp"

namespace tao::pegtl {

// Whether the rules written by hand consume when they match.
template <class Name>
struct analyze_traits<Name, mansard::peg::ws> : analyze_opt_traits<> {};
template <class Name>
struct analyze_traits<Name, mansard::peg::end> : analyze_opt_traits<> {};
template <class Name>
struct analyze_traits<Name, mansard::peg::leave> : analyze_opt_traits<> {};
template <class Name>
struct analyze_traits<Name, mansard::peg::missing_brace> : analyze_opt_traits<> {};
template <class Name>
struct analyze_traits<Name, mansard::peg::name> : analyze_any_traits<> {};
template <class Name>
struct analyze_traits<Name, mansard::peg::text> : analyze_any_traits<> {};
template <class Name>
struct analyze_traits<Name, mansard::peg::doc> : analyze_any_traits<> {};
template <class Name, mansard::Level level>
struct analyze_traits<Name, mansard::peg::bad<level>> : analyze_any_traits<> {};

}  // namespace tao::pegtl

TEST_CASE("the grammar can not loop") {
  CHECK(tao::pegtl::analyze<mansard::peg::file>() == 0);
  CHECK(tao::pegtl::analyze<mansard::peg::only_expr>() == 0);
}
