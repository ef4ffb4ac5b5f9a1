#include "compiler/contract/system/program_version.h"

namespace citykiln {

const char* const kVersion = CITYKILN_VERSION;
const char* const kProgramVersion = "citykiln " CITYKILN_VERSION;

}  // namespace citykiln
