// Returns freed memory to the system.
#pragma once

#include <cstdlib>  // defines __GLIBC__

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace citykiln {

/// Returns freed memory to the system. glibc keeps freed memory otherwise; after many threads have freed small objects,
/// this can be several times the memory in use. Does nothing with other C libraries. Cost: linear in the free blocks,
/// some milliseconds.
inline void give_back_memory() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

}  // namespace citykiln
