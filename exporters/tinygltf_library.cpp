// tinygltf's own code, compiled here once: Debian's library is built with other switches, and the class changes with
// them.
#define TINYGLTF_IMPLEMENTATION
#include "exporters/tinygltf_switches.h"
