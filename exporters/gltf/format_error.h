// The exception of readers for a .glb that citykiln does not write.
#pragma once

#include <string>

namespace citykiln::exporters {

/// The first fault of a file, in words that complete "expected …". decode_glb() turns it into an Error.
struct FormatError {
  std::string what;
};

/// Throws FormatError unless the condition holds.
///
/// @param what  Completes "expected …".
inline void expect(bool holds, const char* what) {
  if (!holds) throw FormatError{what};
}

}  // namespace citykiln::exporters
