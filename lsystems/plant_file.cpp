#include "lsystems/plant_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "lsystems/reading/read_lsystem.h"
#include "lsystems/reading/read_rpforest.h"
#include "lsystems/reading/reader.h"
#include "lsystems/rewriting/turtle.h"

namespace citykiln::lsystems {

namespace {

// The L-system that a tree stands for: the name of its leaves, and its bark.
PlantFile plant_of(TreeParameters tree) {
  PlantFile plant;
  plant.system.file = tree.file, plant.system.bark = tree.bark;
  plant.system.kinds.push_back({.name = "~" + tree.leaf, .op = TurtleOp::kInstance});
  plant.tree = std::move(tree);
  return plant;
}

// Limits at which a plant without end stops within a second. Shipped plants need a hundredth of them.
constexpr Limits kPlantLimits = {.symbols = 8'000'000, .written = 50'000'000, .steps = 10'000, .work = 200'000'000};

// "rule F" and its place: the rule before a position of the file, or of the most frequent module.
struct NamedRule {
  TextPosition place;
  std::string name;
};

bool is_at_or_before(TextPosition a, TextPosition b) {
  return std::pair(a.line, a.column) <= std::pair(b.line, b.column);
}

// The last rule that begins at or before a position; without a name if there is none, as in the axiom.
NamedRule rule_before(const LSystem& system, TextPosition position) {
  NamedRule found;
  for (const RuleSet* set : {&system.productions, &system.decomposition, &system.interpretation})
    for (const Rule& rule : set->rules)
      if (is_at_or_before(rule.place, position) && is_at_or_before(found.place, rule.place))
        found = {rule.place, system.kinds[rule.predecessor].name};
  return found;
}

// The first rule of the module that is most frequent in a string, among those that have one.
NamedRule most_frequent_rule(const LSystem& system, const ModuleString& string) {
  std::vector<std::size_t> counts(system.kinds.size());
  for (const Kind kind : string.kinds) ++counts[kind];
  NamedRule found;
  std::size_t most = 0;
  for (const RuleSet* set : {&system.productions, &system.decomposition, &system.interpretation})
    for (const Rule& rule : set->rules)
      if (counts[rule.predecessor] > most)
        most = counts[rule.predecessor], found = {rule.place, system.kinds[rule.predecessor].name};
  return found;
}

Error error_in(const LSystem& system, TextPosition place, const NamedRule& rule, const std::string& message) {
  const std::string where = place.line == 0 ? system.file : position_name(system.file, place);
  return {where, rule.name.empty() ? message : fmt::format("rule {}: {}", rule.name, message)};
}

Error stopped_by(const LSystem& system, const Derivation& derivation) {
  const NamedRule rule = most_frequent_rule(system, derivation.string);
  return error_in(system, rule.place, rule, limit_text(*derivation.limit_exceeded) + "; it grows without end");
}

// The first value without a result. Warnings of the turtle have no place and are not meant.
std::optional<Error> undefined_in(const LSystem& system, const Derivation& derivation) {
  const auto found =
      std::ranges::find_if(derivation.warnings, [](const Warning& warning) { return warning.place.line > 0; });
  if (found == derivation.warnings.end()) return std::nullopt;
  return error_in(system, found->place, rule_before(system, found->place),
                  "this value is no number, as after a division by zero");
}

}  // namespace

Result<PlantFile> read_plant_file(std::string_view text, std::string_view file) {
  // a byte-order mark of an editor
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  if (file.ends_with(".tree")) {
    Result<TreeParameters> tree = read_weber_penn(text, file);
    if (!tree) return tree.error();
    return plant_of(std::move(*tree));
  }
  Result<LSystem> system = is_rpforest(text, file) ? read_rpforest(text, file) : read_lsystem(text, file);
  if (!system) return system.error();
  return PlantFile{std::move(*system)};
}

GrownSkeleton grow_plant(const PlantFile& plant, std::uint64_t seed) {
  if (plant.tree) {
    GrownTree tree = grow_tree(*plant.tree, seed);
    GrownSkeleton result{std::move(tree.skeleton), {}, {}};
    if (tree.stopped)
      result.stopped =
          Error{plant.tree->file, fmt::format("expected at most {} stems and leaves, found more", kMostPlantParts)};
    return result;
  }
  DeriveOptions options;
  options.seed = seed, options.limits = kPlantLimits;
  Plant grown = grow(plant.system, options);
  GrownSkeleton result{std::move(grown.skeleton), {}, undefined_in(plant.system, grown.derivation)};
  if (grown.derivation.limit_exceeded) result.stopped = stopped_by(plant.system, grown.derivation);
  return result;
}

}  // namespace citykiln::lsystems
