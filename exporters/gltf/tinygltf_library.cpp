// tinygltf's own code, compiled here once: Debian's library is built with other switches, and the class changes with
// them.
// which tinygltf leaves out without files of its own, and then needs
#include <fstream>

#define TINYGLTF_IMPLEMENTATION
#include "exporters/gltf/tinygltf_config.h"
