// The programs that .glb files can be written for, and which features of glTF they read (targets.inc).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "compiler/contract/layout.h"

namespace citykiln {

/// The rows of targets.inc.
enum class Target : std::uint8_t {
#define TARGET(name, ...) name,
#include "compiler/contract/targets.inc"
#undef TARGET
  kCount
};

/// How instances are written: by EXT_mesh_gpu_instancing, or as one node each that refers to a shared mesh.
enum class Instancing : std::uint8_t { kExtension, kNodes };

/// A row of targets.inc.
struct TargetValues {
  std::string_view name;  ///< The value of --target, such as "generic".
  Instancing instancing{};
  std::size_t most_nodes = 0;  ///< The number of instances above which a tile is slow; 0: no limit.
  Layout layout{};             ///< The default of --layout.
  bool reads_quantised = false, reads_draco = false, reads_meshopt = false;
  bool reads_texture_transform = false;
  bool reads_webp = false;
  bool reads_lights = false;
  bool culls_backs = false;      ///< Leaves out faces seen from behind, so that leaves need faces for both sides.
  bool shades_flat = false;      ///< Shades faces flat, and loads faster, if a mesh has no normals.
  std::string_view tested_with;  ///< "Blender 3.4"; empty for an untested preset.
};

/// Returns the row of a target.
const TargetValues& values_of(Target target);

/// Returns the target with a name such as "blender"; empty if there is none.
std::optional<Target> target_named(std::string_view name);

/// Returns the names of the targets that `wanted` accepts, such as "generic, blender or godot".
std::string targets_with(bool (*wanted)(const TargetValues&));

}  // namespace citykiln
