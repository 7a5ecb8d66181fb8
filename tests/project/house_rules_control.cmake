# cmake -D WORK=<dir> -P house_rules_control.cmake: every broken rule is caught, one at a time, and a tree that keeps them
# all is not.

cmake_minimum_required(VERSION 3.25)

set(place "proofs_checks/claims/remarks")
set(control_of_text "${place}/rem_01_neglect.md" "# rem-01-other\n")
set(in "\nnamespace steadyslide::proofs_checks")
set(control_of_name "${place}/rem_01_neglect.cpp" "${in}::neglect {\nClaim claim() {\n")
set(control_of_function "${place}/rem_01_neglect.cpp" "${in}::rem_01_neglect {\nClaim neglect() {\n")
set(control_alone "${place}/rem_02.cpp" "${in}::rem_02 {\nClaim claim() {\n")
set(control_text "${place}/rem_03.md" "# rem-03\n")
set(control_header "${place}/shared.hpp" "#pragma once\n")
set(control_private "numeric/public.hpp" "#include \"numeric/private.hpp\"\n")
set(control_missing "cmake/public_headers.txt" "numeric/none.hpp\n")

foreach(control IN ITEMS none of_text of_name of_function alone text header private missing)
  file(REMOVE_RECURSE "${WORK}")
  file(WRITE "${WORK}/${place}/rem_01_neglect.md" "# rem-01-neglect\n")
  file(WRITE "${WORK}/${place}/rem_01_neglect.cpp" "${in}::rem_01_neglect {\nClaim claim() {\n")
  file(WRITE "${WORK}/${place}/rem_04_derived.md" "# rem-04-derived\n\n## Decided\n")
  file(WRITE "${WORK}/cmake/public_headers.txt" "# all\nnumeric/public.hpp\n")
  file(WRITE "${WORK}/numeric/public.hpp" "#include \"model/rational.hpp\"\n")
  if(NOT control STREQUAL "none")
    list(GET control_${control} 0 file)
    list(GET control_${control} 1 text)
    file(WRITE "${WORK}/${file}" "${text}")
  endif()
  execute_process(COMMAND "${CMAKE_COMMAND}" -D "SOURCE=${WORK}" -P "${CMAKE_CURRENT_LIST_DIR}/house_rules.cmake"
                  RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
  if((control STREQUAL "none" AND NOT status EQUAL 0) OR (NOT control STREQUAL "none" AND status EQUAL 0))
    message(FATAL_ERROR "judged otherwise: ${control}")
  endif()
endforeach()
