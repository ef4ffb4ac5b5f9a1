// The value of an expression: a number, a truth value or a string.
#pragma once

#include <string>
#include <variant>

namespace citykiln::grammars {

/// CGA's float, bool and string.
using Value = std::variant<double, bool, std::string>;

const char* kind_name(const Value& value);  ///< "float", "bool", "string".

/// Converts a value like CGA's float(), bool() and str(). A string that is not a number or truth value gives 0 or
/// false. A number is written with the fewest digits that read back as the same number.
double number_of(const Value& value);
bool truth_of(const Value& value);
std::string text_of(const Value& value);

}  // namespace citykiln::grammars
