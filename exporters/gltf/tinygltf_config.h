// tinygltf with one set of switches everywhere: no pictures, no files of its own, Debian's json.
#pragma once

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_INCLUDE_JSON
// a buffer of a .glb from elsewhere may name any file of the machine
#define TINYGLTF_NO_FS
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
// the second uses what the first declares
// clang-format off
#include <nlohmann/json.hpp>
#include <tiny_gltf.h>
// clang-format on

#pragma GCC diagnostic pop
