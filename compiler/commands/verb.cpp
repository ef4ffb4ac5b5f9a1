#include "compiler/commands/verb.h"

#include <fmt/format.h>

#include <cmath>

namespace citykiln::commands {
namespace {

std::string range_text(NumberRange range) {
  if (range.is_closed) return fmt::format("from {} to {}", range.low, range.high);
  const std::string low = fmt::format("above {}", range.low);
  return std::isinf(range.high) ? low : fmt::format("{} and below {}", low, range.high);
}

template <typename Number>
StoreValue store_in(Number& number, NumberRange range) {
  return [&number, range](const std::string& text) -> Result<Done> {
    const Result<double> given = parse_number(text);
    const bool is_inside = given && (range.is_closed ? *given >= range.low && *given <= range.high
                                                     : *given > range.low && *given < range.high);
    if (!is_inside) return Error{"", fmt::format("expected a number {}, found \"{}\"", range_text(range), text)};
    number = *given;
    return Done{};
  };
}

template <typename Number>
StoreValue store_tolerance_in(Number& tolerance_m) {
  return [&tolerance_m](const std::string& text) -> Result<Done> {
    const Result<double> given = parse_tolerance(text);
    if (!given) return given.error();
    tolerance_m = *given;
    return Done{};
  };
}

}  // namespace

StoreValue store_text(std::string& text) {
  return [&text](const std::string& given) -> Result<Done> {
    text = given;
    return Done{};
  };
}

StoreValue append_text(std::vector<std::string>& texts) {
  return [&texts](const std::string& given) -> Result<Done> {
    texts.push_back(given);
    return Done{};
  };
}

StoreValue store_number(double& number, NumberRange range) { return store_in(number, range); }
StoreValue store_number(std::optional<double>& number, NumberRange range) { return store_in(number, range); }

StoreValue store_tolerance(double& tolerance_m) { return store_tolerance_in(tolerance_m); }
StoreValue store_tolerance(std::optional<double>& tolerance_m) { return store_tolerance_in(tolerance_m); }

Option threads_option(int& threads) {
  return {"--threads", "N", "number of threads; 0 uses all processors (default: 0)", false, store_whole(threads, 0)};
}

}  // namespace citykiln::commands
