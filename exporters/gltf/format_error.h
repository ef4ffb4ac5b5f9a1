// What readers throw where a .glb is not one that citykiln writes.
#pragma once

#include <string>

namespace citykiln::exporters {

/// The first fault of a file, as "expected …"; decode_glb() turns it into an Error.
struct FormatError {
  std::string what;
};

/// Throws unless the condition holds. @param what  Completes "expected …".
inline void expect(bool holds, const char* what) {
  if (!holds) throw FormatError{what};
}

}  // namespace citykiln::exporters
