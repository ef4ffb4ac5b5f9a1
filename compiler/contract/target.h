// Targets: the programs that .glb files are written for, and what their readers know (targets.inc).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace citykiln {

enum class Target : std::uint8_t {
#define TARGET(name, ...) name,
#include "compiler/contract/targets.inc"
#undef TARGET
  kCount
};

/// How instances are written: by EXT_mesh_gpu_instancing, or by one node each that share a mesh.
enum class Instancing : std::uint8_t { kExtension, kNodes };

/// A row of targets.inc.
struct TargetValues {
  std::string_view name;  ///< "generic".
  Instancing instancing{};
  std::size_t most_nodes = 0;  ///< With more instances a tile becomes slow; 0: no limit.
  bool reads_quantised = false, reads_draco = false, reads_meshopt = false;
  bool reads_texture_transform = false;
  bool reads_webp = false;
  bool reads_lights = false;
  bool shades_flat = false;
  std::string_view tested_with;  ///< "Blender 3.4"; empty for an untested preset.
};

const TargetValues& values_of(Target target);

std::optional<Target> target_named(std::string_view name);

/// "generic, blender or godot": the names of the targets that `wanted` accepts.
std::string targets_with(bool (*wanted)(const TargetValues&));

}  // namespace citykiln
