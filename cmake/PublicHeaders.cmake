# steadyslide_public_headers(<source> <variable>): sets the variable to the headers of cmake/public_headers.txt and to
# all headers outside of model/ that they include.
cmake_policy(VERSION 3.25)

function(steadyslide_public_headers source variable)
  file(STRINGS "${source}/cmake/public_headers.txt" open REGEX "^[a-z]")
  set(headers "")
  while(open)
    list(POP_FRONT open header)
    if(NOT header IN_LIST headers)
      list(APPEND headers "${header}")
      file(STRINGS "${source}/${header}" includes REGEX "^#include \"")
      list(TRANSFORM includes REPLACE "^#include \"([^\"]+)\".*" "\\1")
      list(FILTER includes EXCLUDE REGEX "^model/")
      list(APPEND open ${includes})
    endif()
  endwhile()
  set(${variable} ${headers} PARENT_SCOPE)
endfunction()
