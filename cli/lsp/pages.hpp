// What there is to say of the words of the language: Markdown for hover and completion.
#pragma once

#include <string>
#include <string_view>

#include "interpreter/function.hpp"
#include "interpreter/operation.hpp"

namespace mansard::lsp {

/// "```style … ```"
std::string code(std::string_view text);

std::string page(const Operation& operation);
std::string page(const Function& function);
/// Of `name`, an attribute or input; empty when there is none.
std::string attribute_page(std::string_view name);
std::string selector_page(std::string_view name);
std::string annotation_page(std::string_view name);
/// Keywords and the like.
std::string word_page(std::string_view name);
/// Of an operation's part or argument.
std::string part_page(std::string_view operation, std::string_view part);
std::string argument_page(std::string_view operation, std::string_view argument);

}  // namespace mansard::lsp
