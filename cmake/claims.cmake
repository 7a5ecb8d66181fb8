# cmake -D FOLDER=proofs_checks/claims -D OUTPUT=claim_list.cpp -P claims.cmake: writes the list that kit/registry.hpp
# declares, from the pairs NAME.cpp and NAME.md below FOLDER, and from the texts that are a claim without a source. Each
# claim has a namespace of its own, so that the sources can be compiled together.
file(GLOB_RECURSE texts RELATIVE "${FOLDER}" "${FOLDER}/*.md")
set(declarations "")
set(entries "")
foreach(text IN LISTS texts)
  cmake_path(GET text STEM name)
  cmake_path(GET text PARENT_PATH directory)
  string(REPLACE "_" "-" id "${name}")
  string(REPLACE "_" "-" group "${directory}")
  file(READ "${FOLDER}/${text}" document)
  if(EXISTS "${FOLDER}/${directory}/${name}.cpp")
    string(APPEND declarations "namespace ${name} {\nClaim claim();\n}\n")
  elseif(document MATCHES "\n(\\| |\\*\\*)(decided about|Convergence|Beyond calculation|Proof)( \\||\\.\\*\\* )")
    set("make_decided about" derived)
    set(make_Convergence convergence_claim)
    set("make_Beyond calculation" beyond_calculation)
    set(make_Proof words_alone)
    string(APPEND declarations "namespace ${name} {\nClaim claim() { return ${make_${CMAKE_MATCH_2}}(\"${id}\"); }\n}\n")
  else()
    message(FATAL_ERROR "${text}: no source beside it, and no part that would be a claim without")
  endif()
  string(APPEND entries "    {\"${id}\", \"${group}\", R\"claim(${document})claim\", ${name}::claim},\n")
endforeach()
file(WRITE "${OUTPUT}" "#include \"proofs_checks/instruments/convergence/convergence_claim.hpp\"
#include \"proofs_checks/instruments/identities/derived.hpp\"
#include \"proofs_checks/kit/registry.hpp\"

namespace steadyslide::proofs_checks {

${declarations}
std::span<const ClaimEntry> claim_list() {
  static const ClaimEntry all[]{
${entries}  };
  return all;
}

}  // namespace steadyslide::proofs_checks
")
