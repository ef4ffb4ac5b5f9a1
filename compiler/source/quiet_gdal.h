// GDAL prints what goes wrong; citykiln says it in its own one line.
#pragma once

#include <cpl_error.h>

#include <string>

namespace citykiln::source {

/// Silences GDAL in this thread for as long as it lives.
class QuietGdal {
 public:
  QuietGdal() {
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLErrorReset();
  }
  ~QuietGdal() { CPLPopErrorHandler(); }
  QuietGdal(const QuietGdal&) = delete;
  QuietGdal& operator=(const QuietGdal&) = delete;

  /// GDAL's words on what went wrong last, in one line.
  std::string last_message() const {
    std::string message = CPLGetLastErrorMsg();
    for (char& letter : message) {
      if (letter == '\n' || letter == '\r') letter = ' ';
    }
    return message;
  }
};

}  // namespace citykiln::source
