// The C interface of the module that serves files over HTTP. It is loaded at run time, since only `view` needs it.
#pragma once

extern "C" {

/// A request: texts as the client sent them, the path with "%.." decoded and without "?…".
struct CitykilnRequest {
  const char* host;  ///< The header Host; empty without one.
  const char* path;  ///< "/page/page.json".
};

/// The answer to a request. Texts are copied.
struct CitykilnAnswer {
  int status;        ///< 200 sends the file.
  const char* file;  ///< The file to send; null for other statuses.
  const char* type;  ///< Its media type.
};

/// Decides on an answer; may be called from several threads at once.
typedef struct CitykilnAnswer (*CitykilnDecide)(void* owner, const struct CitykilnRequest* request);
/// Called once, when the server listens.
typedef void (*CitykilnListens)(void* owner, int port);

/// Answers GET and HEAD on 127.0.0.1 until the process ends. Returns 1 if the port cannot be used.
/// @param port  0: any free port.
int citykiln_serve(int port, void* owner, CitykilnDecide decide, CitykilnListens listens);
}
