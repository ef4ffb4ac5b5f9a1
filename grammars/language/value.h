// What an expression is worth: a number, a truth or a text.
#pragma once

#include <string>
#include <variant>

namespace citykiln::grammars {

/// CGA's float, bool and string.
using Value = std::variant<double, bool, std::string>;

const char* kind_name(const Value& value);  ///< "float", "bool", "string".

/// Conversions as CGA's float(), bool() and str() make them; what cannot be read is 0 or false.
double number_of(const Value& value);
bool truth_of(const Value& value);
std::string text_of(const Value& value);  ///< Of a number its shortest digits that read back as itself.

}  // namespace citykiln::grammars
