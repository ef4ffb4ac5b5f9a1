// Compiles tinygltf's implementation once: Debian's library is built with other switches, which change its classes.

// tinygltf's implementation uses these but, with our switches, does not include them
#include <fstream>
#include <nlohmann/json.hpp>

#define TINYGLTF_IMPLEMENTATION
#include "exporters/gltf/read/tinygltf_config.h"
