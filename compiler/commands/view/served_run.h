// Decides which requests of a browser the server of `view` answers.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "exporters/file_list.h"

namespace citykiln::commands {

/// The files of a run that are served: those that files.json lists, and files.json.
class ServedRun {
 public:
  ServedRun(std::string folder, const exporters::FileList& files);

  /// The answer to a request.
  struct Answer {
    int status = 404;       ///< 200, 403 for another host or a path with "..", 404 for a file that is not listed.
    const char* file = "";  ///< The path of the file to send; lives as long as this object.
    const char* type = "";  ///< Its media type.
  };

  /// @param host  The header Host: "127.0.0.1:PORT" or "localhost:PORT" name this machine.
  /// @param path  Decoded, such as "/page/page.json"; "/" is index.html.
  /// @param port  The port of the server.
  Answer answer(std::string_view host, std::string_view path, int port) const;

 private:
  std::map<std::string, std::string, std::less<>> files_;  ///< By name in the run: the path.
};

/// Returns the media type by the ending of a name.
const char* media_type_of(std::string_view name);

}  // namespace citykiln::commands
