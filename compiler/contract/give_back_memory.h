// Gives memory that was freed back to the system.
#pragma once

#include <cstdlib>  // says which C library it is

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace citykiln {

/// Gives back what was freed: glibc keeps it for later otherwise, several times what a stage holds after many threads
/// have freed small objects. Does nothing with other C libraries. Cost: linear in the free blocks, some milliseconds.
inline void give_back_memory() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

}  // namespace citykiln
