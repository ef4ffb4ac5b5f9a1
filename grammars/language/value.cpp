#include "grammars/language/value.h"

#include <charconv>
#include <cmath>

namespace citykiln::grammars {
namespace {

double number_in(const std::string& text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && std::isfinite(number) ? number : 0;
}

std::string digits_of(double number) {
  char digits[32];
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, number);
  return std::string(digits, end);
}

}  // namespace

const char* kind_name(const Value& value) {
  constexpr const char* kNames[] = {"float", "bool", "string"};
  return kNames[value.index()];
}

double number_of(const Value& value) {
  if (const bool* truth = std::get_if<bool>(&value)) return *truth ? 1 : 0;
  if (const std::string* text = std::get_if<std::string>(&value)) return number_in(*text);
  return std::get<double>(value);
}

bool truth_of(const Value& value) {
  if (const double* number = std::get_if<double>(&value)) return *number != 0;
  if (const std::string* text = std::get_if<std::string>(&value)) return *text == "true" || number_in(*text) != 0;
  return std::get<bool>(value);
}

std::string text_of(const Value& value) {
  if (const double* number = std::get_if<double>(&value)) return digits_of(*number);
  if (const bool* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  return std::get<std::string>(value);
}

}  // namespace citykiln::grammars
