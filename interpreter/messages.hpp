// Small phrases that messages are made of.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "geometry/vector.hpp"
#include "grammar/diagnostic.hpp"
#include "interpreter/program.hpp"

namespace mansard {

/// "1 argument", "3 arguments".
std::string count_text(std::size_t n, std::string_view noun);
/// Shortest form, at most 6 significant digits.
std::string number_text(double value);
/// As a script writes it: "text" in quotes, [a, b], Other::SYMBOL.
std::string script_text(const Program& program, const Value& value);
/// Foreign text on one line, cut when it is long.
std::string shortened(std::string_view text);
/// "10 x 3 x 0 m".
std::string size_text(Vec3 size);
/// What is wrong with the types of the operands a and b of an infix operator, if anything.
std::optional<Diagnostic> operand_error(const Program& program, const ExprNode& node, Type left,
                                        Type right, ExprId a, ExprId b);
/// Notes where `what` ("a string") was written or set, unless the diagnostic points there already.
void note_writer(Diagnostic& diagnostic, std::string_view what, Span written);
/// Whether a number can be the angle of an axis: degrees, a whole turn at most; what to say if not.
bool is_angle(double degrees);
std::string wrong_angle(double degrees);
/// Whether a number can be that of a component, and what to say if it can not.
bool is_component_number(double number);
std::string wrong_component(double number);
/// Whether a number can be the tolerance of a split that snaps, in metres, and what to say if not.
bool is_tolerance(double metres);
std::string wrong_tolerance(double metres);
Diagnostic size_count_error(const Call& call, std::size_t sizes);

}  // namespace mansard
