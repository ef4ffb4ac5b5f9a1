// Files of plants in any notation: our .lsys, RPForest's .lsys, .honda and .family, and Weber and Penn's .tree.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "compiler/contract/result.h"
#include "lsystems/rewriting/skeleton.h"
#include "lsystems/weber_penn.h"

namespace citykiln::lsystems {

/// The extensions of plant files.
inline constexpr std::array<std::string_view, 4> kPlantEndings = {".lsys", ".honda", ".family", ".tree"};

/// A file of a plant.
struct PlantFile {
  LSystem system;                        ///< A .tree file sets only the kinds of instances and the bark.
  std::optional<TreeParameters> tree{};  ///< The parameters of a .tree file.
};

/// Reads a file. Its extension decides the notation; .lsys is read as ours unless it begins as RPForest's files do
/// (is_rpforest()).
///
/// @param file  The file's name, also in error messages.
/// Errors: those of read_lsystem(), read_rpforest() and read_weber_penn().
Result<PlantFile> read_plant_file(std::string_view text, std::string_view file);

/// A plant that is grown: the skeleton, the limit that stopped it before its end, and the first value that is no
/// number.
struct GrownSkeleton {
  Skeleton skeleton;
  std::optional<Error> stopped;    ///< "oak.lsys:4:1", "rule F: the string would have more than …".
  std::optional<Error> undefined;  ///< "oak.lsys:4:11", "rule A: …", such as after a division by zero.
};

/// Grows a plant.
/// @param seed  The seed of its random numbers.
GrownSkeleton grow_plant(const PlantFile& plant, std::uint64_t seed);

}  // namespace citykiln::lsystems
