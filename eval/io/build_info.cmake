# Writes OUTPUT, the source of build_info(), when the commit or its dirty flag has changed.
# Called at each build with SOURCE_DIR, OUTPUT, COMPILER, BUILD_TYPE, VERSION.
execute_process(COMMAND git -c safe.directory=* -C ${SOURCE_DIR} rev-parse HEAD
                OUTPUT_VARIABLE commit RESULT_VARIABLE failed ERROR_QUIET
                OUTPUT_STRIP_TRAILING_WHITESPACE)
if(failed)
  set(commit "unknown")
endif()
execute_process(COMMAND git -c safe.directory=* -C ${SOURCE_DIR} diff --quiet HEAD --
                RESULT_VARIABLE differs ERROR_QUIET OUTPUT_QUIET)
set(dirty "false")
if(differs)
  set(dirty "true")
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT [[
#include "eval/io/build_info.h"

namespace honka::eval {

BuildInfo build_info() {
  return {"@commit@", @dirty@, "@COMPILER@", "@BUILD_TYPE@", "@VERSION@"};
}

}  // namespace honka::eval
]] @ONLY)
