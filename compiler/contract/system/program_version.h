// The name and version of the program, as outputs state them. CMakeLists.txt decides the version: project(VERSION).
#pragma once

namespace citykiln {

extern const char* const kVersion;         ///< "0.1.0"
extern const char* const kProgramVersion;  ///< "citykiln 0.1.0"

}  // namespace citykiln
