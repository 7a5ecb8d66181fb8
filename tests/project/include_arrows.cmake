# cmake -D SOURCE=<dir> -P include_arrows.cmake: checks the allowed includes between layers (docs/architecture.md).
#
#   model  <-  symbolic | numeric | enclosure  <-  library | proofs_checks  <-  app
#   checker, alone: it includes none of them, and none includes it

cmake_minimum_required(VERSION 3.25)

set(may_include_model model)
set(may_include_symbolic model symbolic)
set(may_include_numeric model numeric)
set(may_include_enclosure model enclosure)
set(may_include_library model symbolic numeric enclosure library)
set(may_include_proofs_checks model symbolic numeric enclosure proofs_checks)
set(may_include_app model symbolic numeric enclosure library proofs_checks app)
set(may_include_checker checker)
set(may_include_bindings/explorer model numeric library)
set(layers model symbolic numeric enclosure library proofs_checks app checker bindings/explorer)

# ginac.h and CLN's headers cost a second for each file and define macros. Only sources of these layers and these
# headers include them; built_with.cpp uses only their versions.
set(algebra_in_sources_of symbolic proofs_checks)
set(algebra_headers app/report/built_with.cpp symbolic/cln/cln_number.hpp symbolic/coq/coq_equation.hpp symbolic/local/coupling.hpp symbolic/field/expression.hpp symbolic/field/field_linear.hpp
    symbolic/local/local_action.hpp symbolic/local/local_form.hpp symbolic/statements/local_form_check.hpp
    symbolic/local/local_place.hpp symbolic/field/phase_field.hpp
    symbolic/statements/polynomial_families.hpp symbolic/local/polynomial_slope.hpp symbolic/field/rational_function.hpp
    symbolic/field/written_identity.hpp symbolic/statements/written_expression.hpp
    symbolic/statements/written_functions.hpp symbolic/statements/written_statements.hpp)

set(wrong "")
set(count 0)
foreach(layer IN LISTS layers)
  file(GLOB_RECURSE files RELATIVE "${SOURCE}" "${SOURCE}/${layer}/*.hpp" "${SOURCE}/${layer}/*.cpp")
  foreach(file IN LISTS files)
    math(EXPR count "${count} + 1")
    file(STRINGS "${SOURCE}/${file}" lines REGEX "^[ \t]*#[ \t]*include")
    foreach(line IN LISTS lines)
      if(NOT line MATCHES "include[ \t]*[<\"]([^>\"]+)[>\"]")
        list(APPEND wrong "${file}: unreadable: ${line}")
        continue()
      endif()
      set(header "${CMAKE_MATCH_1}")
      set(folder "")
      if(header MATCHES "^([^/]+)/")
        set(folder "${CMAKE_MATCH_1}")
      endif()
      if(header MATCHES "(^|/)\\.\\.(/|$)")
        list(APPEND wrong "${file} includes ${header}: headers are named from the root")
      elseif(folder STREQUAL "tests" OR (folder IN_LIST layers AND NOT folder IN_LIST may_include_${layer}))
        list(APPEND wrong "${file} includes ${header}: ${layer} does not include ${folder}")
      elseif(folder MATCHES "^(ginac|cln)$" AND NOT file IN_LIST algebra_headers
             AND NOT (layer IN_LIST algebra_in_sources_of AND file MATCHES "\\.cpp$"))
        list(APPEND wrong "${file} includes ${header}: GiNaC and CLN stay in sources and in the headers declared here")
      endif()
    endforeach()
  endforeach()
endforeach()

if(count EQUAL 0)
  message(FATAL_ERROR "no file found under ${SOURCE}")
endif()
if(wrong)
  list(JOIN wrong "\n" wrong)
  message(FATAL_ERROR "${wrong}")
endif()
message(STATUS "${count} files, no arrow reversed")
