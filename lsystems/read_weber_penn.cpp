#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "compiler/contract/texts/parse.h"
#include "lsystems/reading/read_lsystem.h"
#include "lsystems/reading/reader.h"
#include "lsystems/weber_penn.h"

namespace citykiln::lsystems {
namespace {

struct TreeRow {
  std::string_view name;
  double TreeParameters::*member;
  double least, most;
};
constexpr TreeRow kTreeRows[] = {
#define PARAMETER(name, member, least, most, value) {name, &TreeParameters::member, least, most},
#include "lsystems/weber_penn_parameters.inc"
};

struct LevelRow {
  std::string_view name;
  double StemParameters::*member;
  double least, most;
};
constexpr LevelRow kLevelRows[] = {
#define LEVEL_PARAMETER(name, member, least, most, value) {name, &StemParameters::member, least, most},
#include "lsystems/weber_penn_parameters.inc"
};

// The most stems that parameters may allow; a tree that exceeds kMostPlantParts stops while it grows.
constexpr double kMostAllowedStems = 4e6;

// A parameter of a tree, and its range.
struct Place {
  double* value;
  double least, most;
};

std::optional<Place> place_named(TreeParameters& tree, std::string_view name) {
  const auto row = std::ranges::find(kTreeRows, name, &TreeRow::name);
  if (row != std::end(kTreeRows)) return Place{&(tree.*row->member), row->least, row->most};
  if (name.empty() || name[0] < '0' || name[0] > '3') return std::nullopt;
  const auto of_level = std::ranges::find(kLevelRows, name.substr(1), &LevelRow::name);
  if (of_level == std::end(kLevelRows)) return std::nullopt;
  StemParameters& level = tree.level[static_cast<std::size_t>(name[0] - '0')];
  return Place{&(level.*of_level->member), of_level->least, of_level->most};
}

bool is_word(std::string_view text) {
  return !text.empty() && text.size() <= 40 && std::ranges::all_of(text, is_name_letter);
}

// Parameters that are counted in whole numbers.
bool is_whole(std::string_view name) {
  return name == "Shape" || name == "Levels" || name == "0BaseSplits" || name.ends_with("CurveRes");
}

// Puts a value; the message of an error, "" if there is none.
std::string put(TreeParameters& tree, std::string_view name, std::string_view value) {
  if (name == "Leaf" || name == "Bark") {
    if (!is_word(value))
      return fmt::format("expected a name such as {}, found '{}'", name == "Leaf" ? "oak_leaf" : "furrowed", value);
    (name == "Leaf" ? tree.leaf : tree.bark) = value;
    return "";
  }
  const std::optional<Place> place = place_named(tree, name);
  if (!place)
    return fmt::format("expected a parameter of Weber and Penn, such as Scale or 1DownAngle, found '{}'",
                       name.substr(0, 40));
  const std::optional<double> number = number_in<double>(value);
  const bool is_good = number && *number >= place->least && *number <= place->most &&
                       (!is_whole(name) || *number == std::floor(*number));
  if (!is_good)
    return fmt::format("{}: expected {} {} to {}, found '{}'", name,
                       is_whole(name) ? "a whole number from" : "a number from", place->least, place->most,
                       value.substr(0, 40));
  *place->value = *number;
  return "";
}

// The most stems that a tree may have, without clones.
double most_stems(const TreeParameters& tree) {
  double stems = 1, sum = 1;
  for (int n = 1; n < static_cast<int>(tree.levels); ++n)
    sum += stems *= std::max(tree.level[static_cast<std::size_t>(n)].branches, 1.0);
  return sum;
}

}  // namespace

Result<TreeParameters> read_weber_penn(std::string_view text, std::string_view file) {
  if (text.size() > kTextLimit)
    return Error{std::string(file), fmt::format("expected at most {} bytes, found {}", kTextLimit, text.size())};
  TreeParameters tree{.file = std::string(file), .leaf = "lime_leaf", .bark = ""};
  std::set<std::string_view> given;
  TextPosition most_branches{1, 1};
  std::uint32_t number = 0;
  for (const std::string_view line : split(text, '\n')) {
    ++number;
    const std::string_view words = trimmed(line.substr(0, line.find('#')));
    if (words.empty()) continue;
    const auto column = static_cast<std::uint32_t>(words.data() - line.data() + 1);
    const auto error = [&](std::string message) {
      return Error{position_name(file, {number, column}), std::move(message)};
    };
    const std::size_t equals = words.find('=');
    if (equals == std::string_view::npos)
      return error(fmt::format("expected 'name = value', found '{}'", words.substr(0, 40)));
    const std::string_view name = trimmed(words.substr(0, equals));
    if (std::string message = put(tree, name, trimmed(words.substr(equals + 1))); !message.empty())
      return error(std::move(message));
    if (!given.insert(name).second) return error(fmt::format("'{}' is given twice", name));
    // the last number of branches is the one that multiplies the others
    if (name.ends_with("Branches")) most_branches = {number, column};
  }
  if (const double stems = most_stems(tree); stems > kMostAllowedStems)
    return Error{position_name(file, most_branches),
                 fmt::format("expected at most {:.0f} stems, found parameters for {:.0f}", kMostAllowedStems, stems)};
  return tree;
}

}  // namespace citykiln::lsystems
