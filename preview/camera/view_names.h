// The names of the views that named_view() (camera.h) finds.
#pragma once

#include <string>

namespace citykiln::preview {

/// Returns all names with a separator between them: "street|low|overview|…".
std::string view_names(const char* separator);

}  // namespace citykiln::preview
