#include "lsystems/plant_file.h"

#include <fmt/core.h>

#include <utility>

#include "lsystems/read_lsystem.h"
#include "lsystems/read_rpforest.h"
#include "lsystems/turtle.h"

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

}  // namespace

Result<PlantFile> read_plant_file(std::string_view text, std::string_view file) {
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
    GrownSkeleton result{std::move(tree.skeleton), std::nullopt};
    if (tree.stopped)
      result.stopped =
          Error{plant.tree->file, fmt::format("expected at most {} stems and leaves, found more", kMostPlantParts)};
    return result;
  }
  DeriveOptions options;
  options.seed = seed;
  Plant grown = grow(plant.system, options);
  GrownSkeleton result{std::move(grown.skeleton), std::nullopt};
  if (grown.derivation.limit_exceeded)
    result.stopped = Error{"", limit_line(plant.system, *grown.derivation.limit_exceeded)};
  return result;
}

}  // namespace citykiln::lsystems
