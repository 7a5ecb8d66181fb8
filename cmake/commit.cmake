cmake_minimum_required(VERSION 3.25)
# cmake -D SOURCE=... -D OUTPUT=... -P commit.cmake: writes a source with the commit from which the program is built. It
# is empty outside of a checkout, and ends with "-dirty" if tracked files have changed.
execute_process(COMMAND git -c safe.directory=* -C "${SOURCE}" describe --always --dirty --abbrev=12 --exclude=*
                OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed OR NOT EXISTS "${SOURCE}/.git")
  set(commit "")
endif()
file(CONFIGURE OUTPUT "${OUTPUT}" @ONLY CONTENT "#include <string>

namespace steadyslide::app {

std::string commit() { return \"@commit@\"; }

}  // namespace steadyslide::app
")
