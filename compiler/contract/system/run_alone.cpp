#include "compiler/contract/system/run_alone.h"

#include <tbb/task_arena.h>

namespace citykiln {

void run_alone(const std::function<void()>& work) {
  tbb::task_arena arena(1);
  arena.execute(work);
}

}  // namespace citykiln
