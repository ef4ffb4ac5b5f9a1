// The names that named_view() (camera.h) takes, for help and error messages.
#pragma once

#include <string>

namespace citykiln::preview {

/// Returns all names in one text: view_names("|") is "street|low|overview|…". A scene may lack some of these views.
std::string view_names(const char* separator);

}  // namespace citykiln::preview
