# cmake -D SOURCE=<dir> -P house_rules.cmake: checks the places of files (docs/architecture.md). A claim is found by its
# id, and public headers do not include private ones. The result of a law on random inputs is checked. The double-only
# part uses only the parts of std::ranges that the Explorer has.

cmake_minimum_required(VERSION 3.25)

set(wrong "")

# proofs_checks/claims/<place>/thm_03_outside_slope.{cpp,md}: "# thm-03-outside-slope: " and "Claim claim() {" in a
# namespace thm_03_outside_slope. A text that is a claim without a source says how it is decided.
set(count 0)
file(GLOB_RECURSE claims RELATIVE "${SOURCE}" "${SOURCE}/proofs_checks/claims/*")
if(NOT claims)
  message(FATAL_ERROR "no claim found under ${SOURCE}")
endif()
foreach(file IN LISTS claims)
  cmake_path(GET file STEM name)
  string(REPLACE "_" "-" id "${name}")
  if(NOT file MATCHES "^proofs_checks/claims/[a-z0-9_]+/[A-Za-z0-9_]+\\.(cpp|md)$")
    list(APPEND wrong "${file}: a claim is a source and a text in the folder of its place in the paper")
    continue()
  endif()
  file(READ "${SOURCE}/${file}" text)
  if(file MATCHES "\\.md$")
    string(REGEX REPLACE "md$" "cpp" other "${file}")
    string(FIND "${text}" "# ${id}: " found)
    math(EXPR count "${count} + 1")
    if(text MATCHES "\n(\\| decided about |\\*\\*(Convergence|Beyond calculation|Proof)\\.\\*\\* )")
      set(other "${file}")
    endif()
  else()
    string(REGEX REPLACE "cpp$" "md" other "${file}")
    string(FIND "${text}" "\nnamespace steadyslide::proofs_checks::${name} {\n" found)
    if(NOT text MATCHES "\nClaim claim\\(\\) {")
      set(found -1)
    endif()
  endif()
  if(found EQUAL -1)
    list(APPEND wrong "${file}: does not say ${id}")
  endif()
  if(NOT EXISTS "${SOURCE}/${other}")
    list(APPEND wrong "${file}: without ${other}")
  endif()
endforeach()

# If a public header does not exist, the list ends with an error.
include("${CMAKE_CURRENT_LIST_DIR}/../../cmake/PublicHeaders.cmake")
steadyslide_public_headers("${SOURCE}" public)
foreach(file IN LISTS public)
  if(NOT file MATCHES "^(model|numeric|symbolic|enclosure|proofs_checks)/|^library/answer/quantities[.]hpp$")
    list(APPEND wrong "${file}: a public header includes it, and it is not installed")
  endif()
endforeach()

# rc::check() returns true if the law holds. It does not fail the test itself.
file(GLOB_RECURSE tests RELATIVE "${SOURCE}" "${SOURCE}/tests/*_test.cpp")
foreach(file IN LISTS tests)
  file(STRINGS "${SOURCE}/${file}" dropped REGEX "^ *rc::check\\(")
  if(dropped)
    list(APPEND wrong "${file}: rc::check() without REQUIRE or CHECK")
  endif()
endforeach()

# The standard library of the Explorer's compiler has no std::ranges.
file(GLOB_RECURSE double_only RELATIVE "${SOURCE}" "${SOURCE}/model/*.?pp" "${SOURCE}/numeric/*.?pp"
     "${SOURCE}/library/problem_file/*.?pp")
foreach(file IN LISTS double_only)
  file(STRINGS "${SOURCE}/${file}" lines REGEX "std::ranges::")
  if(lines)
    list(APPEND wrong "${file}: std::ranges, which the Explorer's standard library does not have")
  endif()
endforeach()

# Comments are sentences: what a function returns, takes and throws. A newcomer stumbles over the rest.
set(first_words "What|Where|Whether|Is|Does|Of|Without")
set(phrases "is told|tells of|is asked for|is one all the same|whoever|asked of the|all the same[.,;]")
file(GLOB_RECURSE sources RELATIVE "${SOURCE}" LIST_DIRECTORIES false "${SOURCE}/*.?pp" "${SOURCE}/*.md" "${SOURCE}/app/help/*.txt")
foreach(file IN LISTS sources)
  if(file MATCHES "^(build/|CHANGELOG)")
    continue()
  endif()
  file(STRINGS "${SOURCE}/${file}" riddles REGEX "//(/<?)? (${first_words}) |(^|[^a-z])(${phrases})")
  foreach(line IN LISTS riddles)
    string(STRIP "${line}" line)
    list(APPEND wrong "${file}: in plain words, please: ${line}")
  endforeach()
endforeach()

if(wrong)
  list(JOIN wrong "\n" wrong)
  message(FATAL_ERROR "${wrong}")
endif()
message(STATUS "${count} claims in their places, all public headers there")
