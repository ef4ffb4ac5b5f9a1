// Suppresses GDAL's own error output; citykiln reports GDAL's messages as errors.
#pragma once

#include <cpl_error.h>

#include <string>

namespace citykiln::source::gdal {

/// Suppresses GDAL's messages in this thread during its lifetime.
class QuietGdal {
 public:
  QuietGdal() {
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLErrorReset();
  }
  ~QuietGdal() { CPLPopErrorHandler(); }
  QuietGdal(const QuietGdal&) = delete;
  QuietGdal& operator=(const QuietGdal&) = delete;

  /// Returns GDAL's last error message as one line.
  std::string last_message() const {
    std::string message = CPLGetLastErrorMsg();
    for (char& letter : message) {
      if (letter == '\n' || letter == '\r') letter = ' ';
    }
    return message;
  }
};

}  // namespace citykiln::source::gdal
