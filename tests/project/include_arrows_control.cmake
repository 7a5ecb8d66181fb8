# cmake -D WORK=<dir> -P include_arrows_control.cmake: makes each wrong include, one at a time, and checks that it is
# caught. A correct include passes.

cmake_minimum_required(VERSION 3.25)

set(wrong
  "model/a.hpp" "#include \"numeric/number/real.hpp\""
  "model/a.cpp" "#  include <symbolic/field/expression.hpp>"
  "symbolic/a.cpp" "#include \"numeric/number/real.hpp\""
  "symbolic/a.hpp" "#include <ginac/ginac.h>"
  "numeric/a.cpp" "#include \"symbolic/field/expression.hpp\""
  "numeric/a.cpp" "#include \"../model/rational.hpp\""
  "numeric/a.cpp" "#include <cln/cln.h>"
  "enclosure/a.cpp" "#include \"numeric/number/real.hpp\""
  "enclosure/a.hpp" "#include \"symbolic/field/expression.hpp\""
  "numeric/a.cpp" "#include \"enclosure/number/ball.hpp\""
  "numeric/a.hpp" "#include \"proofs_checks/kit/claim.hpp\""
  "proofs_checks/claims/a.cpp" "#include \"app/table.hpp\""
  "proofs_checks/claims/a.cpp" "#include \"library/solve/method.hpp\""
  "library/a.cpp" "#include \"proofs_checks/kit/claim.hpp\""
  "library/a.hpp" "#include \"app/table.hpp\""
  "app/a.cpp" "#include <ginac/ginac.h>"
  "app/a.cpp" "#include \"tests/helpers.hpp\""
  "checker/a.cpp" "#include \"model/rational.hpp\""
  "checker/a.hpp" "#include \"enclosure/number/ball.hpp\""
  "app/a.cpp" "#include \"checker/ball.hpp\"")
set(right
  "model/a.cpp" "#include <numeric>"
  "model/a.hpp" "#include \"model/rational.hpp\""
  "symbolic/a.cpp" "#include <ginac/ginac.h>"
  "enclosure/a.cpp" "#include \"model/rational.hpp\""
  "proofs_checks/claims/a.cpp" "#include \"symbolic/field/expression.hpp\""
  "app/a.cpp" "#include \"proofs_checks/kit/claim.hpp\""
  "app/a.cpp" "#include \"library/solve/method.hpp\""
  "library/a.cpp" "#include \"numeric/number/real.hpp\""
  "checker/a.cpp" "#include \"checker/ball.hpp\"")

foreach(kind IN ITEMS wrong right)
  while(${kind})
    list(POP_FRONT ${kind} file line)
    file(REMOVE_RECURSE "${WORK}")
    file(WRITE "${WORK}/${file}" "${line}\n")
    execute_process(COMMAND "${CMAKE_COMMAND}" -D "SOURCE=${WORK}" -P "${CMAKE_CURRENT_LIST_DIR}/include_arrows.cmake"
                    RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
    if((kind STREQUAL "wrong" AND status EQUAL 0) OR (kind STREQUAL "right" AND NOT status EQUAL 0))
      message(FATAL_ERROR "${kind} include judged otherwise: ${file}: ${line}")
    endif()
  endwhile()
endforeach()
