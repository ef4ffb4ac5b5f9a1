#include "compiler/contract/system/once.h"

#include <tbb/collaborative_call_once.h>

namespace citykiln {

struct Once::Flag {
  tbb::collaborative_once_flag flag;
};

Once::Once() : flag_(std::make_unique<Flag>()) {}
Once::~Once() = default;

void Once::call(const std::function<void()>& make) { tbb::collaborative_call_once(flag_->flag, make); }

}  // namespace citykiln
