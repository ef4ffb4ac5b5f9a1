// Returns freed memory to the system.
#pragma once

#include <cstdlib>  // defines __GLIBC__

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace citykiln {

/// Returns freed memory to the system. Otherwise glibc keeps it, which can be several times what a stage holds after
/// many threads have freed small objects. Does nothing with other C libraries. Cost: linear in the free blocks, some
/// milliseconds.
inline void give_back_memory() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

}  // namespace citykiln
